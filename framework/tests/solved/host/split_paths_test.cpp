// Several paths for each camera ray: the same picture as with one, with less noise and fewer rays.
#include "film/compare.h"
#include "host/session.h"
#include "solved/support/solutions.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

namespace pathmark::test {
namespace {

// Chance of one comparison of two images with noise to fail a right one.
constexpr double kFalseFail = 1e-6;
constexpr std::uint32_t kReplicates = 16;

struct Wish {
  std::string scene;
  std::uint32_t pathsPerRay = 1;
  bool sharesDirectLight = false;
  std::string paths{};  // empty: all light
  SamplerKind sampler = SamplerKind::kSobol;
  std::uint64_t rays = 16;
  int maxBounces = -1;
  std::uint64_t seed = 1;
  std::uint32_t threads = 2;
};

RenderOutcome outcomeOf(const Wish& wish) {
  SceneOverrides overrides;
  overrides.size = {24, 24};
  if (wish.maxBounces >= 0) overrides.maxBounces = wish.maxBounces;
  RenderOptions options;
  options.raysPerPixel = wish.rays * kReplicates;
  options.replicates = kReplicates;
  options.seed = wish.seed;
  options.threads = wish.threads;
  options.sampler = wish.sampler;
  if (wish.pathsPerRay > 1) options.estimator = Estimator::kSplit;
  options.pathsPerRay = wish.pathsPerRay;
  options.sharesDirectLight = wish.sharesDirectLight;
  if (!wish.paths.empty()) options.paths = PathExpression(wish.paths);
  return renderScene(solutions(), loadScene(findScene(wish.scene), overrides), options);
}

void expectSameAsOnePath(const Wish& split) {
  Wish plain = split;
  plain.pathsPerRay = 1;
  plain.sharesDirectLight = false;
  plain.seed = split.seed + 1;
  plain.rays = 4 * split.rays;
  CompareSettings settings;
  settings.alpha = kFalseFail;
  const Image a = outcomeOf(split).rendered.image, b = outcomeOf(plain).rendered.image;
  const Comparison comparison = compareImages(a, b, {kReplicates, kReplicates}, settings);
  std::string means;
  for (const RegionResult& r : comparison.whole)
    means += fmt::format("{} +- {} and {} +- {}\n", r.a, r.errorA, r.b, r.errorB);
  EXPECT_TRUE(comparison.judged);
  EXPECT_TRUE(comparison.same) << split.scene << ":\n" << means;
}

class SplitPaths : public testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(SplitPaths, GiveThePictureOfOnePathARay) {
  const auto [scene, sharesDirectLight] = GetParam();
  expectSameAsOnePath({.scene = scene, .pathsPerRay = 4, .sharesDirectLight = sharesDirectLight});
}

INSTANTIATE_TEST_SUITE_P(Scenes, SplitPaths,
                         testing::Combine(testing::Values("cornell_box", "cornell_spheres",
                                                          "cornell_phong", "many_lights",
                                                          "ucl_sphere", "empty_furnace"),
                                          testing::Bool()),
                         [](const auto& p) {
                           return std::string(std::get<0>(p.param)) +
                                  (std::get<1>(p.param) ? "_sharing_direct_light" : "");
                         });

TEST(SplitPaths, HaveNoMoreBouncesThanOthers) {
  for (const int bounces : {0, 1, 2})
    for (const bool shares : {false, true})
      expectSameAsOnePath({.scene = "cornell_box",
                           .pathsPerRay = 3,
                           .sharesDirectLight = shares,
                           .maxBounces = bounces});
}

TEST(SplitPaths, GoWithEverySampler) {
  for (const SamplerKind sampler : {SamplerKind::kPcg, SamplerKind::kStratified})
    for (const bool shares : {false, true})
      expectSameAsOnePath({.scene = "cornell_box",
                           .pathsPerRay = 4,
                           .sharesDirectLight = shares,
                           .sampler = sampler});
}

TEST(SplitPaths, GoWithLightPathExpressions) {
  for (const char* paths : {"LDE", "LD+SE", "L..+E"})
    for (const bool shares : {false, true})
      expectSameAsOnePath({.scene = "cornell_phong",
                           .pathsPerRay = 4,
                           .sharesDirectLight = shares,
                           .paths = paths});
}

TEST(SplitPaths, AreTheSameBitsForAnyNumberOfThreads) {
  for (const bool shares : {false, true}) {
    Wish wish{.scene = "cornell_phong", .pathsPerRay = 4, .sharesDirectLight = shares, .rays = 2};
    const Image two = outcomeOf(wish).rendered.image;
    wish.threads = 1;
    EXPECT_EQ(outcomeOf(wish).rendered.image.rgb, two.rgb);
  }
}

TEST(SplitPaths, ShareTheirCameraRay) {
  const auto rays = [](std::uint32_t pathsPerRay, bool shares) {
    return outcomeOf({.scene = "cornell_box",
                      .pathsPerRay = pathsPerRay,
                      .sharesDirectLight = shares,
                      .rays = 2})
        .rendered.raysTraced;
  };
  const auto cameraRays = std::uint64_t{24} * 24 * 2 * kReplicates;
  const std::uint64_t one = rays(1, false), four = rays(4, false), sharing = rays(4, true);
  EXPECT_NEAR(double(four), double(4 * one - 3 * cameraRays), 0.02 * double(four));
  EXPECT_LT(sharing, four - 2 * cameraRays);
}

// In indirect light: at the edge of the light, a pixel's noise is that of its camera rays.
TEST(SplitPaths, HaveLessNoise) {
  const auto noise = [](std::uint32_t pathsPerRay, bool shares) {
    const Image image = outcomeOf({.scene = "cornell_box",
                                   .pathsPerRay = pathsPerRay,
                                   .sharesDirectLight = shares,
                                   .paths = "L..+E"})
                            .rendered.image;
    double sum = 0.0;
    for (const float variance : image.variance) sum += double{variance};
    return sum;
  };
  const double one = noise(1, false);
  for (const bool shares : {false, true}) {
    const double four = noise(4, shares);
    EXPECT_LT(four, one / 2.5) << one / four << " times less";
  }
}

}  // namespace
}  // namespace pathmark::test
