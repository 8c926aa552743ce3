// What the numbers of a path add up to, and what is said if they do not.
#include "preview/paths/path_account.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pathmark::preview {
namespace {

// A floor that is lit from above, and a wall that the path goes on to, at 60 degrees: all numbers
// fit one another.
class PathOfTwo : public testing::Test {
 protected:
  PathOfTwo() {
    PathVertex floor;
    floor.origin = {0.0f, 1.0f, 0.0f};
    floor.n = {0.0f, 1.0f, 0.0f};
    floor.material = 0;
    // Le f G / pdf = 8 * 0.25 * (1 * 1 / 4) / 0.5
    floor.shadowRays = {{{0.0f, 2.0f, 0.0f},
                         {0.0f, -1.0f, 0.0f},
                         0.5f,
                         Colour(8.0f),
                         Visibility::kVisible,
                         {},
                         Colour(0.25f)}};
    floor.direct = Colour(1.0f);
    floor.next = Scattering{{0.8660254f, 0.5f, 0.0f}, 0.2f, 0.5f, Colour(0.3f, 0.2f, 0.1f)};
    floor.roulette = RouletteCall{Colour(0.75f, 0.5f, 0.25f), 1, 0.5f, true, 2.0f};
    PathVertex wall;
    wall.origin = floor.p;
    wall.p = {0.8660254f, 0.5f, 0.0f};
    wall.n = {-1.0f, 0.0f, 0.0f};
    wall.material = 0;
    wall.direct = Colour(0.1f);
    wall.next = Scattering{{-1.0f, 0.0f, 0.0f}, 0.3f, 1.0f, Colour(0.15f)};
    wall.roulette = RouletteCall{Colour(0.75f, 0.5f, 0.25f), 2, 0.9f, false, 0.0f};
    path_.vertices = {floor, wall};
    path_.radiance = Colour(1.0f) + Colour(1.5f, 1.0f, 0.5f) * 0.1f;
  }

  // The only sentence about the path.
  std::string remark(const AccountRules& rules = {}) const {
    const PathAccount account = accountFor(path_, rules);
    EXPECT_EQ(account.remarks.size(), 1u);
    return account.remarks.empty() ? "" : account.remarks[0];
  }

  void expectRemark(const std::string& part) const {
    const std::string all = remark();
    EXPECT_NE(all.find(part), std::string::npos) << all;
  }

  PathVertex& floor() { return path_.vertices[0]; }
  PathVertex& wall() { return path_.vertices[1]; }

  TracedPath path_;
};

TEST_F(PathOfTwo, AddsUp) {
  const PathAccount account = accountFor(path_, {});
  EXPECT_TRUE(account.fits);
  EXPECT_TRUE(account.remarks.empty()) << account.remarks[0];
  EXPECT_EQ(account.vertices[1].throughput, Colour(1.5f, 1.0f, 0.5f));
  EXPECT_TRUE(account.vertices[1].own);
  EXPECT_EQ(account.vertices[0].shadowRays.at(0), Colour(1.0f));
}

TEST_F(PathOfTwo, MultipliesUpWhereTheCourseworkDoesNotSay) {
  floor().roulette.reset();
  path_.radiance = Colour(1.0f) + Colour(0.75f, 0.5f, 0.25f) * 0.1f;
  wall().roulette->throughput = Colour(0.375f, 0.25f, 0.125f);
  const PathAccount account = accountFor(path_, {});
  EXPECT_TRUE(account.remarks.empty()) << account.remarks[0];
  EXPECT_FALSE(account.vertices[1].own);
}

TEST_F(PathOfTwo, SeesThatTheCosineIsLost) {
  floor().roulette->throughput *= 2.0f;
  wall().roulette->throughput *= 2.0f;
  path_.radiance = Colour(1.0f) + Colour(3.0f, 2.0f, 1.0f) * 0.1f;
  expectRemark("Is the cosine missing?");
  EXPECT_FALSE(accountFor(path_, {}).vertices[0].stepFits);
  EXPECT_TRUE(accountFor(path_, {}).vertices[1].stepFits) << "one mistake is told once";
}

TEST_F(PathOfTwo, SeesThatTheDensityIsLost) {
  floor().roulette->throughput *= 0.2f;
  wall().roulette->throughput *= 0.2f;
  path_.radiance = Colour(1.0f) + Colour(0.3f, 0.2f, 0.1f) * 0.1f;
  expectRemark("Is the division by the density missing?");
}

TEST_F(PathOfTwo, SeesThatTheRoulettesWeightIsLost) {
  wall().roulette->throughput *= 0.5f;
  path_.radiance = Colour(1.0f) + Colour(0.75f, 0.5f, 0.25f) * 0.1f;
  const PathAccount account = accountFor(path_, {});
  ASSERT_EQ(account.remarks.size(), 2u);
  EXPECT_NE(account.remarks[0].find("roulette's weight of the vertex before missing"),
            std::string::npos)
      << account.remarks[0];
  EXPECT_FALSE(account.fits);
}

TEST_F(PathOfTwo, SeesThatEmissionIsCountedTwice) {
  wall().emission = Colour(5.0f);
  path_.radiance += Colour(1.5f, 1.0f, 0.5f) * 5.0f;
  expectRemark("what vertex 2 emits");
}

TEST_F(PathOfTwo, SeesThatLightSeenDirectlyIsMissing) {
  floor().emission = Colour(5.0f);
  expectRemark("What vertex 1 emits towards the camera is missing");
  path_.radiance += Colour(5.0f);
  EXPECT_TRUE(accountFor(path_, {}).remarks.empty());
}

TEST_F(PathOfTwo, TakesNoEmissionFromABack) {
  floor().emission = Colour(5.0f);
  floor().n *= -1.0f;
  floor().shadowRays.clear();
  EXPECT_TRUE(accountFor(path_, {}).remarks.empty());
}

TEST_F(PathOfTwo, SeesThatDirectLightIsMissing) {
  path_.radiance = Colour(1.0f);
  expectRemark("The direct light of vertex 2 is missing");
}

TEST_F(PathOfTwo, SeesThatDirectLightIsNotMultiplied) {
  path_.radiance = Colour(1.1f);
  expectRemark("Direct light has not been multiplied by the throughput");
}

TEST_F(PathOfTwo, SeesThatDirectLightingIsNotWhatItsShadowRaysSay) {
  floor().direct = Colour(4.0f);
  path_.radiance += Colour(3.0f);
  expectRemark("directLighting returned 4, but Le f G V / pdf of its shadow rays adds up to 1");
  EXPECT_TRUE(accountFor(path_, {false, 2}).remarks.empty()) << "one of two lights may be chosen";
}

TEST_F(PathOfTwo, CountsNothingOfALightThatIsBlocked) {
  floor().shadowRays[0].visibility = Visibility::kBlocked;
  expectRemark("shadow rays adds up to 0");
}

TEST_F(PathOfTwo, OfTheWarmUpAddsWhatEachVertexEmits) {
  for (PathVertex& vertex : path_.vertices) {
    vertex.direct.reset();
    vertex.roulette.reset();
    vertex.shadowRays.clear();
    vertex.emission = Colour(2.0f);
  }
  path_.radiance = Colour(2.0f) + Colour(0.75f, 0.5f, 0.25f) * 2.0f;
  EXPECT_TRUE(accountFor(path_, {true, 1}).remarks.empty());
  path_.radiance *= 2.0f;
  EXPECT_FALSE(accountFor(path_, {true, 1}).fits);
}

TEST_F(PathOfTwo, SaysOfNumbersThatAreNoneThatTheyDoNotFit) {
  path_.radiance.g = std::numeric_limits<float>::quiet_NaN();
  expectRemark("The path returned 1.15 nan 1.05");
  floor().roulette->throughput = Colour(std::numeric_limits<float>::infinity());
  EXPECT_FALSE(accountFor(path_, {}).vertices[0].stepFits);
}

TEST_F(PathOfTwo, OfWhichTheEndIsLeftOutIsNotJudged) {
  path_.radiance = Colour(100.0f);
  path_.dropped = 5;
  expectRemark("5 calls at its end are left out");
}

// The same floor as part 8 sees it: the lamp is sampled by the path itself, and the path goes on to
// a second face of it. Densities per unit solid angle: of the sample 0.5 * 2^2 / 1 = 2, of the face
// that is met 0.5 * 1^2 / 0.866.
class PathOfPart8 : public PathOfTwo {
 protected:
  PathOfPart8() {
    floor().direct.reset();
    floor().shadowRays[0].brdfPdf = 1.0f;
    wall().direct.reset();
    wall().next.reset();
    wall().roulette.reset();
    wall().emission = Colour(8.0f);
    wall().lightPdf = 0.5f;
    path_.radiance = Colour(kSampled) + kThroughput * 8.0f * kMet;
  }

  const AccountRules rules_{.mis = true};
  const Colour kThroughput{1.5f, 1.0f, 0.5f};
  static constexpr float kSampled = 4.0f / (4.0f + 1.0f);       // weight; unweighted it is 1
  static constexpr float kMet = 0.04f / (0.04f + 1.0f / 3.0f);  // weight
};

TEST_F(PathOfPart8, AddsUpByTheWeightsOfThePowerHeuristic) {
  const PathAccount account = accountFor(path_, rules_);
  EXPECT_TRUE(account.known && account.fits);
  EXPECT_TRUE(account.remarks.empty()) << account.remarks[0];
  ASSERT_TRUE(account.vertices[0].weights.at(0));
  EXPECT_NEAR(*account.vertices[0].weights[0], kSampled, 1e-6);
  ASSERT_TRUE(account.vertices[1].emissionWeight);
  EXPECT_NEAR(*account.vertices[1].emissionWeight, kMet, 1e-6);
  EXPECT_NEAR(account.vertices[1].emission.r, 1.5f * 8.0f * kMet, 1e-5);
}

TEST_F(PathOfPart8, SeesWhatHasNotBeenWeighted) {
  path_.radiance = Colour(kSampled) + kThroughput * 8.0f;
  EXPECT_NE(remark(rules_).find("What vertex 2 emits has not been weighted."), std::string::npos);
  path_.radiance = Colour(1.0f) + kThroughput * 8.0f * kMet;
  EXPECT_NE(remark(rules_).find("Light samples have not been weighted."), std::string::npos);
  path_.radiance = Colour(kSampled);
  EXPECT_NE(remark(rules_).find("What vertex 2 emits is missing."), std::string::npos);
}

TEST_F(PathOfPart8, SeesThatADensityHasNotBeenAskedFor) {
  wall().lightPdf.reset();
  EXPECT_EQ(remark(rules_).find("Vertex 2: Light::pdf()"), 0u);
  wall().lightPdf = 0.5f;
  floor().shadowRays[0].brdfPdf.reset();
  EXPECT_EQ(remark(rules_).find("Vertex 1: the BRDF's pdf()"), 0u);
}

TEST_F(PathOfPart8, IsNotJudgedWhereOneOfSeveralLightsWasChosen) {
  AccountRules two = rules_;
  two.lights = 2;
  path_.radiance *= 3.0f;
  const PathAccount account = accountFor(path_, two);
  EXPECT_FALSE(account.known);
  EXPECT_TRUE(account.remarks.empty()) << account.remarks[0];
}

TEST_F(PathOfPart8, WhatTheCameraSeesCountsFully) {
  floor().emission = Colour(5.0f);
  path_.radiance += Colour(5.0f);
  EXPECT_TRUE(accountFor(path_, rules_).remarks.empty());
}

}  // namespace
}  // namespace pathmark::preview
