// Which triangles are met together.
#include "intersect/triangle_pairs.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace pathmark::test {
namespace {

std::vector<TrianglePair> pairsOf(const ShapeScene& scene) {
  return pairTriangles(scene.view(), scene.allTriangles());
}

// The corners from the least on: equal for equal triangles of equal orientation.
std::array<Float3, 3> turned(std::array<Float3, 3> corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// Each of these triangles is in one pair, with the corners and the orientation that it has.
void expectEachOnce(const ShapeScene& scene, const std::vector<std::uint32_t>& triangles) {
  const FlatSceneView view = scene.view();
  std::vector<std::uint32_t> found;
  for (const TrianglePair& pair : pairTriangles(view, triangles)) {
    const auto& [a, b, c, d] = pair.corner;
    const auto& first = scene.triangles[pair.triangle[0]];
    const auto& second = scene.triangles[pair.triangle[1]];
    EXPECT_EQ(turned({a, b, c}), turned(view.corners(first)));
    found.push_back(pair.triangle[0]);
    if (pair.single) {
      EXPECT_EQ(pair.triangle[0], pair.triangle[1]);
      EXPECT_EQ(d, c);
    } else {
      EXPECT_EQ(turned({a, c, d}), turned(view.corners(second)));
      EXPECT_EQ(view.frontOnly(first), view.frontOnly(second));
      found.push_back(pair.triangle[1]);
    }
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, triangles);
}

// A height field with some triangles turned round, some of fronts only, and its order shuffled.
ShapeScene shuffledField(unsigned seed) {
  RandomNumbers random(seed);
  constexpr int kSide = 9;
  std::vector<vec3> points;
  for (int i = 0; i <= kSide; ++i)
    for (int j = 0; j <= kSide; ++j) points.emplace_back(i, j, random.uniform(-1.0f, 1.0f));
  const auto at = [&](int i, int j) {
    return points[static_cast<std::size_t>(i * (kSide + 1) + j)];
  };
  std::vector<std::array<vec3, 3>> corners;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      corners.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      corners.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  ShapeScene scene;
  while (!corners.empty()) {
    std::swap(corners[random.below(corners.size())], corners.back());
    auto [a, b, c] = corners.back();
    corners.pop_back();
    if (random.below(4) == 0) std::swap(a, b);
    scene.addTriangle(a, b, c, static_cast<std::uint32_t>(random.below(2)));
  }
  return scene;
}

TEST(TrianglePairs, HoldEachTriangleOnceAsItIs) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const ShapeScene scene = shuffledField(seed);
    expectEachOnce(scene, scene.allTriangles());
    const std::vector<std::uint32_t> some{3, 4, 5, 17, 31, 32, 90, 161};
    expectEachOnce(scene, some);
    const std::vector<TrianglePair> pairs = pairsOf(scene);
    EXPECT_GT(std::count_if(pairs.begin(), pairs.end(), [](const auto& p) { return !p.single; }),
              10);
  }
}

TEST(TrianglePairs, KeepQuadsTogether) {
  RandomNumbers random(1);
  ShapeScene scene;
  scene.addBox({0, 0, 0}, random.axes(), true);
  for (int k = 0; k < 5; ++k) scene.addBox(random.inCube(0.4f), random.axes());
  const std::vector<TrianglePair> pairs = pairsOf(scene);
  ASSERT_EQ(pairs.size(), scene.triangles.size() / 2);
  for (const TrianglePair& pair : pairs) {
    EXPECT_FALSE(pair.single);
    EXPECT_EQ(pair.triangle[0] % 2, 0u);
    EXPECT_EQ(pair.triangle[1], pair.triangle[0] + 1);
  }
}

TEST(TrianglePairs, NeverJoinOtherSidesOtherTurnsOrCorners) {
  const vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
  const auto pairCount = [&](auto&& addSecond) {
    ShapeScene scene;
    scene.addTriangle(a, b, c);
    addSecond(scene);
    return pairsOf(scene).size();
  };
  EXPECT_EQ(pairCount([&](ShapeScene& s) { s.addTriangle(a, c, d); }), 1u);
  EXPECT_EQ(pairCount([&](ShapeScene& s) { s.addTriangle(a, c, d, ShapeScene::kFrontOnly); }), 2u);
  EXPECT_EQ(pairCount([&](ShapeScene& s) { s.addTriangle(c, a, d); }), 2u);
  EXPECT_EQ(pairCount([&](ShapeScene& s) { s.addTriangle(a, d, {-1, 0, 0}); }), 2u);
}

TEST(TrianglePairs, LeaveTheOddOneSingle) {
  // A fan around a corner: neighbours share edges.
  for (int count = 0; count < 8; ++count) {
    ShapeScene scene;
    const auto rim = [](int k) {
      const float angle = 0.7f * static_cast<float>(k);
      return vec3(std::cos(angle), std::sin(angle), 0);
    };
    for (int k = 0; k < count; ++k) scene.addTriangle({0, 0, 0}, rim(k), rim(k + 1));
    const std::vector<TrianglePair> pairs = pairsOf(scene);
    EXPECT_EQ(pairs.size(), static_cast<std::size_t>((count + 1) / 2));
    EXPECT_EQ(std::count_if(pairs.begin(), pairs.end(), [](const auto& p) { return p.single; }),
              count % 2);
  }
}

TEST(TrianglePairs, AMillionCopiesOfOneTriangleAreSingle) {
  ShapeScene scene;
  scene.addTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  scene.triangles.resize(1000000, scene.triangles.front());
  const std::vector<TrianglePair> pairs = pairsOf(scene);
  ASSERT_EQ(pairs.size(), scene.triangles.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ASSERT_TRUE(pairs[k].single);
    ASSERT_EQ(pairs[k].triangle[0], k);
  }
}

}  // namespace
}  // namespace pathmark::test
