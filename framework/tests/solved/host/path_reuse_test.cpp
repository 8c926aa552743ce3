// Pixels that share their paths: the same picture as with paths of their own, with less noise.
#include "solved/support/noisy_render.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

NoisyRender reuse(const char* scene, std::uint32_t pixels) {
  NoisyRender wish{.scene = scene, .estimator = Estimator::kReuse};
  wish.sharing.pixels = pixels;
  return wish;
}

class PathReuse : public testing::TestWithParam<const char*> {};

TEST_P(PathReuse, GivesThePictureOfTracePath) {
  for (const std::uint32_t pixels : {4u, 16u}) expectSameAsTracePath(reuse(GetParam(), pixels));
}

// Then they look at everything that is there, and see it or not.
TEST_P(PathReuse, GivesThePictureOfTracePathIfAllPixelsShareAsWell) {
  NoisyRender wish = reuse(GetParam(), 64);
  wish.width = wish.height = 8;
  wish.replicates = 256;
  expectSameInEveryPixel(wish);
}

// Among them surfaces that shine, first and later ones, spheres from inside and outside, backs, and
// light that paths alone find.
INSTANTIATE_TEST_SUITE_P(Scenes, PathReuse,
                         testing::Values("cornell_box", "cornell_spheres", "cornell_phong",
                                         "many_lights", "ucl_sphere", "ucl_triangle",
                                         "veach_plates", "diy_caustic", "furnace", "empty_furnace"),
                         [](const auto& p) { return std::string(p.param); });

// Every size of a block, in pictures that no block fits into.
TEST(PathReuse, GoesWithEverySizeOfBlocksAndPictures) {
  for (std::uint32_t pixels = 2; pixels <= PathSharing::kMost; pixels *= 2) {
    NoisyRender wish = reuse("cornell_box", pixels);
    wish.width = 21;
    wish.height = 19;
    expectSameAsTracePath(wish);
  }
}

TEST(PathReuse, HasNoMoreBouncesThanOthers) {
  for (const int bounces : {0, 1, 2, 3}) {
    NoisyRender wish = reuse("cornell_box", 8);
    wish.maxBounces = bounces;
    expectSameAsTracePath(wish);
  }
}

TEST(PathReuse, GoesWithEverySamplerAndWayToSampleLights) {
  for (const SamplerKind sampler :
       {SamplerKind::kSobol, SamplerKind::kPcg, SamplerKind::kStratified})
    for (const bool bySolidAngle : {false, true}) {
      NoisyRender wish = reuse("cornell_box", 8);
      wish.sampler = sampler;
      wish.bySolidAngle = bySolidAngle;
      expectSameAsTracePath(wish);
    }
}

TEST(PathReuse, MayHaveSeveralPathsForDirectLight) {
  NoisyRender wish = reuse("cornell_box", 8);
  wish.sharing.directPaths = 4;
  expectSameAsTracePath(wish);
}

// A pass is 64 rays: the second and a part of the third.
TEST(PathReuse, GoesOverSeveralPasses) {
  NoisyRender wish = reuse("cornell_box", 4);
  wish.rays = 64 + 64 + 7;
  wish.sharing.directPaths = 2;
  expectSameAsTracePath(wish);
}

// And the same rays: blocks that the picture's edge cuts off have nothing from the block before.
TEST(PathReuse, IsTheSameBitsForAnyNumberOfThreads) {
  NoisyRender wish = reuse("many_lights", 16);
  wish.rays = 3;
  wish.height = 17;  // one row of the last tiles
  const RenderedImage two = rendered(wish);
  wish.threads = 1;
  const RenderedImage one = rendered(wish);
  EXPECT_EQ(one.image.rgb, two.image.rgb);
  EXPECT_EQ(one.raysTraced, two.raysTraced);
}

// Without indirect light there is nothing to share.
TEST(PathReuse, HasLessNoiseWhereLightIsIndirect) {
  NoisyRender one{.scene = "cornell_box", .maxBounces = 1, .width = 32, .height = 32};
  const double direct = noiseOf(one);
  one.maxBounces = -1;
  const double noise = noiseOf(one) - direct;
  for (const auto& [pixels, times] : {std::pair{4u, 2.5}, {16u, 6.0}}) {
    NoisyRender shared = reuse("cornell_box", pixels);
    shared.width = shared.height = 32;
    const double less = noiseOf(shared) - direct;
    EXPECT_LT(less, noise / times) << pixels << " pixels: " << noise / less << " times less";
  }
}

TEST(PathReuse, DirectPathsTakeTheNoiseOfDirectLight) {
  NoisyRender one{.scene = "cornell_box", .maxBounces = 1, .width = 32, .height = 32};
  NoisyRender four = one;
  four.estimator = Estimator::kReuse;
  four.sharing.directPaths = 4;
  const double noise = noiseOf(one), less = noiseOf(four);
  EXPECT_LT(less, noise) << noise / less << " times less";
}

}  // namespace
}  // namespace pathmark::test
