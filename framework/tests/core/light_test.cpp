// Light::sample asks the right function of part 2, and keeps what that function cannot know:
// which side shines, and how the faces share the light's area.
#include "support/probe_coursework.h"

#include <pathmark/lit_scene.h>

#include <gtest/gtest.h>

#include <vector>

namespace pathmark::test {
namespace {

struct TestPolygon {
  std::vector<Point> vertices;
  std::vector<Polygon::TriangleIndices> triangles{{0, 1, 2}};
  Polygon polygon() const { return {vertices, triangles, Vector(0, 1, 0)}; }
};

float densityOf(const TestPolygon& shape, bool bySolidAngle = false) {
  const Light::Face face{shape.polygon(), 1.0f, bySolidAngle};
  const Light light(std::span(&face, 1), Colour(1));
  return light.sample(Point(0), 0.25f, 0.5f).pdf;
}

// Of the point that a ray has met.
float densityAt(const TestPolygon& shape, bool bySolidAngle) {
  const Light::Face face{shape.polygon(), 1.0f, bySolidAngle};
  const Light light(std::span(&face, 1), Colour(1));
  Hit hit;
  hit.p = shape.vertices[0];
  return light.pdf(Point(0, 1, 0), hit);
}

const TestPolygon kTriangle{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}};
const TestPolygon kRectangle{{{0, 0, 0}, {2, 0, 0}, {2, 0, 3}, {0, 0, 3}}, {{0, 1, 2}, {0, 2, 3}}};
const TestPolygon kParallelogram{{{0, 0, 0}, {2, 0, 0}, {3, 0, 1}, {1, 0, 1}},
                                 {{0, 1, 2}, {0, 2, 3}}};

TEST(Light, TheFunctionFollowsFromTheVertices) {
  EXPECT_EQ(densityOf({{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}}), kTriangularDensity);
  EXPECT_EQ(densityOf({{{0, 0, 0}, {2, 0, 0}, {3, 0, 1}, {1, 0, 1}}}), kRectangularDensity);
  EXPECT_EQ(densityOf({{{0, 0, 0}, {2, 0, 0}, {3, 0, 2}, {1, 0, 1}}}), kPolygonDensity);
  EXPECT_EQ(densityOf({{{0, 0, 0}, {2, 0, 0}, {3, 0, 1}, {1, 0, 3}, {0, 0, 1}}}), kPolygonDensity);
}

TEST(Light, ARectangleFarFromTheOriginIsStillOne) {
  const Point far(5000.3f, 1e-3f, -7000.7f);
  EXPECT_EQ(densityOf({{far, far + Vector(0.1f, 0, 0), far + Vector(0.1f, 0, 0.3f),
                        far + Vector(0, 0, 0.3f)}}),
            kRectangularDensity);
}

TEST(Light, BySolidAngleTrianglesAndRectanglesHaveFunctionsOfTheirOwn) {
  EXPECT_EQ(densityOf(kTriangle, true), kSphericalTriangleDensity);
  EXPECT_EQ(densityOf(kRectangle, true), kSphericalRectangleDensity);
  EXPECT_EQ(densityOf(kParallelogram, true), kRectangularDensity) << "has no right angles";
}

TEST(Light, ThePointsThatRaysMeetHaveTheDensityOfSampling) {
  EXPECT_EQ(densityAt(kTriangle, true), kSphericalTriangleDensity);
  EXPECT_EQ(densityAt(kRectangle, true), kSphericalRectangleDensity);
  EXPECT_FLOAT_EQ(densityAt(kTriangle, false), 2.0f);
  EXPECT_FLOAT_EQ(densityAt(kRectangle, false), 1.0f / 6.0f);
  EXPECT_FLOAT_EQ(densityAt(kParallelogram, true), 0.5f);
}

TEST(Light, FacesAreChosenByAreaAndTheNumberIsUsedAgain) {
  const TestPolygon shape{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}};
  const TestPolygon other{{{0, 0, 0}, {2, 0, 0}, {3, 0, 1}, {1, 0, 1}}};
  const std::vector<Light::Face> faces{{shape.polygon(), 0.25f, false},
                                       {other.polygon(), 1.0f, false}};
  const Light light(faces, Colour(1));
  const LightSample first = light.sample(Point(0), 0.125f, 0.5f);
  EXPECT_EQ(first.pdf, kTriangularDensity * 0.25f);
  EXPECT_EQ(first.p.x, 0.5f);
  const LightSample second = light.sample(Point(0), 0.625f, 0.5f);
  EXPECT_EQ(second.pdf, kRectangularDensity * 0.75f);
  EXPECT_EQ(second.p.x, 0.5f);
  EXPECT_EQ(light.sample(Point(0), 0.25f, 0.5f).pdf, kRectangularDensity * 0.75f);
  EXPECT_LT(light.sample(Point(0), 0x1.fffffep-1f, 0.5f).p.x, 1.0f);
}

// A point of the sphere's own surface is rounded to either side of it.
TEST(Light, AnOutwardSphereLightsNothingOnOrInsideItself) {
  const Sphere sphere(Point(3, -2, 7), 1.5f);
  const Light light(sphere, false, false, Colour(1));
  EXPECT_EQ(light.sample(Point(3, -2, 7), 0.5f, 0.5f).pdf, 0.0f);
  EXPECT_EQ(light.sample(Point(3, -1, 7), 0.5f, 0.5f).pdf, 0.0f);
  for (int k = 0; k < 1000; ++k) {
    const auto a = static_cast<float>(k);
    const Vector n = normalize(Vector(std::sin(a), std::cos(1.7f * a), std::sin(2.3f * a + 1)));
    EXPECT_EQ(light.sample(sphere.centre() + 1.5f * n, 0.5f, 0.5f).pdf, 0.0f);
    EXPECT_EQ(light.sample(sphere.centre() + 1.5001f * n, 0.5f, 0.5f).pdf, kSphereDensity);
  }
}

TEST(Light, AnInwardSphereLightsItsInsideAndItsOwnSurface) {
  const Sphere sphere(Point(3, -2, 7), 1.5f);
  const Light light(sphere, true, false, Colour(1));
  EXPECT_EQ(light.sample(Point(3, -1.8f, 7), 0.5f, 0.5f).pdf, kSphereDensity);
  EXPECT_EQ(light.sample(Point(3, 5, 7), 0.5f, 0.5f).pdf, 0.0f);
  for (int k = 0; k < 1000; ++k) {
    const auto a = static_cast<float>(k);
    const Vector n = normalize(Vector(std::sin(a), std::cos(1.7f * a), std::sin(2.3f * a + 1)));
    const LightSample sample = light.sample(sphere.centre() + 1.5f * n, 0.5f, 0.5f);
    EXPECT_EQ(sample.pdf, kSphereDensity);
    EXPECT_EQ(sample.n, Vector(0, -1, 0)) << "the emitting side is the inside";
    // The probe returns the point that it was given: clearly inside, as the contract has it.
    EXPECT_LT(length(sample.p - sphere.centre()), 1.0f);
  }
}

// Also from outside, where the near half turns its back on them.
TEST(Light, AnInwardSphereWhoseBackIsSeenThroughLightsAllPoints) {
  const Sphere sphere(Point(3, -2, 7), 1.5f);
  const Light light(sphere, true, true, Colour(1));
  for (const Point& from : {Point(3, -1.8f, 7), Point(3, -0.5f, 7), Point(3, 5, 7)}) {
    const LightSample sample = light.sample(from, 0.5f, 0.5f);
    EXPECT_EQ(sample.pdf, kSphereDensity);
    EXPECT_EQ(sample.n, Vector(0, -1, 0));
    EXPECT_LT(length(sample.p - sphere.centre()), 1.0f) << "the probe was asked from inside";
  }
}

}  // namespace
}  // namespace pathmark::test
