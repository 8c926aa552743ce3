// Pictures made to a stated error: that the rule which decides on the number of rays makes them
// neither darker nor brighter, and that they reach the error.
#include "host/adaptive_render.h"
#include "support/test_coursework_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pathmark::test {
namespace {

// A tile whose pixels are noisy, and in which a ray in ten thousand is very bright: the pilot of a
// half, 8,192 rays, has seen none of them in almost half of all cases.
constexpr double kBright = 1e-4, kBrightness = 1000.0;
constexpr double kTruth = 0.5 + kBright * kBrightness;
constexpr std::size_t kPixels = kTileSize * kTileSize;
constexpr std::uint64_t kPilot = 16;
constexpr TargetError kTarget{.relative = 0.1, .raysPerPass = 16, .mostRays = 512};

class TileFilm {
 public:
  explicit TileFilm(std::mt19937_64& random) : random_(random), film_(kPixels) {}

  void addRays(std::uint64_t rays) {
    std::binomial_distribution<std::int64_t> base(static_cast<std::int64_t>(rays), 0.5),
        bright(static_cast<std::int64_t>(rays), kBright);
    for (FilmPixel& pixel : film_) {
      const double sum =
          static_cast<double>(base(random_)) + kBrightness * static_cast<double>(bright(random_));
      for (double& s : pixel.sum) s += sum;
      pixel.rays += static_cast<double>(rays);
    }
  }

  std::span<const FilmPixel> pixels() const { return film_; }
  std::uint64_t rays() const { return static_cast<std::uint64_t>(film_[0].rays); }
  double mean() const {
    double sum = 0.0;
    for (const FilmPixel& pixel : film_) sum += pixel.sum[0] / pixel.rays;
    return sum / kPixels;
  }

 private:
  std::mt19937_64& random_;
  std::vector<FilmPixel> film_;
};

std::uint64_t wantedAfter(const TileFilm& a, const TileFilm& b) {
  return raysForTarget({kTileSize, kTileSize, a.pixels(), b.pixels(), a.rays()}, kTarget)[0];
}

// Stops as soon as what it has seems to be enough.
double naiveMean(std::mt19937_64& random) {
  TileFilm a(random), b(random);
  do {
    a.addRays(kPilot);
    b.addRays(kPilot);
  } while (a.rays() < kTarget.mostRays && wantedAfter(a, b) > a.rays());
  return 0.5 * (a.mean() + b.mean());
}

double meanOfHalves(std::mt19937_64& random) {
  std::vector<TileFilm> films(4, TileFilm(random));
  for (TileFilm& film : films) film.addRays(kPilot);
  const std::uint64_t byFirst = wantedAfter(films[0], films[1]),
                      bySecond = wantedAfter(films[2], films[3]);
  for (std::size_t k = 0; k < 4; ++k)
    if (const std::uint64_t rays = k < 2 ? bySecond : byFirst; rays > kPilot)
      films[k].addRays(rays - kPilot);
  return (films[0].mean() + films[1].mean() + films[2].mean() + films[3].mean()) / 4.0;
}

// In standard errors, of so many tiles.
template <class Mean>
double biasOf(Mean mean) {
  constexpr int kTiles = 800;
  std::mt19937_64 random(20240317);
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < kTiles; ++k) {
    const double x = mean(random);
    sum += x;
    squares += x * x;
  }
  const double average = sum / kTiles;
  const double variance = (squares / kTiles - average * average) / (kTiles - 1);
  return (average - kTruth) / std::sqrt(variance);
}

// Five standard errors: a right rule fails once in a million seeds, and this is one seed.
TEST(AdaptiveRule, HalvesThatDecideForEachOtherHaveNoBias) {
  EXPECT_LT(std::abs(biasOf(meanOfHalves)), 5.0);
}

TEST(AdaptiveRule, StoppingByTheSamplesThemselvesIsTooDark) { EXPECT_LT(biasOf(naiveMean), -5.0); }

TEST(AdaptiveRule, AsksForRaysInProportionToTheVariance) {
  std::vector<FilmPixel> a(2 * kPixels), b(2 * kPixels);
  // The left tile's films are 1 -+ 0.1, the right one's 1 -+ 0.2.
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double off = i % (2 * kTileSize) < kTileSize ? 0.1 : 0.2;
    a[i] = {{16.0 * (1.0 - off), 16.0 * (1.0 - off), 16.0 * (1.0 - off)}, 16.0};
    b[i] = {{16.0 * (1.0 + off), 16.0 * (1.0 + off), 16.0 * (1.0 + off)}, 16.0};
  }
  const TargetError target{.relative = 0.01, .raysPerPass = 16, .mostRays = 1 << 20};
  const auto rays = raysForTarget({2 * kTileSize, kTileSize, a, b, 16}, target);
  // A film's variance is 0.02, that of the mean of four 0.005: 50 times too much.
  EXPECT_EQ(rays, (std::vector<std::uint64_t>{800, 3200}));
  const auto few = raysForTarget({2 * kTileSize, kTileSize, a, b, 16},
                                 {.relative = 0.01, .raysPerPass = 16, .mostRays = 1000});
  EXPECT_EQ(few, (std::vector<std::uint64_t>{800, 992}));
  const auto pilot = raysForTarget({2 * kTileSize, kTileSize, a, b, 16},
                                   {.relative = 1.0, .raysPerPass = 16, .mostRays = 1000});
  EXPECT_EQ(pilot, (std::vector<std::uint64_t>{16, 16}));
}

TEST(AdaptiveRule, BlackTilesNeedNoMoreThanThePilot) {
  const std::vector<FilmPixel> black(kPixels, FilmPixel{{0, 0, 0}, 16.0});
  EXPECT_EQ(raysForTarget({kTileSize, kTileSize, black, black, 16}, kTarget)[0], 16u);
}

// The left half of the picture is even, the right one's rays are 0 or 2.
class AdaptivePictures : public testing::Test {
 protected:
  AdaptivePictures() {
    coursework_.setTracePath(
        "return ray.direction.x < 0.0f ? Colour(1.0f)\n"
        "                              : Colour(sampler.next1D() < 0.5f ? 0.0f : 2.0f);");
  }

  AdaptivePicture render(double error, std::uint32_t threads, std::uint64_t most = 16384) {
    const auto worker = coursework_.start();
    FlatScene scene = emptyScene(kWidth, kHeight);
    scene.camera.eye = {};
    scene.camera.topLeft = {-kWidth / 2.0f, kHeight / 2.0f, -40.0f};
    scene.camera.pixelRight = {1.0f, 0.0f, 0.0f};
    scene.camera.pixelDown = {0.0f, -1.0f, 0.0f};
    worker->loadScene(scene);
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.raysPerPixel = most;
    settings.threads = threads;
    settings.sampler = SamplerKind::kPcg;
    AdaptiveRender render(*worker, settings, error);
    render.run([](const RenderStatus&) { return true; });
    return render.picture();
  }

  static constexpr int kWidth = 64, kHeight = 40;
  TestCoursework coursework_;
};

TEST_F(AdaptivePictures, NoisyTilesGetTheRaysThatTheErrorNeeds) {
  const AdaptivePicture picture = render(0.05, 2);
  ASSERT_TRUE(picture.rendered.complete);
  // A ray's variance is 1: 400 rays for 5 %. The estimate of a tile's variance from 256 pixels of a
  // pilot half is off by 9 %.
  EXPECT_EQ(picture.raysPerPixel[0], 64.0f);
  EXPECT_NEAR(picture.raysPerPixel[kWidth - 1], 400.0f, 150.0f);
  ASSERT_FALSE(picture.errors.relative.empty());
  EXPECT_EQ(picture.errors.relative[0], 0.0);
  EXPECT_NEAR(picture.errors.worst(), 0.05, 0.015);
  EXPECT_EQ(picture.tilesAtMost, 0u);
  double sum = 0.0;
  for (const float value : picture.rendered.image.rgb) sum += static_cast<double>(value);
  // 1,280 noisy pixels of about 400 rays: a standard error of 7e-4 of half of the picture.
  EXPECT_NEAR(sum / static_cast<double>(picture.rendered.image.rgb.size()), 1.0, 2.5e-3);
}

TEST_F(AdaptivePictures, HaveTheSameBitsForAnyNumberOfThreads) {
  const AdaptivePicture one = render(0.05, 1);
  for (const std::uint32_t threads : {2u, 5u}) {
    const AdaptivePicture other = render(0.05, threads);
    EXPECT_EQ(other.rendered.image.rgb, one.rendered.image.rgb);
    EXPECT_EQ(other.rendered.image.variance, one.rendered.image.variance);
    EXPECT_EQ(other.raysPerPixel, one.raysPerPixel);
  }
}

TEST_F(AdaptivePictures, StopAtTheMostRaysAndSaySo) {
  const AdaptivePicture picture = render(0.001, 2, 256);
  EXPECT_EQ(picture.raysPerPixel[kWidth - 1], 256.0f);
  EXPECT_EQ(picture.tilesAtMost, 6u) << "the right half";
}

// The pilot is the most that is allowed here, and 100 % is reached with it.
TEST_F(AdaptivePictures, TilesThatHaveWhatTheyNeedDoNotCountAsTooFew) {
  const AdaptivePicture picture = render(1.0, 2, 64);
  EXPECT_EQ(picture.raysPerPixel[kWidth - 1], 64.0f);
  EXPECT_LT(picture.errors.worst(), 1.0);
  EXPECT_EQ(picture.tilesAtMost, 0u);
}

TEST_F(AdaptivePictures, CanBeEndedEarly) {
  const auto worker = coursework_.start();
  worker->loadScene(emptyScene(kWidth, kHeight));
  RenderSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.raysPerPixel = 1 << 20;
  AdaptiveRender render(*worker, settings, 1e-4);
  int calls = 0;
  render.run([&](const RenderStatus&) { return ++calls < 5; });
  EXPECT_FALSE(render.picture().rendered.complete);
}

}  // namespace
}  // namespace pathmark::test
