// The hierarchy against the flat loop, which has its own oracle, and at its edges.
#include "intersect/embree_intersector.h"
#include "intersect/flat_intersector.h"
#include "math/rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace pathmark::test {
namespace {

Float3 toFloat3(const vec3& v) { return {v.x, v.y, v.z}; }

class Random {
 public:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  vec3 inCube(float half) {
    return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
  }

 private:
  std::mt19937 engine_{4711};
};

void addTriangle(FlatScene& scene, const vec3& a, const vec3& b, const vec3& c,
                 std::uint32_t shape) {
  scene.addTriangle({toFloat3(a), toFloat3(b), toFloat3(c)},
                    toFloat3(normalize(cross(b - a, c - a))), shape);
}

// Shape 0 is seen from both sides, shape 1 from the front only.
FlatScene randomTriangles(int count) {
  FlatScene scene;
  scene.shapes.resize(2);
  scene.shapes[1].frontOnly = 1;
  Random random;
  for (int k = 0; k < count; ++k) {
    const vec3 at = random.inCube(1.0f);
    addTriangle(scene, at, at + random.inCube(0.2f), at + random.inCube(0.2f),
                static_cast<std::uint32_t>(k % 2));
  }
  return scene;
}

// Rays that graze an edge or meet two triangles at almost one place may go either way. Rays and
// triangles are made of the same numbers: some rays start at a vertex, which is no hit at t > 0.
TEST(EmbreeIntersector, MeetsWhatTheFlatLoopMeets) {
  const FlatScene scene = randomTriangles(500);
  const FlatIntersector flat(viewOf(scene));
  const EmbreeIntersector embree(viewOf(scene));
  Random random;
  int met = 0, different = 0;
  constexpr int kRays = 100000;
  for (int k = 0; k < kRays; ++k) {
    const Ray ray{random.inCube(1.0f), normalize(random.inCube(1.0f))};
    PrimitiveHit expected, found;
    const bool hit = flat.closest(ray, expected);
    met += hit ? 1 : 0;
    const bool same = embree.closest(ray, kInfinity, found) == hit &&
                      (!hit || (found.index == expected.index &&
                                std::abs(found.t - expected.t) <= 1e-5f * (1.0f + expected.t)));
    different += same ? 0 : 1;
    const vec3 segment = random.inCube(3.0f);
    different += embree.occluded(ray.origin, segment) == flat.occluded(ray.origin, segment) ? 0 : 1;
  }
  EXPECT_GT(met, kRays / 10);
  EXPECT_LE(different, kRays / 10000);
}

// Of a packed scene the vertices are not copied.
TEST(EmbreeIntersector, MeetsTheSameInAPackedScene) {
  FlatScene scene = randomTriangles(500);
  scene.materials.resize(1);
  const std::vector<std::byte> block = packScene(scene);
  const auto view = viewScene(block);
  ASSERT_TRUE(view);
  const EmbreeIntersector packed(*view), apart(viewOf(scene));
  Random random;
  for (int k = 0; k < 20000; ++k) {
    const Ray ray{random.inCube(1.0f), normalize(random.inCube(1.0f))};
    PrimitiveHit expected, found;
    ASSERT_EQ(packed.closest(ray, kInfinity, found), apart.closest(ray, kInfinity, expected));
    ASSERT_EQ(found.index, expected.index);
    ASSERT_EQ(found.t, expected.t);
    const vec3 segment = random.inCube(3.0f);
    ASSERT_EQ(packed.occluded(ray.origin, segment), apart.occluded(ray.origin, segment));
  }
}

// A triangle of this height and of length 1 somewhere in a cube, moved from its own plane along the
// normal as the ends of shadow rays are.
struct LoneTriangle {
  FlatScene scene;
  vec3 corner, along, up, normal;

  LoneTriangle(Random& random, float height) : corner(random.inCube(1.0f)) {
    along = normalize(random.inCube(1.0f));
    normal = normalize(cross(along, random.inCube(1.0f)));
    up = height * cross(normal, along);
    scene.shapes.resize(1);
    addTriangle(scene, corner, corner + along, corner + 0.3f * along + up, 0);
    const Float3& n = scene.triangles[0].normal;
    normal = vec3(n[0], n[1], n[2]);
  }

  vec3 pointNear(Random& random) const {
    const float y = random.uniform(0.01f, 0.9f), x = random.uniform(0.3f * y, 1.0f - 0.7f * y);
    const vec3 p = corner + x * along + y * up;
    const float magnitude = std::max(largestComponent(p), largestComponent(corner));
    return p - dot(p - corner, normal) * normal + offsetForMagnitude(magnitude) * normal;
  }
};

TEST(EmbreeIntersector, NoTriangleIsInTheWayOfSegmentsThatEndBesideIt) {
  Random random;
  for (const float height : {0.9f, 0.5f, 0.3f, 0.1f, 1e-2f, 1e-3f, 1e-4f}) {
    int occluded = 0;
    for (int k = 0; k < 300; ++k) {
      const LoneTriangle triangle(random, height);
      const EmbreeIntersector embree(viewOf(triangle.scene));
      for (int i = 0; i < 200; ++i) {
        const vec3 from = triangle.pointNear(random);
        // Level to the last digit: cosines go down to 1e-6.
        vec3 level = normalize(cross(triangle.normal, random.inCube(1.0f)));
        level -= dot(level, triangle.normal) * triangle.normal;
        const float cosine = std::pow(10.0f, random.uniform(-6.0f, 0.0f));
        const vec3 to = from + random.uniform(0.01f, 3.0f) * (level + cosine * triangle.normal);
        occluded += embree.occluded(from, to - from) ? 1 : 0;
        occluded += embree.occluded(to, from - to) ? 1 : 0;
      }
    }
    EXPECT_EQ(occluded, 0) << height;
  }
}

TEST(EmbreeIntersector, LooksNoFartherThanItIsTold) {
  FlatScene scene;
  scene.shapes.resize(1);
  addTriangle(scene, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2}, 0);
  const EmbreeIntersector embree(viewOf(scene));
  PrimitiveHit hit;
  hit.index = 77;
  EXPECT_FALSE(embree.closest({{0, 0, 0}, {0, 0, 1}}, 1.99f, hit));
  EXPECT_EQ(hit.index, 77u);
  ASSERT_TRUE(embree.closest({{0, 0, 0}, {0, 0, 1}}, 2.01f, hit));
  EXPECT_EQ(hit.index, 0u);
  EXPECT_FLOAT_EQ(hit.t, 2.0f);
  EXPECT_FALSE(embree.occluded({0, 0, 0}, {0, 0, 1.99f}));
  EXPECT_TRUE(embree.occluded({0, 0, 0}, {0, 0, 2.01f}));
}

TEST(EmbreeIntersector, NoRaySlipsThroughASharedEdge) {
  constexpr int kSide = 40;
  FlatScene scene;
  scene.shapes.resize(1);
  Random random;
  std::vector<vec3> points;
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j) {
      points.emplace_back(i, j, random.uniform(-0.3f, 0.3f));
    }
  }
  const auto at = [&](int i, int j) {
    return points[static_cast<std::size_t>(i * (kSide + 1) + j)];
  };
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      addTriangle(scene, at(i, j), at(i + 1, j), at(i + 1, j + 1), 0);
      addTriangle(scene, at(i, j), at(i + 1, j + 1), at(i, j + 1), 0);
    }
  }
  const EmbreeIntersector embree(viewOf(scene));
  for (int k = 0; k < 300000; ++k) {
    const int i = 1 + k % (kSide - 2), j = 1 + (k / kSide) % (kSide - 2);
    const vec3 a = at(i, j), b = k % 2 == 0 ? at(i + 1, j) : at(i + 1, j + 1);
    const vec3 target = k % 7 == 0 ? a : a + random.uniform(0.0f, 1.0f) * (b - a);
    const vec3 origin = target + vec3(random.uniform(-1, 1), random.uniform(-1, 1), 9.0f);
    PrimitiveHit hit;
    ASSERT_TRUE(embree.closest({origin, normalize(target - origin)}, kInfinity, hit));
    ASSERT_TRUE(embree.occluded(origin, 2.0f * (target - origin)));
  }
}

TEST(EmbreeIntersector, NonsenseMeetsNothing) {
  const FlatScene scene = randomTriangles(200);
  const EmbreeIntersector embree(viewOf(scene));
  PrimitiveHit hit;
  for (const float bad : {std::nanf(""), kInfinity, -kInfinity}) {
    EXPECT_FALSE(embree.closest({{0, 0, 0}, {bad, 0, 1}}, kInfinity, hit));
    EXPECT_FALSE(embree.closest({{bad, 0, 0}, {0, 0, 1}}, kInfinity, hit));
    EXPECT_FALSE(embree.occluded({0, bad, 0}, {0, 0, 1}));
    EXPECT_FALSE(embree.occluded({0, 0, 0}, {0, 0, bad}));
  }
  EXPECT_FALSE(embree.closest({{0, 0, 0}, {0, 0, 0}}, kInfinity, hit));
}

}  // namespace
}  // namespace pathmark::test
