// Triangles as quads: that they stay the same triangles, and that hits tell which.
#include "intersect/quad_mesh.h"
#include "intersect/embree_intersector.h"
#include "intersect/flat_intersector.h"
#include "math/rounding.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pathmark::test {
namespace {

Float3 toFloat3(const vec3& v) { return {v.x, v.y, v.z}; }

vec3 toVec3(const Float3& a) { return {a[0], a[1], a[2]}; }

void addTriangle(FlatScene& scene, std::array<std::uint32_t, 3> vertex, std::uint32_t shape) {
  const vec3 a = toVec3(scene.vertices[vertex[0]]), b = toVec3(scene.vertices[vertex[1]]),
             c = toVec3(scene.vertices[vertex[2]]);
  scene.triangles.push_back({vertex, shape, toFloat3(normalize(cross(b - a, c - a)))});
}

constexpr std::uint32_t kSide = 30;

enum class Order { kPairs, kSomePairs, kNoPairs };

// A height field. Shape 0 is seen from both sides, shape 1 from the front only.
FlatScene heightField(Order order, std::uint32_t shape) {
  RandomNumbers random(5);
  FlatScene scene;
  scene.shapes.resize(2);
  scene.shapes[1].frontOnly = 1;
  for (std::uint32_t i = 0; i <= kSide; ++i)
    for (std::uint32_t j = 0; j <= kSide; ++j)
      scene.vertices.push_back(
          {static_cast<float>(i), static_cast<float>(j), random.uniform(-0.5f, 0.5f)});
  const auto at = [](std::uint32_t i, std::uint32_t j) { return i * (kSide + 1) + j; };
  std::vector<std::array<std::uint32_t, 3>> lower, upper;
  for (std::uint32_t i = 0; i < kSide; ++i)
    for (std::uint32_t j = 0; j < kSide; ++j) {
      lower.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      upper.push_back({at(i + 1, j + 1), at(i, j + 1), at(i, j)});
    }
  if (order == Order::kNoPairs) {
    for (const auto& t : lower) addTriangle(scene, t, shape);
    for (const auto& t : upper) addTriangle(scene, t, shape);
    return scene;
  }
  for (std::size_t k = 0; k < lower.size(); ++k) {
    addTriangle(scene, lower[k], shape);
    if (order == Order::kSomePairs && k % 7 == 0) continue;
    addTriangle(scene, upper[k], shape);
  }
  return scene;
}

std::array<std::uint32_t, 3> turned(std::array<std::uint32_t, 3> v) {
  std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
  return v;
}

void expectEachTriangleOnce(const FlatScene& scene) {
  const QuadMesh mesh(viewOf(scene));
  ASSERT_EQ(mesh.quads().size(), countQuads(viewOf(scene)));
  std::uint32_t next = 0;
  for (std::uint32_t q = 0; q < mesh.quads().size(); ++q) {
    const auto& [a, b, c, d] = mesh.quads()[q];
    ASSERT_EQ(mesh.firstOf(q), next);
    if (mesh.isPair(q)) {
      EXPECT_EQ(turned({a, b, d}), turned(scene.triangles[next].vertex));
      EXPECT_EQ(turned({c, d, b}), turned(scene.triangles[next + 1].vertex));
    } else {
      EXPECT_EQ(d, c);
      EXPECT_EQ(turned({a, b, c}), turned(scene.triangles[next].vertex));
    }
    next += mesh.isPair(q) ? 2 : 1;
  }
  EXPECT_EQ(next, scene.triangles.size());
}

TEST(QuadMesh, HoldsEachTriangleOnceAsItIs) {
  expectEachTriangleOnce(heightField(Order::kPairs, 0));
  expectEachTriangleOnce(heightField(Order::kSomePairs, 0));
  expectEachTriangleOnce(heightField(Order::kNoPairs, 0));
  expectEachTriangleOnce({});
}

TEST(QuadMesh, PairsNeighboursOfOneOrientation) {
  const auto quads = [](const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    FlatScene scene;
    scene.shapes.resize(1);
    scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}};
    for (const auto& t : triangles) addTriangle(scene, t, 0);
    return countQuads(viewOf(scene));
  };
  EXPECT_EQ(quads({{0, 1, 3}, {1, 2, 3}}), 1u);
  EXPECT_EQ(quads({{0, 1, 3}, {4, 2, 5}}), 1u) << "vertices of their own at the same places";
  EXPECT_EQ(quads({{0, 1, 3}, {3, 2, 1}}), 2u) << "turned round";
  EXPECT_EQ(quads({{0, 1, 3}, {1, 6, 2}}), 2u) << "a common vertex and no edge";
  EXPECT_EQ(quads({{0, 1, 3}}), 1u);
}

TEST(QuadMesh, HalvesAreOneQuadPerTwoTrianglesOfAField) {
  EXPECT_EQ(countQuads(viewOf(heightField(Order::kPairs, 0))), kSide * kSide);
}

// Rays from above and below onto all of the field, through which those from below pass if it has
// only fronts.
void expectTheSameHits(Order order, std::uint32_t shape) {
  const FlatScene scene = heightField(order, shape);
  const EmbreeIntersector embree(viewOf(scene));
  const FlatIntersector flat(viewOf(scene));
  RandomNumbers random(9);
  constexpr int kRays = 50000;
  int different = 0, met = 0;
  const auto side = static_cast<float>(kSide);
  for (int k = 0; k < kRays; ++k) {
    const vec3 target(random.uniform(0.0f, side), random.uniform(0.0f, side),
                      random.uniform(-0.5f, 0.5f));
    const vec3 origin = target + vec3(random.uniform(-3.0f, 3.0f), random.uniform(-3.0f, 3.0f),
                                      k % 2 == 0 ? 2.0f : -2.0f);
    PrimitiveHit expected, found;
    const Ray ray{origin, normalize(target - origin)};
    const bool hit = flat.closest(ray, expected);
    met += hit ? 1 : 0;
    const bool same = embree.closest(ray, kInfinity, found) == hit &&
                      (!hit || (found.index == expected.index &&
                                std::abs(found.t - expected.t) <= 1e-5f * (1.0f + expected.t)));
    const vec3 segment = random.uniform(0.5f, 1.5f) * (target - origin);
    const bool occluded = embree.occluded(origin, segment) == flat.occluded(origin, segment);
    different += same && occluded ? 0 : 1;
  }
  EXPECT_GT(met, kRays / 4);
  EXPECT_LE(different, kRays / 5000);
}

TEST(QuadMesh, HitsTellTheTriangle) {
  for (const Order order : {Order::kPairs, Order::kSomePairs, Order::kNoPairs})
    for (const std::uint32_t shape : {0u, 1u}) expectTheSameHits(order, shape);
}

// Where the halves of a quad meet, either may be hit, but always one, and at its own plane.
TEST(QuadMesh, NoRaySlipsBetweenTheHalves) {
  for (const std::uint32_t shape : {0u, 1u}) {
    const FlatScene scene = heightField(Order::kPairs, shape);
    const EmbreeIntersector embree(viewOf(scene));
    RandomNumbers random(11);
    for (int k = 0; k < 200000; ++k) {
      const auto first = 2 * static_cast<std::uint32_t>(k) % (2 * kSide * kSide);
      const auto& vertex = scene.triangles[first].vertex;
      const vec3 a = toVec3(scene.vertices[vertex[0]]), b = toVec3(scene.vertices[vertex[2]]);
      const vec3 target = a + random.uniform(0.01f, 0.99f) * (b - a);
      const vec3 origin =
          target + vec3(random.uniform(-0.1f, 0.1f), random.uniform(-0.1f, 0.1f), 3.0f);
      const Ray ray{origin, normalize(target - origin)};
      PrimitiveHit hit;
      ASSERT_TRUE(embree.closest(ray, kInfinity, hit));
      ASSERT_TRUE(hit.index == first || hit.index == first + 1);
      ASSERT_TRUE(embree.occluded(origin, 1.5f * (target - origin)));
      const FlatTriangle& met = scene.triangles[hit.index];
      const vec3 p = origin + hit.t * ray.direction;
      ASSERT_NEAR(dot(p - toVec3(scene.vertices[met.vertex[0]]), toVec3(met.normal)), 0.0f, 1e-5f);
    }
  }
}

}  // namespace
}  // namespace pathmark::test
