// Triangles and area lights far from the origin: coordinates cancel unless differences come first.
#include "intersect/flat_intersector.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_polygon.h"
#include "tests/traps/trap.h"

#include <array>

namespace pathmark {
namespace {

using namespace testing;
using LongVector = glm::vec<3, long double, glm::defaultp>;

// Of about unit size, this far from the origin.
std::array<Point, 3> farTriangle(float distance, Uniforms& random) {
  const Point a = distance * randomUnit(random);
  const glm::dvec3 n(randomUnit(random));
  const DoubleFrame frame(n);
  const double x = random.between(-0.3, 0.3);
  return {a, Point(glm::dvec3(a) + frame.u), Point(glm::dvec3(a) + x * frame.u + frame.v)};
}

TEST(Trap, LightFarFromTheOriginKeepsItsDensity) {
  Uniforms random(1701);
  for (const float distance : {1e2f, 1e4f}) {
    Errors<Worst> triangle, rectangle;
    for (int i = 0; i < 10000; ++i) {
      const auto [a, b, c] = farTriangle(distance, random);
      const LongVector e1 = LongVector(b) - LongVector(a), e2 = LongVector(c) - LongVector(a);
      const long double exact = 1.0L / glm::length(glm::cross(e1, e2));
      const float naive = 1.0f / length(cross(a, b) + cross(b, c) + cross(c, a));
      const TestPolygon light({a, b, c}, {{0, 1, 2}});
      const TestPolygon quad({a, b, b + (c - a), c}, {{0, 1, 2}, {0, 2, 3}});
      triangle.add(relativeError(2.0f * naive, 2.0L * exact),
                   relativeError(light->TriangularSampling(0.5f, 0.5f).pdf, 2.0L * exact));
      rectangle.add(relativeError(naive, exact),
                    relativeError(quad->RectangularSampling(0.5f, 0.5f).pdf, exact));
    }
    expectTrap("density of a triangle, distance " + std::to_string(distance), triangle, 1e-6);
    expectTrap("density of a rectangle, distance " + std::to_string(distance), rectangle, 1e-6);
  }
}

// Distances of rays that start close by. Naive: where the ray meets the plane n.x = n.a.
TEST(Trap, HitFarFromTheOriginKeepsItsDistance) {
  Uniforms random(1703);
  for (const float distance : {1e2f, 1e4f}) {
    Errors<Rms> lengths;
    for (int i = 0; i < 20000; ++i) {
      const auto [a, b, c] = farTriangle(distance, random);
      const Vector n = normalize(cross(b - a, c - a));
      const float u = 0.1f + 0.3f * random.next(), v = 0.1f + 0.3f * random.next();
      const Point target = a + u * (b - a) + v * (c - a);
      const Point origin = target + 3.0f * n + 0.7f * randomUnit(random);
      const Ray ray{origin, normalize(target - origin)};

      FlatScene scene;
      scene.shapes.resize(1);
      const auto float3 = [](const Vector& x) { return Float3{x.x, x.y, x.z}; };
      scene.addTriangle({float3(a), float3(b), float3(c)}, float3(n), 0);
      PrimitiveHit hit;
      ASSERT_TRUE(FlatIntersector(viewOf(scene)).closest(ray, hit));

      const float t = (dot(n, a) - dot(n, ray.origin)) / dot(n, ray.direction);

      const LongVector e1 = LongVector(b) - LongVector(a), e2 = LongVector(c) - LongVector(a),
                       d(ray.direction), s = LongVector(origin) - LongVector(a),
                       q = glm::cross(d, e2), r = glm::cross(s, e1);
      const long double determinant = glm::dot(e1, q);
      const long double exactT = glm::dot(e2, r) / determinant;
      lengths.add(relativeError(t, exactT), relativeError(hit.t, exactT));
    }
    expectTrap("distance along the ray, rms, " + std::to_string(distance), lengths, 1e-6);
  }
}

}  // namespace
}  // namespace pathmark
