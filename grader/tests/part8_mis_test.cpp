// Part 8: weights, densities of directions, and the path tracer against part 5's.
#include "checks/seen_light.h"
#include "sampling/pcg_sampler.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_rooms.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <limits>

namespace pathmark {
namespace {

using namespace testing;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(PowerHeuristic, IsTheShareOfTheSquare) {
  Uniforms random(81);
  for (int k = 0; k < 10000; ++k) {
    const auto a = static_cast<float>(std::pow(10.0, 60.0 * random.nextDouble() - 30.0));
    const auto b = static_cast<float>(a * std::pow(10.0, 6.0 * random.nextDouble() - 3.0));
    const long double a2 = static_cast<long double>(a) * static_cast<long double>(a),
                      b2 = static_cast<long double>(b) * static_cast<long double>(b);
    EXPECT_TRUE(isClose(powerHeuristic(a, b), a2 / (a2 + b2), 4.0 * kRoundoff));
    EXPECT_TRUE(isClose(powerHeuristic(a, b) + powerHeuristic(b, a), 1.0L, 2.0 * kRoundoff));
  }
}

TEST(PowerHeuristic, HasTheLimitsOfItsFormula) {
  EXPECT_EQ(powerHeuristic(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(powerHeuristic(0.0f, kInfinity), 0.0f);
  EXPECT_EQ(powerHeuristic(1.0f, 0.0f), 1.0f);
  EXPECT_EQ(powerHeuristic(kInfinity, 1.0f), 1.0f);
  EXPECT_EQ(powerHeuristic(1.0f, kInfinity), 0.0f);
  EXPECT_EQ(powerHeuristic(kInfinity, kInfinity), 0.5f);
  EXPECT_EQ(powerHeuristic(3e38f, 3e38f), 0.5f);
}

TEST(SolidAnglePdf, OfASphereSampledBySolidAngleIsOneOverIt) {
  const Sphere sphere({1, 2, 3}, 0.5f);
  Uniforms random(82);
  for (const double distance : {0.7, 3.0, 100.0}) {
    const Point from = sphere.centre() + static_cast<float>(distance) * randomUnit(random);
    const long double sine = 0.5L / static_cast<long double>(length(from - sphere.centre()));
    const long double omega = 2.0L * std::numbers::pi_v<long double> * sine * sine /
                              (1.0L + std::sqrt((1.0L - sine) * (1.0L + sine)));
    for (int k = 0; k < 100; ++k) {
      const float s = random.next(), t = random.next();
      if (s > 0.99f) continue;  // at the limb, the cosine is that of a rounded point
      EXPECT_TRUE(isClose(solidAnglePdf(from, sphere.sample(from, s, t)), 1.0L / omega,
                          3e-6 * distance / 0.5 + 1e-4));
    }
  }
}

TEST(SolidAnglePdf, IsZeroWhereTheFrontIsNotSeen) {
  const LightSample y{{1, 2, 3}, {0, -1, 0}, 2.0f};
  EXPECT_GT(solidAnglePdf({0, 0, 0}, y), 0.0f);
  EXPECT_EQ(solidAnglePdf({0, 3, 0}, y), 0.0f);
  EXPECT_EQ(solidAnglePdf({7, 2, 0}, y), 0.0f);
  EXPECT_EQ(solidAnglePdf(y.p, y), 0.0f);
  EXPECT_EQ(solidAnglePdf({0, 0, 0}, {y.p, y.n, 0.0f}), 0.0f);
}

// A hit of the light where a sample of it is.
Hit hitAt(const Light& light, const LightSample& y) {
  Hit hit;
  hit.p = y.p;
  hit.n = y.n;
  hit.light = &light;
  return hit;
}

SceneBuilder allKindsOfLights() {
  const Surface surface{.emission = Colour(1, 2, 3)};
  SceneBuilder builder;
  builder.polygon(surface, {{0, 3, 0}, {1, 3, 0}, {0, 3, 1}});
  builder.parallelogram(surface, {0, 4, 0}, {1, 0, 0}, {0, 0, 2});
  builder.parallelogram(surface, {0, 5, 0}, {1, 0, 0}, {0.5f, 0, 2});
  builder.polygon(surface, {{0, 6, 0}, {2, 6, 0}, {3, 6, 1}, {2, 6, 2}, {0, 6, 1}});
  builder.sphere(surface, {3, 3, 3}, 0.5f);
  builder.sphere(surface, {0, 0, 0}, 20.0f, true);
  return builder;
}

class LightPdf : public ::testing::TestWithParam<LightSampling> {};

TEST_P(LightPdf, IsTheDensityOfTheLightsSamples) {
  FlatScene flat = allKindsOfLights().flat();
  flat.lightSampling = GetParam();
  const TestScene scene(std::move(flat));
  Uniforms random(83);
  for (const Light& light : scene.core().lights())
    for (int k = 0; k < 200; ++k) {
      const Point from = 8.0f * Vector(random.next(), random.next(), random.next());
      const LightSample y = light.sample(from, random.next(), random.next());
      if (y.pdf == 0.0f) continue;
      EXPECT_TRUE(isClose(light.pdf(from, hitAt(light, y)), static_cast<long double>(y.pdf), 1e-5));
    }
}

INSTANTIATE_TEST_SUITE_P(Samplings, LightPdf,
                         ::testing::Values(LightSampling::kByArea, LightSampling::kBySolidAngle));

TEST(HitOfALight, KnowsTheLight) {
  const TestScene scene(unevenRoom());
  const LitScene lit = scene.lit(4);
  Uniforms random(84);
  int lights = 0;
  for (int k = 0; k < 2000; ++k) {
    Hit hit;
    if (!lit.intersect({{1, 0.7f, 1.5f}, randomUnit(random)}, hit)) continue;
    EXPECT_EQ(hit.light != nullptr, hit.emission != Colour(0.0f));
    if (hit.light == nullptr) continue;
    ++lights;
    EXPECT_EQ(hit.light->emission(), hit.emission);
  }
  EXPECT_GT(lights, 100);
}

struct Radiance {
  stats::RunningMoments channel[3];
};

Radiance trace(const TestScene& scene, int bounces, int paths, bool mis) {
  const LitScene lit = scene.lit(bounces);
  PcgSampler sampler(mis ? 85 : 86);
  sampler.startPixel(0, 0, 0);
  Uniforms random(mis ? 87 : 88);
  Radiance radiance;
  for (int m = 0; m < paths; ++m) {
    sampler.startRay(m);
    const Ray ray{{1, 0.75f, 2.0f}, randomUnit(random)};
    const Colour l = mis ? lit.tracePathMIS(ray, sampler) : lit.tracePath(ray, sampler);
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isfinite(l[c]) && l[c] >= 0.0f);
      radiance.channel[c].add(double{l[c]});
    }
  }
  return radiance;
}

TEST(TracePathMis, HasTheMeanOfTracePath) {
  for (const LightSampling lights : {LightSampling::kByArea, LightSampling::kBySolidAngle})
    for (const int bounces : {0, 1, 2, 8}) {
      SCOPED_TRACE(::testing::Message() << bounces << " bounces");
      FlatScene flat = unevenRoom().flat();
      flat.lightSampling = lights;
      const TestScene scene(std::move(flat));
      const Radiance mis = trace(scene, bounces, 60000, true),
                     path = trace(scene, bounces, 60000, false);
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(meansAgree(mis.channel[c], path.channel[c], {.alpha = kAlpha}));
    }
}

TEST(TracePathMis, ChoosesAmongManyLightsWithoutBias) {
  SceneBuilder builder = unevenRoom();
  for (int k = 0; k < 5; ++k)
    builder.parallelogram({.emission = Colour(1.0f + static_cast<float>(k))},
                          {0.2f + 0.3f * static_cast<float>(k), 1.3f, 2.2f}, {0.2f, 0, 0},
                          {0, 0, 0.3f});
  const TestScene scene(builder);
  const Radiance mis = trace(scene, 3, 60000, true), path = trace(scene, 3, 60000, false);
  for (int c = 0; c < 3; ++c)
    EXPECT_TRUE(meansAgree(mis.channel[c], path.channel[c], {.alpha = kAlpha}));
}

TEST(TracePathMis, InAFurnaceIsAGeometricSeries) {
  const TestScene scene(furnace());
  for (const int bounces : {0, 1, 2, 8}) {
    SCOPED_TRACE(::testing::Message() << bounces << " bounces");
    const LitScene lit = scene.lit(bounces);
    PcgSampler sampler(89);
    sampler.startPixel(0, 0, 0);
    Uniforms random(90);
    stats::RunningMoments mean;
    for (int m = 0; m < 40000; ++m) {
      sampler.startRay(m);
      mean.add(double{lit.tracePathMIS({{-1, 0.5f, 0.3f}, randomUnit(random)}, sampler).x});
    }
    EXPECT_TRUE(
        meanIs(mean, 1.0 - std::ldexp(1.0, -(bounces + 1)), {.alpha = kAlpha, .tolerance = 1e-5}));
  }
}

// A glossy floor before a large light, where either way alone is bad somewhere.
TEST(TracePathMis, IsLessNoisyThanLightSamplesAloneBeforeAMirrorLikeFloor) {
  SceneBuilder builder;
  builder.parallelogram({.ks = Colour(0.9f), .exponent = 2000.0f}, {-2, 0, -2}, {0, 0, 4},
                        {4, 0, 0});
  builder.parallelogram({.emission = Colour(1.0f)}, {-1, 2, -2}, {2, 0, 0}, {0, 1, 0});
  const TestScene scene(builder);
  const LitScene lit = scene.lit(1);
  PcgSampler sampler(91);
  sampler.startPixel(0, 0, 0);
  const Ray ray{{0, 1, 1.5f}, normalize(Vector(0, -1, -1))};
  stats::RunningMoments mis, path;
  for (int m = 0; m < 20000; ++m) {
    sampler.startRay(m);
    mis.add(double{lit.tracePathMIS(ray, sampler).x});
    path.add(double{lit.tracePath(ray, sampler).x});
  }
  EXPECT_LT(20.0 * mis.standardError(), path.standardError());
}

}  // namespace
}  // namespace pathmark
