// Pairs of triangles, flat and folded, against each triangle by itself in long double.
#include "intersect/triangle_blocks.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <optional>

namespace pathmark::test {
namespace {

using Real = long double;
using Vector3 = glm::vec<3, Real, glm::defaultp>;

TriangleBlocks blocksOf(const ShapeScene& scene) { return {scene.view(), scene.allTriangles()}; }

struct Meeting {
  bool met = false, clear = false;  // clear: not by a hair
  Real t = 0;
};

Meeting meet(const ShapeScene& scene, std::size_t index, const Ray& ray) {
  const FlatTriangle& triangle = scene.triangles[index];
  const auto corners = scene.view().corners(triangle);
  const auto corner = [&](std::size_t k) {
    return Vector3(corners[k][0], corners[k][1], corners[k][2]);
  };
  const Vector3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), n = glm::cross(e1, e2);
  const Vector3 o(ray.origin), d(ray.direction);
  const Real slope = glm::dot(n, d) / glm::length(n);
  Meeting meeting;
  meeting.t = glm::dot(corner(0) - o, n) / glm::dot(n, d);
  const Vector3 p = o + meeting.t * d - corner(0);
  const Real area = glm::dot(n, n);
  const Real b1 = glm::dot(glm::cross(p, e2), n) / area, b2 = glm::dot(glm::cross(e1, p), n) / area;
  const Real inside = std::min({b1, b2, 1 - b1 - b2});
  meeting.met = inside >= 0 && meeting.t > 0 && (slope < 0 || !scene.view().frontOnly(triangle));
  meeting.clear =
      std::abs(slope) > 1e-3L && (std::abs(inside) > 1e-3L || std::abs(meeting.t) > 100);
  meeting.clear = meeting.clear && std::abs(meeting.t) > 1e-3L;
  return meeting;
}

struct Expected {
  std::size_t index = 0;
  Real t = 0;
};

// Nothing if some decision is by a hair, an index beyond the last if nothing is met.
std::optional<Expected> nearest(const ShapeScene& scene, const Ray& ray) {
  Expected expected{scene.triangles.size(), 0};
  Real second = 0;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const Meeting meeting = meet(scene, i, ray);
    if (!meeting.clear) return {};
    if (!meeting.met) continue;
    if (expected.index == scene.triangles.size() || meeting.t < expected.t) {
      second = expected.index == scene.triangles.size() ? meeting.t + 1 : expected.t;
      expected = {i, meeting.t};
    } else {
      second = std::min(second, meeting.t);
    }
  }
  if (expected.index != scene.triangles.size() && second - expected.t < 1e-4L) return {};
  return expected;
}

// Triangles a b c and a c d with any angle between them; d near b in every third: the pair is
// folded up and one ray meets both.
void addFoldedPair(ShapeScene& scene, RandomNumbers& random, std::uint32_t shape) {
  const vec3 a = random.inCube(1.0f), c = a + random.inCube(1.0f);
  const vec3 b = a + random.inCube(1.0f);
  const bool folded = random.below(3) == 0;
  const vec3 d = folded ? b + random.inCube(0.1f) : a + random.inCube(1.0f);
  scene.addQuad(a, b, c, d, shape);
}

enum class Sides { kBoth, kFronts, kMixed };

// So that a test can tell whether it has tested anything.
struct Tally {
  int met = 0, missed = 0, both = 0;
};

// By rays towards the parallelograms of which the triangles are one half.
void expectNearest(const ShapeScene& scene, RandomNumbers& random, int rays, Tally& tally) {
  const TriangleBlocks blocks = blocksOf(scene);
  for (int k = 0; k < rays; ++k) {
    const auto corners =
        scene.view().corners(scene.triangles[random.below(scene.triangles.size())]);
    vec3 target(0.0f);
    const float u = random.uniform(0, 1), v = random.uniform(0, 1);
    for (std::size_t axis = 0; axis < 3; ++axis)
      target[static_cast<int>(axis)] =
          corners[0][axis] * (1 - u - v) + corners[1][axis] * u + corners[2][axis] * v;
    const vec3 origin = random.inCube(3.0f);
    const Ray ray{origin, normalize(target - origin)};
    const std::optional<Expected> expected = nearest(scene, ray);
    if (!expected) continue;
    const bool met = expected->index < scene.triangles.size();
    PrimitiveHit hit;
    ASSERT_EQ(blocks.closest(ray, kInfinity, hit), met);
    ++(met ? tally.met : tally.missed);
    if (!met) {
      EXPECT_FALSE(blocks.occluded(origin, 20.0f * ray.direction));
      continue;
    }
    ASSERT_EQ(hit.index, expected->index);
    EXPECT_FALSE(hit.isSphere);
    EXPECT_NEAR(static_cast<double>(hit.t / expected->t), 1.0, 1e-3);
    // The other triangle of the pair is met as well.
    tally.both += meet(scene, expected->index ^ 1u, ray).met ? 1 : 0;
    EXPECT_FALSE(blocks.occluded(origin, hit.t * 0.9999f * ray.direction));
    EXPECT_TRUE(blocks.occluded(origin, hit.t * 1.0001f * ray.direction));
    PrimitiveHit untouched{77.0f, 77, true};
    EXPECT_FALSE(blocks.closest(ray, hit.t * 0.9999f, untouched));
    EXPECT_EQ(untouched.index, 77u);
  }
}

TEST(TriangleBlocks, MeetTheNearestTriangleOfPairsFoldedAtAnyAngle) {
  RandomNumbers random(7);
  // One pair, a full block, and several blocks.
  for (const std::size_t pairs : {std::size_t{1}, kLanes, kLanes + 1, 3 * kLanes}) {
    for (const Sides sides : {Sides::kBoth, Sides::kFronts, Sides::kMixed}) {
      Tally tally;
      for (int scenes = 0; scenes < 100; ++scenes) {
        ShapeScene scene;
        for (std::size_t k = 0; k < pairs; ++k)
          addFoldedPair(scene, random,
                        sides == Sides::kBoth     ? 0u
                        : sides == Sides::kFronts ? 1u
                                                  : static_cast<std::uint32_t>(k % 2));
        expectNearest(scene, random, 100, tally);
      }
      EXPECT_GT(tally.met, 1000);
      EXPECT_GT(tally.missed, 100);
      // Of a pair folded up, a ray sees one front and one back.
      if (sides == Sides::kFronts) {
        EXPECT_EQ(tally.both, 0);
      } else {
        EXPECT_GT(tally.both, 50);
      }
    }
  }
}

TEST(TriangleBlocks, NoRayPassesBetweenTheTrianglesOfAPair) {
  RandomNumbers random(8);
  for (int k = 0; k < 100000; ++k) {
    const vec3 a = random.inCube(1.0f), c = a + random.direction();
    const vec3 across = normalize(cross(c - a, random.direction()));
    const vec3 up = normalize(cross(c - a, across));
    ShapeScene scene;
    scene.addQuad(a, a - across + random.uniform(-0.5f, 0.5f) * up, c,
                  a + across + random.uniform(-0.5f, 0.5f) * up);
    const vec3 target = a + random.uniform(0.0f, 1.0f) * (c - a);
    const vec3 origin = target + 3.0f * up + random.inCube(1.0f);
    const TriangleBlocks blocks = blocksOf(scene);
    PrimitiveHit hit;
    ASSERT_TRUE(blocks.closest({origin, normalize(target - origin)}, kInfinity, hit));
    ASSERT_NEAR(hit.t, length(target - origin), 1e-5f);
    ASSERT_TRUE(blocks.occluded(origin, 1.001f * (target - origin)));
  }
}

TEST(TriangleBlocks, RaysInThePlaneOfATriangleMeetNothing) {
  for (const std::uint32_t shape : {ShapeScene::kTwoSided, ShapeScene::kFrontOnly}) {
    ShapeScene scene;
    // Folded along the z axis, in planes of coordinates.
    scene.addQuad({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, shape);
    const TriangleBlocks blocks = blocksOf(scene);
    const std::array<Ray, 4> rays{{{{0, 0, -1}, {0, 0, 1}},           // along the common edge
                                   {{0, 0, 0.5f}, {0, 0, 1}},         // from within it
                                   {{0.25f, 0, -1}, {0, 0, 1}},       // in one plane
                                   {{0.25f, 0, 0.25f}, {0, 0, 1}}}};  // from within a triangle
    for (std::size_t k = 0; k < rays.size(); ++k) {
      PrimitiveHit hit;
      EXPECT_FALSE(blocks.closest(rays[k], kInfinity, hit)) << k;
      EXPECT_FALSE(blocks.occluded(rays[k].origin, 4.0f * rays[k].direction)) << k;
    }
  }
}

TEST(TriangleBlocks, TrianglesWithoutAreaAreMetByNoRay) {
  ShapeScene scene;
  const vec3 a(0, 0, 0), b(1, 0, 0);
  scene.addTriangle(a, a, a);
  scene.addTriangle(a, b, a);
  scene.addTriangle(a, 0.5f * b, b);
  scene.addTriangle(b, a, {0.5f, 1, 0});
  const TriangleBlocks blocks = blocksOf(scene);
  RandomNumbers random(9);
  for (int k = 0; k < 10000; ++k) {
    const vec3 target = random.uniform(0.0f, 1.0f) * b;
    const vec3 origin = target + random.inCube(1.0f);
    PrimitiveHit hit;
    if (blocks.closest({origin, normalize(target - origin)}, kInfinity, hit)) {
      EXPECT_EQ(hit.index, 3u);
    }
  }
  PrimitiveHit hit;
  EXPECT_TRUE(blocks.closest({{0.5f, 0.25f, 1}, {0, 0, -1}}, kInfinity, hit));
}

TEST(TriangleBlocks, OfNoTrianglesAreEmpty) {
  const TriangleBlocks blocks = blocksOf(ShapeScene{});
  PrimitiveHit hit;
  EXPECT_TRUE(blocks.empty());
  EXPECT_FALSE(blocks.closest({{0, 0, 0}, {0, 0, 1}}, kInfinity, hit));
  EXPECT_FALSE(blocks.occluded({0, 0, 0}, {0, 0, 1}));
}

}  // namespace
}  // namespace pathmark::test
