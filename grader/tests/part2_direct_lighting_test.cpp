// Part 2: direct light, against closed forms of the irradiance.
#include "checks/irradiance.h"
#include "sampling/pcg_sampler.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"
#include "tests/support/test_scene.h"

#include <gtest/gtest.h>

namespace pathmark {
namespace {

using namespace testing;
using checks::polygonIrradiance, checks::sphereIrradiance;

const Colour kEmission(3.0f, 2.0f, 0.5f), kKd(0.9f, 0.5f, 0.2f);
const lambertianBRDF kReceiver(kKd);

Hit receiverAt(const Point& p, const Vector& n) {
  Hit hit;
  hit.p = p;
  hit.n = n;
  hit.brdf = &kReceiver;
  hit.error = 1e-6f * std::max({1.0f, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return hit;
}

struct Radiance {
  stats::RunningMoments channel[3];
};

Radiance directRadiance(const TestScene& scene, const Hit& hit, const Vector& wo, int samples,
                        std::uint64_t seed) {
  const LitScene lit = scene.lit(1);
  PcgSampler sampler(seed);
  sampler.startPixel(0, 0, 0);
  Radiance result;
  for (int i = 0; i < samples; ++i) {
    sampler.startRay(i);
    const Colour l = lit.directLighting(hit, wo, sampler);
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isfinite(l[c]) && l[c] >= 0.0f);
      result.channel[c].add(l[c]);
    }
  }
  return result;
}

// irradiance: from lights of radiance 1.
void expectRadiance(const TestScene& scene, const Hit& hit, const glm::dvec3& irradiance,
                    int samples = 20000) {
  const Vector wo = atCosine(hit.n, 0.4, 1.0);
  const Radiance radiance = directRadiance(scene, hit, wo, samples, 221);
  for (int c = 0; c < 3; ++c) {
    const double expected = double{kKd[c]} / kPiD * irradiance[c];
    EXPECT_TRUE(meanIs(radiance.channel[c], expected,
                       {.alpha = kAlpha, .tolerance = 3e-5 * expected + 1e-12}))
        << "channel " << c;
  }
}

glm::dvec3 fromRadianceOne(double irradiance) { return irradiance * glm::dvec3(kEmission); }

std::vector<glm::dvec3> outline(const std::vector<Point>& vertices) {
  std::vector<glm::dvec3> result;
  for (const Point& v : vertices) result.emplace_back(v);
  return result;
}

const Surface kLamp{.emission = kEmission};

// A lamp of area 3 at height 1.5 that looks down: y = 0 is lit, what is above it is not.
const Point kCorner(-1, 1.5f, -0.75f);
const Vector kEdge1(2, 0, 0), kEdge2(0, 0, 1.5f);
const std::vector<Point> kRectangle{kCorner, kCorner + kEdge1, kCorner + kEdge1 + kEdge2,
                                    kCorner + kEdge2};

TEST(DirectLighting, FromARectangleIsLambertsFormula) {
  const TestScene scene(SceneBuilder().parallelogram(kLamp, kCorner, kEdge1, kEdge2));
  const struct {
    Point p;
    Vector n;
  } receivers[] = {
      {{0, 0, 0}, {0, 1, 0}},                   // parallel, below the middle
      {{3, 0, -2}, {0, 1, 0}},                  // parallel, to the side
      {{0.2f, 1.25f, 0.1f}, {0, 1, 0}},         // parallel, near
      {{-2, 0, 0}, {1, 0, 0}},                  // perpendicular
      {{0, 0.5f, 0}, {1, 0, 0}},                // perpendicular, half the lamp behind it
      {{-3, 1.4f, 0}, unit(0, 1, 0)},           // grazing
      {{5, -3, 8}, unit(-1, 0.5, -2)},          // oblique
      {{0.9f, 0.7f, 0.6f}, unit(1, 0.2, 0.5)},  // oblique, partly behind
      {{40, -30, 20}, unit(-1, 1, 0)},          // far
  };
  for (const auto& [p, n] : receivers) {
    SCOPED_TRACE(::testing::Message() << p.x << " " << p.y << " " << p.z);
    const double irradiance = polygonIrradiance(outline(kRectangle), glm::dvec3(p), glm::dvec3(n));
    ASSERT_GT(irradiance, 0.0);
    expectRadiance(scene, receiverAt(p, n), fromRadianceOne(irradiance), 50000);
  }
}

// The view factor from a differential area to a parallel rectangle with a corner above it
// (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3).
TEST(DirectLighting, FromAboveACornerIsTheTabulatedViewFactor) {
  const TestScene scene(SceneBuilder().parallelogram(kLamp, kCorner, kEdge1, kEdge2));
  const double a = 2.0 / 1.5, b = 1.5 / 1.5;
  const double factor = (a / std::hypot(1.0, a) * std::atan(b / std::hypot(1.0, a)) +
                         b / std::hypot(1.0, b) * std::atan(a / std::hypot(1.0, b))) /
                        (2.0 * kPiD);
  expectRadiance(scene, receiverAt({-1, 0, -0.75f}, {0, 1, 0}), fromRadianceOne(kPiD * factor));
}

TEST(DirectLighting, FromTrianglesAndPolygonsIsLambertsFormula) {
  const std::vector<std::vector<Point>> lamps{
      {{0, 2, 0}, {1, 2, 0}, {0, 2, 3}},
      {{-1, 2, -1}, {2, 2, -1}, {1, 2, 1}, {-1, 2, 0.5f}},
      {{0, 3, -2}, {2, 3, -1}, {2, 3, 1}, {0, 3, 1.5f}, {-1, 3, 0}}};
  for (const std::vector<Point>& lamp : lamps) {
    const TestScene scene(SceneBuilder().polygon(kLamp, lamp));
    for (const Point& p : {Point(0.3f, 0, 0.2f), Point(2, 1, -3)}) {
      const double irradiance = polygonIrradiance(outline(lamp), glm::dvec3(p), {0, 1, 0});
      SCOPED_TRACE(::testing::Message() << lamp.size() << " vertices");
      ASSERT_GT(irradiance, 0.0);
      expectRadiance(scene, receiverAt(p, {0, 1, 0}), fromRadianceOne(irradiance));
    }
  }
}

TEST(DirectLighting, FromASphereInFullViewIsTheInverseSquare) {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    for (const double ratio : {1e-3, 0.1, 0.5, 0.9}) {
      SCOPED_TRACE(::testing::Message() << "scale " << scale << ", ratio " << ratio);
      const Point centre(glm::dvec3(0.3, 2, -0.6) * scale);
      const double distance = glm::length(glm::dvec3(centre));
      const auto radius = float(ratio * distance);
      const TestScene scene(SceneBuilder().sphere(kLamp, centre, radius));
      // Tilted by no more than what keeps the whole sphere above the horizon.
      const double tilt = 0.9 * (0.5 * kPiD - std::asin(ratio));
      const Vector n = atCosine(unit(0.3, 2, -0.6), std::cos(tilt), 0.7);
      Hit hit = receiverAt(Point(0), n);
      hit.error = float(1e-7 * scale);
      const double sine = double{radius} / distance;
      const double cosine = glm::dot(glm::dvec3(n), glm::dvec3(centre)) / distance;
      expectRadiance(scene, hit, fromRadianceOne(kPiD * sine * sine * cosine));
    }
  }
}

TEST(DirectLighting, FromASphereCutByTheHorizonIsTheQuadrature) {
  const Point centre(0, 2, 0);
  for (const float radius : {0.02f, 1.0f, 1.9f}) {
    const TestScene scene(SceneBuilder().sphere(kLamp, centre, radius));
    const double sine = double{radius} / 2.0;
    for (const double share : {-0.9, -0.3, 0.0, 0.5}) {
      const double cosAxis = std::sin(share * std::asin(sine));
      SCOPED_TRACE(::testing::Message() << "radius " << radius << ", cosine " << cosAxis);
      const Vector n = atCosine({0, 1, 0}, cosAxis, 0.7);
      expectRadiance(scene, receiverAt(Point(0), n), fromRadianceOne(sphereIrradiance(sine, n.y)),
                     100000);
    }
  }
}

TEST(DirectLighting, InsideAGlowingSphereIsPiTimesItsRadiance) {
  const TestScene scene(SceneBuilder().sphere(kLamp, {1, 2, 3}, 2.0f, true));
  for (const Point& p : {Point(1, 2, 3), Point(1.5f, 1.2f, 2.5f), Point(1, 2, 4.8f)})
    expectRadiance(scene, receiverAt(p, unit(1, 2, 0.5)), fromRadianceOne(kPiD), 100000);
}

TEST(DirectLighting, OnOrInsideAnOutwardSphereIsBlack) {
  const Point centre(1, 2, 3);
  const TestScene scene(SceneBuilder().sphere(kLamp, centre, 2.0f));
  Uniforms random(222);
  for (const double share : {0.0, 0.5, 0.999, 1.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vector outward = randomUnit(random);
      const Point p(glm::dvec3(centre) + 2.0 * share * glm::dvec3(outward));
      for (const Vector& n : {outward, -outward, randomUnit(random)})
        expectRadiance(scene, receiverAt(p, n), glm::dvec3(0.0), 50);
    }
  }
}

TEST(DirectLighting, FromSeveralUnequalLightsIsTheirSum) {
  const Surface lamps[] = {
      {.emission = {5, 0, 1}}, {.emission = {0.5f, 3, 0}}, {.emission = {0, 1, 40}}};
  const std::vector<Point> side{{-4, 0.5f, -1}, {-4, 3, -1}, {-4, 3, 2}, {-4, 0.5f, 2}};
  const Point centre(2, 1.2f, 2);
  SceneBuilder builder;
  builder.parallelogram(lamps[0], kCorner, kEdge1, kEdge2).polygon(lamps[1], side);
  builder.sphere(lamps[2], centre, 0.3f);
  const TestScene scene(builder);
  const Point p(0.4f, 0, 0.1f);
  const glm::dvec3 toCentre = glm::dvec3(centre) - glm::dvec3(p);
  const double distance = glm::length(toCentre), sine = double{0.3f} / distance;
  const glm::dvec3 x(p), n(0, 1, 0);
  const glm::dvec3 sum =
      glm::dvec3(lamps[0].emission) * polygonIrradiance(outline(kRectangle), x, n) +
      glm::dvec3(lamps[1].emission) * polygonIrradiance(outline(side), x, n) +
      glm::dvec3(lamps[2].emission) * sphereIrradiance(sine, toCentre.y / distance);
  expectRadiance(scene, receiverAt(p, {0, 1, 0}), sum, 100000);
}

TEST(DirectLighting, IsBlackBehindALightBehindAReceiverAndSeenFromBehind) {
  const TestScene scene(SceneBuilder().parallelogram(kLamp, kCorner, kEdge1, kEdge2));
  const glm::dvec3 black(0.0);
  expectRadiance(scene, receiverAt({0, 3, 0}, {0, -1, 0}), black, 200);
  expectRadiance(scene, receiverAt({0, 0, 0}, {0, -1, 0}), black, 200);
  const Radiance fromBehind =
      directRadiance(scene, receiverAt({0, 0, 0}, {0, 1, 0}), unit(0.1, -1, 0), 200, 223);
  for (const stats::RunningMoments& channel : fromBehind.channel) EXPECT_EQ(channel.mean(), 0.0);
}

// A lamp's own back hides its front, unless rays pass through it.
TEST(DirectLighting, DoesNotShineThroughTheBackOfALight) {
  Surface lamp = kLamp;
  lamp.frontOnly = true;
  const TestScene scene(SceneBuilder().parallelogram(lamp, kCorner, kEdge1, kEdge2));
  expectRadiance(scene, receiverAt({0, 3, 0}, {0, -1, 0}), glm::dvec3(0.0), 200);
  const double below = polygonIrradiance(outline(kRectangle), {0, 0, 0}, {0, 1, 0});
  expectRadiance(scene, receiverAt({0, 0, 0}, {0, 1, 0}), fromRadianceOne(below));
}

// A screen hides what lies on one side of its edge: the rest of the lamp is a smaller rectangle.
TEST(DirectLighting, StopsAtWhatLiesBetween) {
  const Surface screen{.kd = Colour(0.5f)};
  SceneBuilder builder;
  builder.parallelogram(kLamp, kCorner, kEdge1, kEdge2);
  builder.parallelogram(screen, {0, 0.75f, -5}, {5, 0, 0}, {0, 0, 10});
  const TestScene scene(builder);
  const Vector half(1, 0, 0);
  const std::vector<Point> open{kCorner, kCorner + half, kCorner + half + kEdge2, kCorner + kEdge2};
  expectRadiance(scene, receiverAt({0, 0, 0}, {0, 1, 0}),
                 fromRadianceOne(polygonIrradiance(outline(open), {0, 0, 0}, {0, 1, 0})), 100000);
  expectRadiance(scene, receiverAt({4.9f, 0.5f, 0}, {0, 1, 0}), glm::dvec3(0.0), 200);
}

TEST(DirectLighting, WithoutLightsIsBlack) {
  const TestScene scene(SceneBuilder().sphere({.kd = Colour(0.5f)}, {0, 2, 0}, 1.0f));
  expectRadiance(scene, receiverAt({0, 0, 0}, {0, 1, 0}), glm::dvec3(0.0), 10);
}

// A Phong receiver: quadrature over a rectangle, f cos cos / r^2.
TEST(DirectLighting, WeighsWithTheBrdfOfTheReceiver) {
  const TestScene scene(SceneBuilder().parallelogram(kLamp, kCorner, kEdge1, kEdge2));
  for (const float exponent : {0.5f, 7.3f, 100.0f}) {
    const phongBRDF glossy(Colour(0.1f, 0.2f, 0.3f), Colour(0.8f, 0.5f, 0.1f), exponent);
    Hit hit = receiverAt({0.2f, 0, 0.3f}, unit(0.1, 1, -0.2));
    hit.brdf = &glossy;
    const Vector wo = unit(0.3, 1, 0.2);
    const Radiance radiance = directRadiance(scene, hit, wo, 100000, 224);
    for (int c = 0; c < 3; ++c) {
      const double expected = integrate(
          [&](double s) {
            return integrate(
                [&](double t) {
                  const glm::dvec3 w = glm::dvec3(kCorner) + s * glm::dvec3(kEdge1) +
                                       t * glm::dvec3(kEdge2) - glm::dvec3(hit.p);
                  const glm::dvec3 wi = glm::normalize(w), n(hit.n), o(wo);
                  const double alpha = glm::dot(wi, 2.0 * glm::dot(o, n) * n - o);
                  const double f = double{glossy.Kd[c]} / kPiD +
                                   double{glossy.Ks[c]} * (double{exponent} + 2) / (2 * kPiD) *
                                       std::pow(std::max(alpha, 0.0), double{exponent});
                  return f * glm::dot(wi, n) * wi.y / glm::dot(w, w);
                },
                0.0, 1.0, 6);
          },
          0.0, 1.0, 6);
      EXPECT_TRUE(meanIs(radiance.channel[c], double{kEmission[c]} * 3.0 * expected,
                         {.alpha = kAlpha, .tolerance = 1e-5}))
          << "exponent " << exponent << ", channel " << c;
    }
  }
}

}  // namespace
}  // namespace pathmark
