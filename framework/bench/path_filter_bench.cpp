// What it costs a render without a light path expression that there could be one: rays through
// LitScene, which looks whether there is a filter, and counts them, against the same rays without
// either. Paths of diffuse bounces in the Cornell box, with a shadow ray from each surface.
//
//   pathmark_benchmarks --benchmark_filter=followPaths --benchmark_repetitions=15
//     --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true
#include "bench/random_direction.h"
#include "bench/ray_scenes.h"
#include "render/scene_core.h"

#include <benchmark/benchmark.h>

namespace pathmark::bench {
namespace {

struct Bare {
  explicit Bare(const SceneCore& scene) : core(scene) {}
  bool intersect(const Ray& ray, Hit& hit) const { return core.intersect(ray, hit); }
  bool visible(const Hit& from, const LightSample& to) const { return core.visible(from, to); }
  const SceneCore& core;
};

struct Looking : LitScene {
  explicit Looking(const SceneCore& scene) : LitScene(scene, scene.maxBounces()) {}
};

LightSample pointOf(const Lamp& lamp, QuickRandom& random) {
  LightSample sample;
  sample.p = lamp.corner + random.next() * lamp.side + random.next() * lamp.otherSide;
  sample.n = Vector(0.0f, -1.0f, 0.0f);
  sample.pdf = 1.0f / length(cross(lamp.side, lamp.otherSide));
  return sample;
}

template <class Scene>
void followPaths(benchmark::State& state) {
  const RayScene cornell = cornellBox();
  const SceneCore core(viewOf(cornell.flat));
  const Scene scene(core);
  QuickRandom random(1);
  std::int64_t rays = 0, lit = 0;
  for (auto _ : state) {
    Ray ray{core.camera().eye(),
            normalize(Vector(0.0f, 0.0f, 1.0f) + 0.3f * randomDirection(random))};
    Hit hit;
    for (int bounce = 0; bounce < 8; ++bounce) {
      ++rays;
      if (!scene.intersect(ray, hit)) break;
      ++rays;
      lit += scene.visible(hit, pointOf(cornell.lamp, random)) ? 1 : 0;
      const Vector n = dot(hit.n, ray.direction) > 0.0f ? -hit.n : hit.n;
      ray = hit.spawnRay(normalize(n + 0.9999f * randomDirection(random)));
    }
  }
  benchmark::DoNotOptimize(lit);
  state.SetItemsProcessed(rays);
  state.counters["lit"] = benchmark::Counter(static_cast<double>(lit) / static_cast<double>(rays));
}

BENCHMARK(followPaths<Bare>);
BENCHMARK(followPaths<Looking>);

}  // namespace
}  // namespace pathmark::bench
