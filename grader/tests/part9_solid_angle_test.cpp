// Part 9: points by the solid angle, against long double. A point says which shares of the solid
// angle lie to its sides, and these must be s and t: there is no threshold below which that fails.
#include "checks/seen_light.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/uniforms.h"

#include <pathmark/coursework.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace pathmark {
namespace {

using namespace testing;
using checks::SeenLight;

const std::vector<Polygon::TriangleIndices> kNone;

Polygon polygonOf(const SeenLight& light) {
  return {light.outline().vertices(), kNone, light.outline().normal()};
}

// A light around the origin as seen from `distance` sizes away at a cosine; the rounding of its
// points is that of its own size.
SeenLight seenFrom(double distance, double cosine, bool triangle, Uniforms& random) {
  const checks::DoubleFrame frame{glm::dvec3(randomUnit(random))};
  std::vector<glm::dvec2> corners{{-0.5, -0.4}, {0.5, -0.4}, {0.5, 0.4}, {-0.5, 0.4}};
  if (triangle)
    corners = {{-0.5, -0.4}, {0.6, -0.3 + 0.2 * random.nextDouble()}, {random.nextDouble(), 0.6}};
  std::vector<Point> vertices;
  for (const glm::dvec2& c : corners) vertices.emplace_back(c.x * frame.u + c.y * frame.v);
  const double sine = std::sqrt(1.0 - cosine * cosine), azimuth = 6.28 * random.nextDouble();
  const glm::dvec3 towards =
      cosine * frame.n + sine * (std::cos(azimuth) * frame.u + std::sin(azimuth) * frame.v);
  return {"", std::move(vertices), Point(distance * towards)};
}

LightSample sample(const SeenLight& light, bool triangle, float s, float t) {
  const Polygon polygon = polygonOf(light);
  return triangle ? polygon.SphericalTriangleSampling(light.from(), s, t)
                  : polygon.SphericalRectangleSampling(light.from(), s, t);
}

float pdf(const SeenLight& light, bool triangle, const Point& p) {
  const Polygon polygon = polygonOf(light);
  return triangle ? polygon.SphericalTrianglePdf(light.from(), p)
                  : polygon.SphericalRectanglePdf(light.from(), p);
}

// The worst error of the mean of the weights and moments, by a fine grid of s and t.
double worstMoment(const SeenLight& light, bool triangle) {
  constexpr int kSide = 64;
  const std::vector<checks::Mean> means = light.means();
  std::vector<double> sums(means.size(), 0.0);
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const LightSample y = sample(light, triangle, (static_cast<float>(i) + 0.5f) / kSide,
                                   (static_cast<float>(j) + 0.5f) / kSide);
      light.add(y.p, light.density(y.p) / double{y.pdf} / (kSide * kSide), sums);
    }
  double worst = 0.0;
  for (std::size_t k = 0; k < 6; ++k)
    worst = std::max(worst, std::abs(sums[k] - means[k].expected));
  return worst;
}

TEST(SolidAngleSampling, IsUniformFromNearAndFarAndAtGrazingAngles) {
  for (const bool triangle : {true, false})
    for (const double distance : {1e-4, 1e-3, 1e-2, 0.2, 1.0, 10.0, 1e3, 1e5, 1e6})
      for (const double cosine : {1.0, 0.3, 0.01}) {
        if (distance * cosine < 0.1 && cosine < 1.0) continue;
        Uniforms random(91);
        const SeenLight light = seenFrom(distance, cosine, triangle, random);
        // The moments of a grid are off by its width squared, where s chooses a triangle by the
        // width: 1/64.
        EXPECT_LT(worstMoment(light, triangle), triangle ? 5e-4 : 5e-3)
            << (triangle ? "triangle" : "rectangle") << " from " << distance << " at cosine "
            << cosine << ", omega " << light.omega();
      }
}

TEST(SolidAngleSampling, HasTheDensityOfTheOracle) {
  for (const bool triangle : {true, false})
    for (const double distance : {0.2, 1.0, 10.0, 1e3, 1e5, 1e6})
      for (const double cosine : {1.0, 0.3, 0.01}) {
        Uniforms random(92);
        const SeenLight light = seenFrom(distance, cosine, triangle, random);
        for (int k = 0; k < 200; ++k) {
          const LightSample y = sample(light, triangle, random.next(), random.next());
          // What a rounding of `from` does to its height over the plane.
          const double allowed =
              2e-6 + 4.0 * kRoundoff / std::min({distance * cosine, cosine, 1.0});
          EXPECT_TRUE(isClose(y.pdf, static_cast<long double>(light.density(y.p)), allowed))
              << "distance " << distance << ", cosine " << cosine;
          EXPECT_EQ(y.pdf, pdf(light, triangle, y.p));
        }
      }
}

TEST(SolidAngleSampling, GivesPointsOfTheLightForAllNumbers) {
  for (const bool triangle : {true, false})
    for (const double distance : {1e-5, 1e-4, 1e-3, 0.05, 1.0, 1e3, 1e6})
      for (const float s : {0.0f, 0x1p-149f, 0x1p-24f, 0.5f, 1.0f - 0x1p-24f})
        for (const float t : {0.0f, 0x1p-149f, 0x1p-24f, 0.5f, 1.0f - 0x1p-24f}) {
          Uniforms random(93);
          const SeenLight light = seenFrom(distance, 0.7, triangle, random);
          const LightSample y = sample(light, triangle, s, t);
          EXPECT_TRUE(isFinite(y.p));
          EXPECT_TRUE(std::isfinite(y.pdf) && y.pdf > 0.0f);
          EXPECT_LT(light.outline().distance(y.p), 8.0 * kRoundoff);
        }
}

TEST(SolidAngleSampling, SendsNothingBackwardsOrIntoItsPlane) {
  const std::vector<Point> vertices{{0, 2, 0}, {1, 2, 0}, {1, 2, 1}, {0, 2, 1}};
  const Polygon polygon(vertices, kNone, {0, -1, 0});
  for (const Point& from : {Point(0, 3, 0), Point(5, 2, 5), Point(0.5f, 2, 0.5f), Point(0, 2, 0)}) {
    EXPECT_EQ(polygon.SphericalTriangleSampling(from, 0.5f, 0.5f).pdf, 0.0f);
    EXPECT_EQ(polygon.SphericalTrianglePdf(from, {0.7f, 2, 0.3f}), 0.0f);
    EXPECT_EQ(polygon.SphericalRectangleSampling(from, 0.5f, 0.5f).pdf, 0.0f);
    EXPECT_EQ(polygon.SphericalRectanglePdf(from, {0.7f, 2, 0.3f}), 0.0f);
  }
}

// The receiver may be the light itself, or what lies on it.
TEST(SolidAngleSampling, SendsNothingToPointsThatOnlyRoundingPutsInFrontOfIt) {
  for (const bool triangle : {true, false})
    for (int seed = 0; seed < 200; ++seed) {
      Uniforms random(94 + seed);
      const SeenLight light = seenFrom(1.0, 1.0, triangle, random);
      const Point& a = light.outline().vertices()[0];
      const Point& b = light.outline().vertices()[1];
      const Point& c = light.outline().vertices()[2];
      const Point own = a + 0.3f * (b - a) + 0.4f * (c - b);
      const Polygon polygon = polygonOf(light);
      const LightSample y = triangle ? polygon.SphericalTriangleSampling(own, 0.5f, 0.5f)
                                     : polygon.SphericalRectangleSampling(own, 0.5f, 0.5f);
      EXPECT_TRUE(isFinite(y.p));
      EXPECT_EQ(y.pdf, 0.0f);
    }
}

}  // namespace
}  // namespace pathmark
