// The flat intersector against the same geometry in long double, and at its edges.
#include "intersect/flat_intersector.h"
#include "math/rounding.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace pathmark::test {
namespace {

using Real = long double;
using Vector3 = glm::vec<3, Real, glm::defaultp>;

Float3 toFloat3(const vec3& v) { return {v.x, v.y, v.z}; }

struct TestScene : FlatScene {
  TestScene() { shapes.resize(1); }

  void addTriangle(const vec3& a, const vec3& b, const vec3& c) {
    const vec3 n = normalize(cross(b - a, c - a));
    FlatScene::addTriangle({toFloat3(a), toFloat3(b), toFloat3(c)}, toFloat3(n), 0);
  }
  std::array<Float3, 3> corners(std::size_t triangle) const {
    return viewOf(*this).corners(triangles[triangle]);
  }
  FlatIntersector build() const { return FlatIntersector(viewOf(*this)); }
};

class Random {
 public:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  vec3 inCube(float half) {
    return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
  }
  vec3 direction() {
    for (;;) {
      const vec3 v = inCube(1.0f);
      if (length(v) > 0.1f && length(v) < 1.0f) return normalize(v);
    }
  }

 private:
  std::mt19937 engine_{12345};
};

// Distance along the ray, and how clear the decision is: the smallest of |u|, |v|, |w| relative to
// their sum, and the sine of the angle to the plane.
struct Oracle {
  Real t = 0, clarity = 0;
  bool hit = false;
};

Oracle oracleTriangle(const std::array<Float3, 3>& corners, const Ray& ray) {
  const auto corner = [&](std::size_t k) {
    return Vector3(corners[k][0], corners[k][1], corners[k][2]);
  };
  const Vector3 o(ray.origin), d(ray.direction), e1 = corner(1) - corner(0),
                                                 e2 = corner(2) - corner(0);
  const Vector3 q = glm::cross(d, e2);
  const Real determinant = glm::dot(e1, q);
  const Vector3 s = o - corner(0), r = glm::cross(s, e1);
  const Real b1 = glm::dot(s, q) / determinant, b2 = glm::dot(d, r) / determinant;
  const Real sine = std::abs(determinant) / glm::length(glm::cross(e1, e2));
  Oracle oracle;
  oracle.t = glm::dot(e2, r) / determinant;
  oracle.hit = b1 >= 0 && b2 >= 0 && b1 + b2 <= 1 && oracle.t > 0;
  oracle.clarity = std::min({std::abs(b1), std::abs(b2), std::abs(1 - b1 - b2), sine});
  return oracle;
}

TEST(FlatIntersector, FindsTheNearestOfManyTriangles) {
  Random random;
  TestScene scene;
  for (int k = 0; k < 53; ++k) {
    const vec3 a = random.inCube(10.0f);
    scene.addTriangle(a, a + random.inCube(4.0f), a + random.inCube(4.0f));
  }
  const FlatIntersector intersector = scene.build();
  int hits = 0, unclear = 0;
  for (int k = 0; k < 100000; ++k) {
    const Ray ray{random.inCube(12.0f), random.direction()};
    Real nearest = 0;
    std::size_t expected = scene.triangles.size();
    bool clear = true;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
      const Oracle oracle = oracleTriangle(scene.corners(i), ray);
      clear = clear && (oracle.clarity > 1e-4L || oracle.t < -0.1L);
      if (oracle.hit && (expected == scene.triangles.size() || oracle.t < nearest)) {
        nearest = oracle.t;
        expected = i;
      }
    }
    if (!clear) {
      ++unclear;
      continue;
    }
    PrimitiveHit hit;
    ASSERT_EQ(intersector.closest(ray, hit), expected != scene.triangles.size());
    if (expected == scene.triangles.size()) continue;
    ++hits;
    EXPECT_EQ(hit.index, expected);
    EXPECT_NEAR(static_cast<double>(hit.t / nearest), 1.0, 1e-3);
  }
  EXPECT_GT(hits, 10000);
  EXPECT_LT(unclear, 10000);
}

// Rays from inside a closed mesh, straight at its vertices and edges: none may get out.
TEST(FlatIntersector, NoRayLeaksThroughEdgesAndVertices) {
  constexpr int kRings = 9, kSegments = 14;
  std::vector<vec3> points;
  for (int i = 0; i <= kRings; ++i)
    for (int j = 0; j < kSegments; ++j) {
      const float theta = kPi * static_cast<float>(i) / kRings;
      const float phi = 2.0f * kPi * static_cast<float>(j) / kSegments;
      points.emplace_back(1.3f * std::sin(theta) * std::cos(phi) + 0.3f,
                          0.8f * std::cos(theta) - 0.2f, std::sin(theta) * std::sin(phi) + 5.0f);
    }
  // Poles and the seam are shared exactly: the closed mesh has no gap but rounding's.
  for (int j = 0; j < kSegments; ++j) {
    points[static_cast<std::size_t>(j)] = points[0];
    points[static_cast<std::size_t>(kRings * kSegments + j)] = points[kRings * kSegments];
  }
  TestScene scene;
  const auto at = [&](int i, int j) {
    return points[static_cast<std::size_t>(i * kSegments + j % kSegments)];
  };
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSegments; ++j) {
      if (i > 0) scene.addTriangle(at(i, j), at(i, j + 1), at(i + 1, j));
      if (i + 1 < kRings) scene.addTriangle(at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
  const FlatIntersector intersector = scene.build();
  Random random;
  for (int k = 0; k < 400000; ++k) {
    const auto p = scene.corners(static_cast<std::size_t>(k) % scene.triangles.size());
    const vec3 a(p[0][0], p[0][1], p[0][2]), b(p[1][0], p[1][1], p[1][2]);
    const vec3 origin = vec3(0.3f, -0.2f, 5.0f) + random.inCube(0.3f);
    const vec3 target = k % 7 == 0 ? a : a + random.uniform(0.0f, 1.0f) * (b - a);
    PrimitiveHit hit;
    ASSERT_TRUE(intersector.closest({origin, normalize(target - origin)}, hit));
    ASSERT_TRUE(intersector.occluded(origin, 2.0f * (target - origin)));
  }
}

TEST(FlatIntersector, BothSidesAreHitUnlessOnlyTheFrontIsThere) {
  TestScene scene;
  scene.addTriangle({-1, 0, 1}, {1, 0, 1}, {0, 0, -1});  // front towards +y
  for (const std::uint32_t frontOnly : {0u, 1u}) {
    scene.shapes[0].frontOnly = frontOnly;
    const FlatIntersector intersector = scene.build();
    PrimitiveHit hit;
    for (const vec3 tilt : {vec3(0), vec3(0.2f, 0, 0.1f), vec3(-0.1f, 0, -0.3f)}) {
      const vec3 above = vec3(0, 2, 0) + 2.0f * tilt;
      EXPECT_TRUE(intersector.closest({above, normalize(-above)}, hit));
      EXPECT_TRUE(intersector.occluded(above, -2.0f * above));
      EXPECT_EQ(intersector.closest({-above, normalize(above)}, hit), frontOnly == 0);
      EXPECT_EQ(intersector.occluded(-above, 2.0f * above), frontOnly == 0);
    }
  }
}

TEST(FlatIntersector, SidesOfSpheresAreHiddenByFrontOnlyAndInward) {
  PrimitiveHit hit;
  for (const bool inward : {false, true}) {
    TestScene scene;
    scene.spheres.push_back({{0, 0, 0}, 1.0f, 0, inward ? 1u : 0u});
    scene.shapes[0].frontOnly = 1;
    const FlatIntersector intersector = scene.build();
    ASSERT_TRUE(intersector.closest({{0, 0, -3}, {0, 0, 1}}, hit));
    EXPECT_FLOAT_EQ(hit.t, inward ? 4.0f : 2.0f);
    EXPECT_EQ(intersector.closest({{0, 0, 0}, {0, 0, 1}}, hit), inward);
  }
}

// Haines et al. 2019: the textbook quadratic loses all digits here.
TEST(FlatIntersector, FarAndLargeSpheresAreHitWhereTheyAre) {
  Random random;
  for (const float distance : {1.0f, 1e2f, 1e4f, 1e6f})
    for (const float radius : {1e-3f, 1.0f, 1e3f, 1e5f}) {
      TestScene scene;
      scene.spheres.push_back({{0, 0, distance + radius}, radius, 0, 0});
      const FlatIntersector intersector = scene.build();
      for (int k = 0; k < 1000; ++k) {
        const float offset = random.uniform(-0.9f, 0.9f) * radius;
        const Ray ray{{offset, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
        PrimitiveHit hit;
        ASSERT_TRUE(intersector.closest(ray, hit)) << distance << " " << radius;
        const Real c = static_cast<Real>(distance + radius), r = radius, x = offset;
        const Real exact = c - std::sqrt(r * r - x * x);
        // A few roundings of the largest length involved.
        EXPECT_NEAR(static_cast<double>(hit.t), static_cast<double>(exact),
                    8.0 * 0x1p-24 * static_cast<double>(distance + 2.0f * radius))
            << distance << " " << radius;
      }
    }
}

TEST(FlatIntersector, OcclusionEndsWithTheSegment) {
  TestScene scene;
  scene.addTriangle({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  scene.spheres.push_back({{0, 0, 5}, 1.0f, 0, 0});
  const FlatIntersector intersector = scene.build();
  EXPECT_FALSE(intersector.occluded({0, 0, 0}, {0, 0, 1.99f}));
  EXPECT_TRUE(intersector.occluded({0, 0, 0}, {0, 0, 2.01f}));
  EXPECT_FALSE(intersector.occluded({0, 0, 2.5f}, {0, 0, 1.49f}));
  EXPECT_TRUE(intersector.occluded({0, 0, 2.5f}, {0, 0, 1.51f}));
  EXPECT_FALSE(intersector.occluded({0, 0, 2.5f}, {0, 0, -0.49f}));
}

TEST(FlatIntersector, NothingIsHitInAnEmptySceneNorByNonsense) {
  PrimitiveHit hit;
  EXPECT_FALSE(TestScene{}.build().closest({{0, 0, 0}, {0, 0, 1}}, hit));
  TestScene scene;
  scene.addTriangle({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  scene.addTriangle({0, 0, 1}, {0, 0, 1}, {0, 0, 1});  // no area
  scene.spheres.push_back({{0, 0, 5}, 1.0f, 0, 0});
  const FlatIntersector intersector = scene.build();
  const float nan = std::nanf("");
  EXPECT_FALSE(intersector.closest({{0, 0, 0}, {nan, 0, 1}}, hit));
  EXPECT_FALSE(intersector.closest({{nan, 0, 0}, {0, 0, 1}}, hit));
  EXPECT_FALSE(intersector.closest({{0, 0, 0}, {0, 0, 0}}, hit));
  ASSERT_TRUE(intersector.closest({{0, 0, 0}, {0, 0, 1}}, hit));
  EXPECT_FLOAT_EQ(hit.t, 2.0f);
}

}  // namespace
}  // namespace pathmark::test
