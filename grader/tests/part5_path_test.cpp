// Part 5: the path tracer, against closed forms and against other estimators.
#include "sampling/pcg_sampler.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/edge_sampler.h"
#include "tests/support/expect.h"
#include "tests/support/reference_tracer.h"
#include "tests/support/test_rooms.h"

#include <gtest/gtest.h>

#include <functional>

namespace pathmark {
namespace {

using namespace testing;

struct Radiance {
  stats::RunningMoments channel[3];

  void add(const glm::dvec3& l) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isfinite(l[c]) && l[c] >= 0.0);
      channel[c].add(l[c]);
    }
  }
};

using RaySource = std::function<Ray(Uniforms&)>;

Radiance tracePaths(const TestScene& scene, int bounces, int paths, const RaySource& rays) {
  const LitScene lit = scene.lit(bounces);
  PcgSampler sampler(511);
  sampler.startPixel(3, 4, 0);
  Uniforms random(512);
  Radiance radiance;
  for (int m = 0; m < paths; ++m) {
    sampler.startRay(m);
    radiance.add(glm::dvec3(lit.tracePath(rays(random), sampler)));
  }
  return radiance;
}

Ray within(const Point& origin, Uniforms& random) { return {origin, randomUnit(random)}; }

// Any ray of the camera's image.
Ray ofImage(const SimpleCamera& camera, Uniforms& random) {
  const double x = random.nextDouble() * camera.width(), y = random.nextDouble() * camera.height();
  return {camera.eye(),
          Vector(glm::normalize(glm::dvec3(camera.topLeft()) + x * glm::dvec3(camera.pixelRight()) +
                                y * glm::dvec3(camera.pixelDown())))};
}

TEST(TracePath, InAFurnaceIsAGeometricSeries) {
  const TestScene scene(furnace());
  for (const int bounces : {0, 1, 2, 8}) {
    for (const Point& eye : {Point(-1, 0.5f, 0.3f), Point(0, 0, 1.9f)}) {
      SCOPED_TRACE(::testing::Message() << bounces << " bounces");
      const Radiance radiance =
          tracePaths(scene, bounces, 40000, [&](Uniforms& random) { return within(eye, random); });
      for (const stats::RunningMoments& channel : radiance.channel) {
        EXPECT_TRUE(meanIs(channel, 1.0 - std::ldexp(1.0, -(bounces + 1)),
                           {.alpha = kAlpha, .tolerance = 1e-5}));
      }
    }
  }
}

TEST(TracePath, WithoutBouncesIsTheEmissionOfWhatIsSeen) {
  const Colour emission(3, 2, 1);
  const TestScene scene(SceneBuilder().parallelogram({.kd = Colour(0.5f), .emission = emission},
                                                     {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  const LitScene lit = scene.lit(0);
  PcgSampler sampler(513);
  sampler.startPixel(0, 0, 0);
  EXPECT_EQ(lit.tracePath({{0, 0, 2}, {0, 0, -1}}, sampler), emission);
  EXPECT_EQ(lit.tracePath({{0, 0, -2}, {0, 0, 1}}, sampler), Colour(0.0f)) << "the back is dark";
  EXPECT_EQ(lit.tracePath({{5, 0, 2}, {0, 0, -1}}, sampler), Colour(0.0f)) << "nothing is there";
}

// A lamp that does not see itself: what it emits is all there is, at every number of bounces.
TEST(TracePath, CountsEmissionOnce) {
  const Colour emission(3, 2, 1);
  const TestScene scene(SceneBuilder().parallelogram({.kd = Colour(0.5f), .emission = emission},
                                                     {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  PcgSampler sampler(514);
  sampler.startPixel(0, 0, 0);
  for (const int bounces : {1, 2, 8}) {
    for (int m = 0; m < 100; ++m) {
      sampler.startRay(m);
      EXPECT_EQ(scene.lit(bounces).tracePath({{0, 0, 2}, {0, 0, -1}}, sampler), emission);
    }
  }
}

TEST(TracePath, WhereNothingIsIsBlack) {
  const TestScene empty{SceneBuilder()};
  PcgSampler sampler(515);
  sampler.startPixel(0, 0, 0);
  EXPECT_EQ(empty.lit(8).tracePath({{0, 0, 0}, {0, 0, 1}}, sampler), Colour(0.0f));
}

// With one bounce tracePath is the emission and the direct light of the first surface.
TEST(TracePath, WithOneBounceIsDirectLight) {
  const TestScene scene(unevenRoom());
  const LitScene lit = scene.lit(1);
  Uniforms random(516);
  for (int trial = 0; trial < 20; ++trial) {
    const Ray ray = ofImage(scene.core().camera(), random);
    Hit hit;
    if (!lit.intersect(ray, hit)) continue;
    const Vector wo = -ray.direction;
    Radiance paths, direct;
    PcgSampler sampler(517 + std::uint64_t(trial));
    sampler.startPixel(0, 0, 0);
    for (int m = 0; m < 4000; ++m) {
      sampler.startRay(m);
      paths.add(glm::dvec3(lit.tracePath(ray, sampler)));
      sampler.startRay(m + 4000);
      direct.add(glm::dvec3(hit.emitted(wo) + lit.directLighting(hit, wo, sampler)));
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(
          meansAgree(paths.channel[c], direct.channel[c], {.alpha = kAlpha, .tolerance = 1e-6}));
    }
  }
}

void expectAgreement(const Radiance& actual, const Radiance& expected) {
  for (int c = 0; c < 3; ++c)
    EXPECT_TRUE(meansAgree(actual.channel[c], expected.channel[c], {.alpha = kAlpha}))
        << "channel " << c;
}

// The hemispherical form of the rendering equation, without any direct lighting.
TEST(TracePath, AgreesWithUniformDirectionsAlone) {
  const TestScene scene(unevenRoom());
  const ReferenceTracer reference(scene.flat());
  const auto rays = [&](Uniforms& random) { return ofImage(scene.core().camera(), random); };
  for (const int bounces : {1, 2, 8}) {
    SCOPED_TRACE(::testing::Message() << bounces << " bounces");
    Radiance expected;
    Uniforms random(518);
    for (int i = 0; i < 600000; ++i) {
      const Ray ray = rays(random);
      expected.add(reference.hemispherical(glm::dvec3(ray.origin), glm::dvec3(ray.direction),
                                           bounces, random));
    }
    expectAgreement(tracePaths(scene, bounces, 400000, rays), expected);
  }
}

// The area form of direct light, and indirect light gathered by three rays at each vertex.
TEST(TracePath, AgreesWithBranchingGatherRays) {
  const TestScene scene(unevenRoom());
  const ReferenceTracer reference(scene.flat());
  const auto rays = [&](Uniforms& random) { return ofImage(scene.core().camera(), random); };
  for (const auto& [bounces, branches, trees] :
       {std::array{1, 1, 400000}, {2, 3, 150000}, {4, 3, 20000}, {8, 1, 200000}}) {
    SCOPED_TRACE(::testing::Message() << bounces << " bounces");
    Radiance expected;
    Uniforms random(519);
    for (int i = 0; i < trees; ++i) {
      const Ray ray = rays(random);
      expected.add(reference.gather(glm::dvec3(ray.origin), glm::dvec3(ray.direction), bounces,
                                    branches, random));
    }
    expectAgreement(tracePaths(scene, bounces, 400000, rays), expected);
  }
}

// Glossy floors and exponents that uniform directions would hardly find: a lamp over a floor, the
// second bounce by a mirror-like wall.
TEST(TracePath, AgreesOnGlossySurfaces) {
  for (const float exponent : {0.0f, 0.5f, 20.0f}) {
    const Surface glossy{
        .kd = Colour(0.1f, 0.2f, 0.0f), .ks = Colour(0.7f, 0.3f, 0.9f), .exponent = exponent};
    SceneBuilder builder;
    builder.parallelogram(glossy, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
    builder.parallelogram(glossy, {-2, 0, -2}, {4, 0, 0}, {0, 3, 0});
    builder.parallelogram({.kd = Colour(0.2f), .emission = Colour(2, 3, 4)}, {-1.5f, 1, -1},
                          {3, 0.5f, 0}, {0, 0, 2});
    builder.camera({0.5f, 0.6f, 3}, {0, 0.4f, -1}, 0.5, 8, 8);
    const TestScene scene(builder);
    const ReferenceTracer reference(scene.flat());
    const auto rays = [&](Uniforms& random) { return ofImage(scene.core().camera(), random); };
    for (const int bounces : {1, 3}) {
      SCOPED_TRACE(::testing::Message() << bounces << " bounces, exponent " << exponent);
      Radiance expected;
      Uniforms random(520);
      for (int i = 0; i < 300000; ++i) {
        const Ray ray = rays(random);
        expected.add(reference.gather(glm::dvec3(ray.origin), glm::dvec3(ray.direction), bounces, 1,
                                      random));
      }
      expectAgreement(tracePaths(scene, bounces, 300000, rays), expected);
    }
  }
}

TEST(TracePath, OfTheSameNumbersIsTheSame) {
  const TestScene scene(unevenRoom());
  const LitScene lit = scene.lit(8);
  Uniforms random(521);
  PcgSampler first(522), second(522);
  first.startPixel(0, 0, 0);
  second.startPixel(0, 0, 0);
  for (int m = 0; m < 1000; ++m) {
    const Ray ray = ofImage(scene.core().camera(), random);
    first.startRay(m);
    second.startRay(m);
    ASSERT_EQ(lit.tracePath(ray, first), lit.tracePath(ray, second));
  }
}

// Every number of a path at its ends: no square root of a negative, no division by zero.
TEST(TracePath, IsFiniteForAllNumbers) {
  for (const SceneBuilder& builder : {unevenRoom(), furnace()}) {
    const TestScene scene(builder);
    Uniforms random(523);
    EdgeSampler sampler;
    for (int m = 0; m < 20000; ++m) {
      sampler.startRay(m);
      const Colour l = scene.lit(8).tracePath(within({1, 0.75f, 1.4f}, random), sampler);
      ASSERT_TRUE(isFinite(l) && std::min({l.x, l.y, l.z}) >= 0.0f);
    }
  }
}

}  // namespace
}  // namespace pathmark
