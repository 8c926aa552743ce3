// Several paths for each camera ray: the same picture as with one, with less noise and fewer rays.
#include "solved/support/noisy_render.h"
#include "solved/support/other_tracers.h"

#include <gtest/gtest.h>

#include <tuple>

namespace pathmark::test {
namespace {

NoisyRender split(const char* scene, std::uint32_t pathsPerRay, bool sharesDirectLight) {
  NoisyRender wish{.scene = scene, .estimator = Estimator::kSplit};
  wish.sharing.pathsPerRay = pathsPerRay;
  wish.sharing.directLight = sharesDirectLight ? 1 : 0;
  return wish;
}

class SplitPaths : public testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(SplitPaths, GiveThePictureOfOnePathARay) {
  const auto [scene, sharesDirectLight] = GetParam();
  expectSameAsTracePath(split(scene, 4, sharesDirectLight));
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
    for (const bool shares : {false, true}) {
      NoisyRender wish = split("cornell_box", 3, shares);
      wish.maxBounces = bounces;
      expectSameAsTracePath(wish);
    }
}

TEST(SplitPaths, GoWithEverySampler) {
  for (const SamplerKind sampler : {SamplerKind::kPcg, SamplerKind::kStratified})
    for (const bool shares : {false, true}) {
      NoisyRender wish = split("cornell_box", 4, shares);
      wish.sampler = sampler;
      expectSameAsTracePath(wish);
    }
}

TEST(SplitPaths, GoWithEveryWayOfFindingDirectLight) {
  const TemporaryFolder folder;
  for (const char* tracePath : {kDirectLightLast, kLightsByChance}) {
    const Coursework coursework = solutionsWith(tracePath, folder.path());
    for (const bool shares : {false, true}) {
      SCOPED_TRACE(shares);
      NoisyRender wish = split("cornell_box", 4, shares);
      wish.coursework = &coursework;
      expectSameAsTracePath(wish);
    }
  }
}

TEST(SplitPaths, GoWithLightPathExpressions) {
  for (const char* paths : {"LDE", "LD+SE", "L..+E"})
    for (const bool shares : {false, true}) {
      NoisyRender wish = split("cornell_phong", 4, shares);
      wish.paths = paths;
      expectSameAsTracePath(wish);
    }
}

TEST(SplitPaths, AreTheSameBitsForAnyNumberOfThreads) {
  for (const bool shares : {false, true}) {
    NoisyRender wish = split("cornell_phong", 4, shares);
    wish.rays = 2;
    const Image two = rendered(wish).image;
    wish.threads = 1;
    EXPECT_EQ(rendered(wish).image.rgb, two.rgb);
  }
}

TEST(SplitPaths, ShareTheirCameraRay) {
  const auto rays = [](std::uint32_t pathsPerRay, bool shares) {
    NoisyRender wish = split("cornell_box", pathsPerRay, shares);
    wish.rays = 2;
    return rendered(wish).raysTraced;
  };
  const auto cameraRays = std::uint64_t{24} * 24 * 2 * NoisyRender{}.replicates;
  const std::uint64_t one = rays(1, false), four = rays(4, false), sharing = rays(4, true);
  EXPECT_NEAR(double(four), double(4 * one - 3 * cameraRays), 0.02 * double(four));
  EXPECT_LT(sharing, four - 2 * cameraRays);
}

// In indirect light: at the edge of the light, a pixel's noise is that of its camera rays.
TEST(SplitPaths, HaveLessNoise) {
  NoisyRender one{.scene = "cornell_box", .paths = "L..+E"};
  const double noise = noiseOf(one);
  for (const bool shares : {false, true}) {
    NoisyRender four = split("cornell_box", 4, shares);
    four.paths = one.paths;
    const double less = noiseOf(four);
    EXPECT_LT(less, noise / 2.5) << noise / less << " times less";
  }
}

}  // namespace
}  // namespace pathmark::test
