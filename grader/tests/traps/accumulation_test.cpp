// Sums of many samples: a float sum stops growing, its bits depend on the order, and denormal
// numbers depend on the thread's mode.
#include "render/render_tiles.h"
#include "sampling/pcg_sampler.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_rooms.h"
#include "tests/traps/trap.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <limits>
#include <memory>
#include <thread>

namespace pathmark {
namespace {

using namespace testing;

using Film = std::vector<FilmPixel>;

Film emptyFilm(const TestScene& scene) {
  const SimpleCamera& camera = scene.core().camera();
  return Film(static_cast<std::size_t>(camera.width() * camera.height()));
}

void render(
    const TestScene& scene, const RenderJob& job, Film& film,
    const std::function<void()>& onThreadStart = [] {}) {
  const auto board = std::make_unique<ProgressBoard>();
  renderTiles(scene.core(), job, film, *board, onThreadStart);
}

RenderJob wholeImage(const TestScene& scene) {
  RenderJob job;
  job.seed = 7;
  job.region = {0, 0, scene.core().camera().width(), scene.core().camera().height()};
  return job;
}

// The inside of a sphere that shines: every ray brings the same.
TestScene evenLight(float radiance) {
  SceneBuilder builder;
  builder.sphere({.emission = Colour(radiance)}, {0, 0, 0}, 2.0f, true);
  builder.camera({0, 0, 0}, {0, 0, -1}, 1.0, 1, 1);
  return TestScene(builder);
}

TEST(Trap, SumOfAMillionRaysKeepsItsDigits) {
  constexpr int kRays = 1 << 20;
  constexpr float kRadiance = 0.1f;
  float naive = 0.0f;
  for (int m = 0; m < kRays; ++m) naive += kRadiance;
  const TestScene scene = evenLight(kRadiance);
  PcgSampler sampler(1);
  sampler.startPixel(0, 0, 0);
  const Colour mean = scene.lit(0).renderPixel(0, 0, scene.core().camera(), kRays, sampler);
  expectTrap("mean of 2^20 rays, roundoffs",
             relativeError(double{naive} / kRays, kRadiance) / kRoundoff,
             relativeError(mean.x, kRadiance) / kRoundoff, 1.0);
}

// A film that holds 2^24 rays already.
TEST(Trap, SumGrowsBeyondTheLargestIntegersOfFloat) {
  constexpr double kBefore = 0x1p24;
  constexpr std::uint64_t kMore = 1024;
  auto naive = static_cast<float>(kBefore);
  for (std::uint64_t pass = 0; pass < kMore; ++pass) naive += 1.0f;
  const TestScene scene = evenLight(1.0f);
  Film film(1);
  film[0] = {{kBefore, kBefore, kBefore}, kBefore};
  RenderJob job = wholeImage(scene);
  job.firstRay = 1u << 24;
  job.rays = kMore;
  render(scene, job, film);
  EXPECT_EQ(film[0].rays, kBefore + kMore);
  expectTrap("growth by 1024 passes, relative error", 1.0 - (double{naive} - kBefore) / kMore,
             std::abs(1.0 - (film[0].sum[0] - kBefore) / kMore), 1e-6);
}

bool sameBits(const Film& a, const Film& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

// Naive: passes are added in float, as they come in.
TEST(Trap, ImageHasTheSameBitsForAnyOrderOfTilesAndThreads) {
  constexpr std::uint64_t kPasses = 12;
  SceneBuilder builder = unevenRoom();
  builder.camera({1.0f, 0.75f, 4.5f}, {1.0f, 0.7f, 0.0f}, 0.55, 37, 33);
  const TestScene scene(builder);
  RenderJob job = wholeImage(scene);
  std::vector<Film> passes;
  for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
    passes.push_back(emptyFilm(scene));
    job.firstRay = pass;
    render(scene, job, passes.back());
  }
  int naiveDifferent = 0;
  for (std::size_t pixel = 0; pixel < passes[0].size(); ++pixel) {
    float forwards = 0.0f, backwards = 0.0f;
    for (std::size_t k = 0; k < kPasses; ++k) {
      forwards += static_cast<float>(passes[k][pixel].sum[0]);
      backwards += static_cast<float>(passes[kPasses - 1 - k][pixel].sum[0]);
    }
    naiveDifferent += forwards == backwards ? 0 : 1;
  }

  job.firstRay = 0;
  job.rays = kPasses;
  Film whole = emptyFilm(scene);
  render(scene, job, whole);
  int shippedDifferent = 0;
  for (const std::uint32_t threads : {2u, 3u, 8u}) {
    job.threads = threads;
    Film film = emptyFilm(scene);
    render(scene, job, film);
    shippedDifferent += sameBits(film, whole) ? 0 : 1;
  }
  // Tiles of 9 x 8 pixels in three orders, on two threads.
  job.threads = 2;
  for (const std::uint64_t order : {1u, 2u, 3u}) {
    std::vector<PixelRegion> tiles;
    for (int top = 0; top < 33; top += 8)
      for (int left = 0; left < 37; left += 9) tiles.push_back({left, top, 9, 8});
    Uniforms random(order);
    for (std::size_t k = tiles.size(); k > 1; --k)
      std::swap(tiles[k - 1], tiles[random.bits() % k]);
    Film film = emptyFilm(scene);
    for (const PixelRegion& tile : tiles) {
      job.region = tile;
      render(scene, job, film);
    }
    shippedDifferent += sameBits(film, whole) ? 0 : 1;
  }
  expectTrap("pixels of the naive film, or pictures, that differ", naiveDifferent, shippedDifferent,
             0.0);
}

bool keepsDenormals() {
  volatile float x = std::numeric_limits<float>::min();
  x = x * 0.5f;
  return x > 0.0f;
}

#if defined(__SSE__)
TEST(Trap, RenderThreadsFlushDenormals) {
  bool plainThreadKeeps = false;
  std::thread([&] { plainThreadKeeps = keepsDenormals(); }).join();
  std::atomic<int> started{0}, keeping{0};
  const TestScene scene = evenLight(1.0f);
  RenderJob job = wholeImage(scene);
  job.threads = 4;
  Film film(1);
  render(scene, job, film, [&] {
    ++started;
    keeping += keepsDenormals() ? 1 : 0;
  });
  EXPECT_EQ(started, 4);
  expectTrap("threads that keep denormal numbers", plainThreadKeeps ? 1.0 : 0.0, keeping, 0.0);
}
#endif

// Naive: a path without roulette, into the denormal numbers and on to a bright light.
TEST(Trap, ImageDoesNotDependOnDenormals) {
  const auto naive = [] {
    volatile float throughput = 1.0f;
    for (int bounce = 0; bounce < 130; ++bounce) throughput = throughput * 0.5f;
    return throughput * 1e38f;
  };
  const TestScene scene(unevenRoom());
  const auto shipped = [&] {
    std::vector<Colour> image;
    PcgSampler sampler(3);
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 12; ++i) {
        sampler.startPixel(i, j, 0);
        image.push_back(scene.lit(1000).renderPixel(i, j, scene.core().camera(), 64, sampler));
      }
    }
    return image;
  };
  float naiveValue[2] = {0.0f, 0.0f};
  std::vector<Colour> images[2];
  for (const bool flush : {false, true}) {
    const FlushDenormals mode(flush);
    naiveValue[flush ? 1 : 0] = naive();
    images[flush ? 1 : 0] = shipped();
  }
  int different = 0;
  for (std::size_t k = 0; k < images[0].size(); ++k)
    different += images[0][k] == images[1][k] ? 0 : 1;
#if defined(__SSE__)
  expectTrap("values that differ", naiveValue[0] == naiveValue[1] ? 0.0 : 1.0, different, 0.0);
#endif
}

}  // namespace
}  // namespace pathmark
