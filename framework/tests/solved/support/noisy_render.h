// Small renders of the solutions whose noise is known, for comparing one way of rendering with
// another.
#pragma once

#include "film/compare.h"
#include "host/session.h"
#include "solved/support/solutions.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace pathmark::test {

struct NoisyRender {
  std::string scene;
  Estimator estimator = Estimator::kPath;
  PathSharing sharing{};
  std::string paths{};  // empty: all light
  SamplerKind sampler = SamplerKind::kSobol;
  bool bySolidAngle = false;
  std::uint32_t replicates = 16;
  std::uint64_t rays = 16;  // of each replicate
  int maxBounces = -1;      // -1: the scene's
  int width = 24, height = 24;
  std::uint64_t seed = 1;
  std::uint32_t threads = 2;
  const Coursework* coursework = nullptr;  // none: the solutions
};

inline RenderedImage rendered(const NoisyRender& wish) {
  SceneOverrides overrides;
  overrides.size = {wish.width, wish.height};
  if (wish.maxBounces >= 0) overrides.maxBounces = wish.maxBounces;
  LoadedScene scene = loadScene(findScene(wish.scene), overrides);
  if (wish.bySolidAngle) scene.flat.lightSampling = LightSampling::kBySolidAngle;
  RenderOptions options;
  options.raysPerPixel = wish.rays * wish.replicates;
  options.replicates = wish.replicates;
  options.seed = wish.seed;
  options.threads = wish.threads;
  options.sampler = wish.sampler;
  options.estimator = wish.estimator;
  options.sharing = wish.sharing;
  if (!wish.paths.empty()) options.paths = PathExpression(wish.paths);
  return renderScene(wish.coursework ? *wish.coursework : solutions(), scene, options).rendered;
}

// Chance of one comparison to fail what is right.
inline constexpr double kFalseFail = 1e-6;

// Of tracePath, with numbers of its own and so many times the rays.
inline Image byTracePath(const NoisyRender& wish, std::uint64_t timesTheRays) {
  NoisyRender plain = wish;
  plain.estimator = Estimator::kPath;
  plain.sharing = {};
  plain.coursework = nullptr;
  plain.seed = wish.seed + 1;
  plain.rays = timesTheRays * wish.rays;
  return rendered(plain).image;
}

inline void expectSameAsTracePath(const NoisyRender& wish) {
  const Replicates replicates{wish.replicates, wish.replicates, wish.sharing.pixels, 1};
  const Comparison comparison =
      compareImages(rendered(wish).image, byTracePath(wish, 4), replicates, {.alpha = kFalseFail});
  std::string means;
  for (const RegionResult& r : comparison.whole)
    means += fmt::format("{} +- {} and {} +- {}\n", r.a, r.errorA, r.b, r.errorB);
  EXPECT_TRUE(comparison.judged);
  EXPECT_TRUE(comparison.same) << wish.scene << ":\n" << means;
}

// Each pixel for itself, whatever its error has to do with those of others. A pixel alone tells
// little of its variance: for many replicates.
inline void expectSameInEveryPixel(const NoisyRender& wish) {
  const Comparison comparison =
      compareImages(rendered(wish).image, byTracePath(wish, 1), {wish.replicates, wish.replicates},
                    {.tile = 1, .alpha = kFalseFail});
  ASSERT_TRUE(comparison.judged);
  for (const RegionResult& r : comparison.tiles)
    EXPECT_FALSE(r.differs) << wish.scene << ", column " << r.region.left << ", row "
                            << r.region.top << ", channel " << r.channel << ": " << r.a << " +- "
                            << r.errorA << " and " << r.b << " +- " << r.errorB;
}

// The sum of all pixels' variances.
inline double noiseOf(const NoisyRender& wish) {
  const Image image = rendered(wish).image;
  double sum = 0.0;
  for (const float variance : image.variance) sum += double{variance};
  return sum;
}

}  // namespace pathmark::test
