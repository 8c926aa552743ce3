// Part 0: rays against triangles and meshes.
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"

#include <pathmark/warmup.h>

#include <gtest/gtest.h>

namespace pathmark {
namespace {

using namespace testing;

// Within this barycentric distance of an edge either answer is right.
constexpr double kEdge = 1e-5;

Triangle makeTriangle(const Point& a, const Point& b, const Point& c) {
  const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
  const double area = glm::length(n);
  return {{a, b, c}, area > 0.0 ? Vector(n / area) : Vector(0, 0, 1), Colour(0.5f), Colour(0.0f)};
}

Point randomPoint(Uniforms& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return Point(glm::dvec3(x, y, random.between(-size, size)));
}

struct DoubleHit {
  double t = 0.0;
  double margin = 0.0;  // smallest barycentric coordinate: negative outside
};

DoubleHit intersectDouble(const Ray& ray, const Triangle& triangle) {
  const glm::dvec3 a(triangle.positions[0]), e1 = glm::dvec3(triangle.positions[1]) - a,
                                             e2 = glm::dvec3(triangle.positions[2]) - a,
                                             o(ray.origin), d(ray.direction);
  const glm::dvec3 q = glm::cross(d, e2), s = o - a, r = glm::cross(s, e1);
  const double determinant = glm::dot(e1, q);
  const double b1 = glm::dot(s, q) / determinant, b2 = glm::dot(d, r) / determinant;
  return {glm::dot(e2, r) / determinant, std::min({b1, b2, 1.0 - b1 - b2})};
}

TEST(RayTriangle, AgreesWithDoubleFromBothSides) {
  Uniforms random(1);
  int hits = 0, fromBehind = 0, behindOrigin = 0;
  for (int i = 0; i < 100000; ++i) {
    const Triangle triangle =
        makeTriangle(randomPoint(random, 1), randomPoint(random, 1), randomPoint(random, 1));
    const glm::dvec3 a(triangle.positions[0]), b(triangle.positions[1]), c(triangle.positions[2]);
    if (glm::length(glm::cross(b - a, c - a)) < 0.05) continue;
    const Point origin = randomPoint(random, 2);
    const double u = random.between(-0.2, 1.2), v = random.between(-0.2, 1.2);
    const glm::dvec3 direction = glm::normalize(a + u * (b - a) + v * (c - a) - glm::dvec3(origin));
    const Ray ray{origin, Vector(i % 4 == 0 ? -direction : direction)};
    const double cosine = glm::dot(glm::dvec3(triangle.normal), direction);
    if (std::abs(cosine) < 0.02) continue;

    const DoubleHit expected = intersectDouble(ray, triangle);
    if (std::abs(expected.margin) < kEdge) continue;
    const bool shouldHit = expected.margin > 0.0 && expected.t > 0.0;
    float t = -1.0f;
    const bool hit = ray_triangle_intersection(t, ray, triangle);
    ASSERT_EQ(hit, shouldHit) << "t " << expected.t << ", margin " << expected.margin;
    behindOrigin += expected.margin > 0.0 && expected.t < 0.0 ? 1 : 0;
    if (!hit) continue;
    ++hits;
    fromBehind += cosine > 0.0 ? 1 : 0;
    ASSERT_TRUE(isClose(t, expected.t, 1e-4, 1e-5));
  }
  EXPECT_GT(hits, 10000);
  EXPECT_GT(fromBehind, 3000);
  EXPECT_GT(behindOrigin, 3000);
}

// Powers of two scale without rounding, so that a small triangle is hit where a large one is: a
// determinant that is small is no sign of a parallel ray.
TEST(RayTriangle, IsHitAtEverySizeAlike) {
  Uniforms random(9);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point a = randomPoint(random, 1), b = randomPoint(random, 1), c = randomPoint(random, 1);
    const Point origin = randomPoint(random, 2);
    const Ray ray{origin, normalize((a + b + randomPoint(random, 1)) / 3.0f - origin)};
    float t = -1.0f;
    const bool hit = ray_triangle_intersection(t, ray, makeTriangle(a, b, c));
    hits += hit ? 1 : 0;
    for (const int power : {-20, -10, 10, 20}) {
      const float size = std::ldexp(1.0f, power);
      float scaledT = -1.0f;
      const Triangle scaled = makeTriangle(size * a, size * b, size * c);
      ASSERT_EQ(ray_triangle_intersection(scaledT, {size * ray.origin, ray.direction}, scaled), hit)
          << "size " << size;
      if (hit) {
        ASSERT_EQ(scaledT, size * t);
      }
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(RayTriangle, IsMissedByParallelRays) {
  const Triangle triangle = makeTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const float height : {0.0f, 1.0f, -0.5f}) {
    for (const Vector& direction : {Vector(1, 0, 0), Vector(0, -1, 0), unit(1, 1, 0)}) {
      float t = 0.0f;
      EXPECT_FALSE(ray_triangle_intersection(t, {{-0.1f, 0.2f, height}, direction}, triangle));
    }
  }
}

TEST(RayTriangle, IsMissedWithoutArea) {
  Uniforms random(2);
  const Triangle degenerate[] = {makeTriangle({0, 0, 0}, {1, 0, 0}, {1, 0, 0}),
                                 makeTriangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}),
                                 makeTriangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3})};
  for (const Triangle& triangle : degenerate) {
    for (int i = 0; i < 1000; ++i) {
      const Point origin = randomPoint(random, 3);
      const Vector direction =
          Vector(glm::normalize(glm::dvec3(triangle.positions[0]) - glm::dvec3(origin)));
      float t = 0.0f;
      // By rounding it may look like a sliver, and then it must still be a proper hit.
      const bool hit = ray_triangle_intersection(t, {origin, direction}, triangle);
      EXPECT_TRUE(!hit || (std::isfinite(t) && t > 0.0f));
    }
    float t = 0.0f;
    EXPECT_FALSE(ray_triangle_intersection(t, {{0, 0, 5}, {0, 0, -1}}, triangle));
  }
}

TEST(RayMesh, ReportsTheClosestOfAllTriangles) {
  Uniforms random(3);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 60; ++i) {
    const Point p = randomPoint(random, 1);
    Triangle triangle = makeTriangle(p, p + randomPoint(random, 0.7), p + randomPoint(random, 0.7));
    triangle.colour = Colour(float(i));
    triangles.push_back(triangle);
  }
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{randomPoint(random, 2), randomUnit(random)};
    int closest = -1;
    double nearest = 1e300;
    bool unclear = false;
    for (int k = 0; k < 60; ++k) {
      const DoubleHit hit = intersectDouble(ray, triangles[std::size_t(k)]);
      if (std::abs(hit.margin) < 1e-3 || std::abs(hit.t - nearest) < 1e-3) unclear = true;
      if (hit.margin > 0.0 && hit.t > 0.0 && hit.t < nearest) {
        nearest = hit.t;
        closest = k;
      }
    }
    if (unclear || nearest < 1e-3) continue;
    float t = 0.0f;
    Triangle triangle{};
    const bool hit = ray_mesh_intersection(t, triangle, ray, {triangles});
    ASSERT_EQ(hit, closest >= 0);
    if (!hit) continue;
    ++hits;
    ASSERT_EQ(triangle.colour.x, float(closest));
    ASSERT_TRUE(isClose(t, nearest, 1e-3));
  }
  EXPECT_GT(hits, 2000);
}

TEST(RayMesh, OfNothingIsMissed) {
  float t = 0.0f;
  Triangle triangle{};
  EXPECT_FALSE(ray_mesh_intersection(t, triangle, {{0, 0, 0}, {0, 0, 1}}, {}));
}

}  // namespace
}  // namespace pathmark
