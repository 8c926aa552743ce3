// Rays against spheres and triangles in float: cancellation, and edges that two triangles share.
#include "intersect/flat_intersector.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/traps/trap.h"

#include <array>

namespace pathmark {
namespace {

using namespace testing;
using LongVector = glm::vec<3, long double, glm::defaultp>;

// The quadratic formula of school: negative if the ray misses.
float naiveSphere(const Ray& ray, const Point& centre, float radius) {
  const Vector f = ray.origin - centre;
  const float a = dot(ray.direction, ray.direction), b = 2.0f * dot(f, ray.direction);
  const float c = dot(f, f) - radius * radius, discriminant = b * b - 4.0f * a * c;
  return discriminant < 0.0f ? -1.0f : (-b - std::sqrt(discriminant)) / (2.0f * a);
}

// By the distance of the line from the centre; in units of the radius, how far the line is from
// touching the sphere, and the nearer root.
struct SphereHit {
  long double clearance, t;

  SphereHit(const Ray& ray, const Point& centre, float radius) {
    const LongVector f = LongVector(ray.origin) - LongVector(centre), d(ray.direction);
    const long double a = glm::dot(d, d), b = -glm::dot(f, d), r = radius;
    const LongVector toLine = f + b / a * d;
    const long double l2 = glm::dot(toLine, toLine);
    clearance = 1.0L - std::sqrt(l2) / r;
    t = (b - std::sqrt(std::max(a * (r * r - l2), 0.0L))) / a;
  }
};

bool meets(const Ray& ray, const Point& centre, float radius, float& t) {
  FlatScene scene;
  scene.shapes.resize(1);
  scene.spheres.push_back({{centre.x, centre.y, centre.z}, radius, 0, 0});
  PrimitiveHit hit;
  const bool met = FlatIntersector(viewOf(scene)).closest(ray, hit);
  t = hit.t;
  return met;
}

// Errors of t in units of the rounding of the distance.
TEST(Trap, SphereFarAwayIsHitWhereItIs) {
  for (const float distance : {1e4f, 1e5f}) {
    Uniforms random(1301);
    Errors<Worst> errors;
    int rays = 0, naiveMissed = 0, shippedMissed = 0;
    for (int i = 0; i < 20000; ++i) {
      const Point centre = distance * randomUnit(random);
      const glm::dvec3 target =
          glm::dvec3(centre) + 0.9 * random.nextDouble() * glm::dvec3(randomUnit(random));
      const Ray ray{Point(0), Vector(glm::normalize(target))};
      const SphereHit exact(ray, centre, 1.0f);
      if (exact.clearance < 0.05L) continue;
      ++rays;
      const float naive = naiveSphere(ray, centre, 1.0f);
      float shipped = 0.0f;
      const auto error = [&](float t) {
        return std::abs(double{t} - double(exact.t)) / (kRoundoff * double{distance});
      };
      if (naive > 0.0f) errors.naive.add(error(naive));
      naiveMissed += naive > 0.0f ? 0 : 1;
      if (meets(ray, centre, 1.0f, shipped))
        errors.shipped.add(error(shipped));
      else
        ++shippedMissed;
    }
    const std::string where = ", distance " + std::to_string(distance);
    expectTrap("t, roundoffs" + where, errors, 20.0);
    expectTrap("share of missed spheres" + where, double(naiveMissed) / rays,
               double(shippedMissed) / rays, 0.0);
  }
}

// A ground that is a sphere, seen from above: the roots nearly cancel. Relative errors of t; from
// above the pole, where the height is known exactly.
TEST(Trap, SphereThatIsLargeIsHitWhereItIs) {
  for (const float radius : {1e4f, 1e5f}) {
    Uniforms random(1304);
    Errors<Worst> errors;
    for (int i = 0; i < 20000; ++i) {
      const Point centre(0.0f, -radius, 0.0f), origin(0.0f, 1.0f + float(i % 8), 0.0f);
      const Ray ray{origin, atCosine({0, -1, 0}, random.between(0.2, 1.0), random.between(0, 6))};
      const SphereHit exact(ray, centre, radius);
      float shipped = 0.0f;
      ASSERT_TRUE(meets(ray, centre, radius, shipped));
      errors.add(relativeError(naiveSphere(ray, centre, radius), exact.t),
                 relativeError(shipped, exact.t));
    }
    expectTrap("t, relative, radius " + std::to_string(radius), errors, 1e-5);
  }
}

// Twice the area of the triangle 0 a b in the plane: the sign says on which side of the line
// through a and b the origin lies. Opposite for b a, or a ray on the line slips through or is met
// twice.
[[gnu::noinline]] float edgeFunction(const vec2& a, const vec2& b) { return a.x * b.y - a.y * b.x; }

[[gnu::noinline]] float contracted(const vec2& a, const vec2& b) {
  return std::fma(a.x, b.y, -(a.y * b.x));
}

#ifdef __FAST_MATH__
#error "-ffast-math reorders sums and takes away what is no number."
#endif

// What the compiler makes of it is tested: this file has the flags of everything else.
TEST(Trap, EdgeFunctionsAreNotContracted) {
  constexpr int kEdges = 100000;
  Uniforms random(1302);
  int naiveSame = 0, shippedSame = 0;
  for (int i = 0; i < kEdges; ++i) {
    const glm::dvec2 a(random.between(-1, 1), random.between(-1, 1));
    const vec2 p(a), q(a * -random.between(0.1, 1.0));  // the origin between them, up to rounding
    naiveSame += contracted(p, q) * contracted(q, p) > 0.0f ? 1 : 0;
    shippedSame += edgeFunction(p, q) * edgeFunction(q, p) > 0.0f ? 1 : 0;
    ASSERT_EQ(edgeFunction(p, q), -edgeFunction(q, p));
  }
  EXPECT_EQ(shippedSame, 0);
  expectTrap("share of edges with one sign", double(naiveSame) / kEdges,
             double(shippedSame) / kEdges, 0.1);
}

// Moeller & Trumbore, each triangle by itself.
bool naiveTriangle(const Ray& ray, const std::array<Point, 3>& p) {
  const Vector e1 = p[1] - p[0], e2 = p[2] - p[0], q = cross(ray.direction, e2);
  const float determinant = dot(e1, q);
  if (determinant == 0.0f) return false;
  const Vector s = ray.origin - p[0], r = cross(s, e1);
  const float b1 = dot(s, q) / determinant, b2 = dot(ray.direction, r) / determinant;
  return b1 >= 0.0f && b2 >= 0.0f && b1 + b2 <= 1.0f && dot(e2, r) / determinant > 0.0f;
}

FlatIntersector intersectorOf(const std::array<Point, 3>& p) {
  FlatScene scene;
  scene.shapes.resize(1);
  const Vector n = normalize(cross(p[1] - p[0], p[2] - p[0]));
  const auto float3 = [](const Vector& v) { return Float3{v.x, v.y, v.z}; };
  scene.addTriangle({float3(p[0]), float3(p[1]), float3(p[2])}, float3(n), 0);
  return FlatIntersector(viewOf(scene));
}

// Two triangles that share an edge with opposite orientation, and rays at the edge: one of them
// must be met. Both may be, where an edge function is exactly 0, which it is for one ray in twenty.
TEST(Trap, SharedEdgesDoNotLeak) {
  Uniforms random(1303);
  const auto point = [&](double x, double y) {
    return Point(glm::dvec3(x + random.between(-0.3, 0.3), y + random.between(-0.3, 0.3),
                            random.between(-0.3, 0.3)));
  };
  int naiveLeaks = 0, shippedLeaks = 0, naiveTwice = 0, shippedTwice = 0, rays = 0;
  for (int pair = 0; pair < 500; ++pair) {
    const Point a = point(0, -1), b = point(0, 1);
    const std::array<Point, 3> left{a, b, point(-1, 0)}, right{b, a, point(1, 0)};
    const FlatIntersector first = intersectorOf(left), second = intersectorOf(right);
    for (int k = 0; k < 400; ++k, ++rays) {
      const glm::dvec3 target = glm::mix(glm::dvec3(a), glm::dvec3(b), random.between(0.01, 0.99));
      const Point origin = Point(glm::dvec3(random.between(-1, 1), random.between(-1, 1), 4.0));
      const Ray ray{origin, Vector(glm::normalize(target - glm::dvec3(origin)))};
      PrimitiveHit hit;
      const int shipped = (first.closest(ray, hit) ? 1 : 0) + (second.closest(ray, hit) ? 1 : 0);
      const int naive = (naiveTriangle(ray, left) ? 1 : 0) + (naiveTriangle(ray, right) ? 1 : 0);
      naiveLeaks += naive == 0 ? 1 : 0;
      shippedLeaks += shipped == 0 ? 1 : 0;
      naiveTwice += naive == 2 ? 1 : 0;
      shippedTwice += shipped == 2 ? 1 : 0;
    }
  }
  expectTrap("leaks of 200,000 rays", naiveLeaks, shippedLeaks, 0.0);
  expectTrap("share of double hits", double(naiveTwice) / rays, double(shippedTwice) / rays, 0.1);
}

}  // namespace
}  // namespace pathmark
