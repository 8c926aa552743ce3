// How many rays per second get their numbers, by sampler: one pair for the place on the film, then
// at each vertex of the path a pair for a point on a light, a pair for a direction, a single for
// the lobe and one for Russian roulette. Passes of 64 rays, one for each pixel.
#include "sampling/pixel_sampler.h"

#include <benchmark/benchmark.h>

namespace pathmark {
namespace {

void samplePaths(benchmark::State& state, SamplerKind kind) {
  constexpr std::uint32_t kRaysPerPass = 64;
  const auto vertices = static_cast<int>(state.range(0));
  const auto sampler = makePixelSampler(kind, 1, kRaysPerPass);
  // One sum for each use, so that additions do not wait for one another.
  vec2 film(0.0f), light(0.0f), direction(0.0f);
  float lobe = 0.0f, roulette = 0.0f;
  int pixel = 0;
  for (auto _ : state) {
    sampler->startPixel(pixel++ & 1023, 0, 0);
    for (std::uint32_t ray = 0; ray < kRaysPerPass; ++ray) {
      sampler->startRay(static_cast<int>(ray));
      film += sampler->next2D();
      for (int vertex = 0; vertex < vertices; ++vertex) {
        light += sampler->next2D();
        direction += sampler->next2D();
        lobe += sampler->next1D();
        roulette += sampler->next1D();
      }
    }
  }
  benchmark::DoNotOptimize(film);
  benchmark::DoNotOptimize(light);
  benchmark::DoNotOptimize(direction);
  benchmark::DoNotOptimize(lobe);
  benchmark::DoNotOptimize(roulette);
  state.SetItemsProcessed(state.iterations() * kRaysPerPass);
}

void vertices(benchmark::internal::Benchmark* b) {
  for (const int n : {1, 3, 7}) b->Arg(n)->ArgName("vertices");
}

BENCHMARK_CAPTURE(samplePaths, pcg, SamplerKind::kPcg)->Apply(vertices);
BENCHMARK_CAPTURE(samplePaths, sobol, SamplerKind::kSobol)->Apply(vertices);
BENCHMARK_CAPTURE(samplePaths, stratified, SamplerKind::kStratified)->Apply(vertices);

}  // namespace
}  // namespace pathmark
