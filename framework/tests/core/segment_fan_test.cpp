// Segments of a fan against the same segments one at a time: equal to the bit, whatever lanes hold.
#include "intersect/intersector.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace pathmark::test {
namespace {

enum class Ends { kAnywhere, kNeighbours };

struct FanOfTest {
  SegmentFan fan{};
  std::vector<vec3> ways = std::vector<vec3>(kLanes, vec3(0.0f));
};

// Not all lanes hold a segment; some that do point along an axis, so that two axes are largest.
FanOfTest randomFan(RandomNumbers& random, Ends ends) {
  FanOfTest made;
  made.fan.origin = random.inCube(1.5f);
  made.fan.lanes = SegmentFan::Mask(false);
  const vec3 middle = random.inCube(1.5f);
  for (std::size_t i = 0; i < kLanes; ++i) {
    vec3 way = ends == Ends::kAnywhere ? random.inCube(3.0f)
                                       : middle + random.inCube(0.05f) - made.fan.origin;
    if (random.below(20) == 0) way = vec3(1.0f, -1.0f, random.below(2) == 0 ? 1.0f : 0.0f);
    made.ways[i] = way;
    made.fan.lanes[i] = random.below(5) != 0;
    for (int axis = 0; axis < 3; ++axis)
      made.fan.way[static_cast<std::size_t>(axis)][i] = way[axis];
  }
  return made;
}

struct Tally {
  int occluded = 0, free = 0, partly = 0;
};

template <class Intersector>
void expectTheSame(const Intersector& intersector, RandomNumbers& random, Ends ends, Tally& tally) {
  for (int k = 0; k < 2000; ++k) {
    const FanOfTest made = randomFan(random, ends);
    const SegmentFan::Mask occluded = intersector.occluded(made.fan);
    int here = 0, wanted = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const bool expected =
          made.fan.lanes[i] && intersector.occluded(made.fan.origin, made.ways[i]);
      ASSERT_EQ(static_cast<bool>(occluded[i]), expected) << "lane " << i;
      here += expected ? 1 : 0;
      wanted += made.fan.lanes[i] ? 1 : 0;
    }
    ++(here == 0 ? tally.free : here == wanted ? tally.occluded : tally.partly);
  }
}

// Flat quads and folded ones, and triangles alone; with both sides, fronts only, or some of each.
ShapeScene randomScene(RandomNumbers& random, std::size_t shapes, std::size_t spheres,
                       std::size_t kindsOfSides) {
  ShapeScene scene;
  const auto sides = [&](std::size_t k) { return static_cast<std::uint32_t>(k % kindsOfSides); };
  for (std::size_t k = 0; k < shapes; ++k) {
    const vec3 a = random.inCube(1.0f), u = random.inCube(0.8f), v = random.inCube(0.8f);
    if (k % 3 == 0) scene.addQuad(a, a + u, a + u + v, a + v, sides(k));
    if (k % 3 == 1) scene.addQuad(a, a + u, a + u + v, a + v + random.inCube(0.3f), sides(k));
    if (k % 3 == 2) scene.addTriangle(a, a + u, a + v, sides(k));
  }
  for (std::size_t k = 0; k < spheres; ++k)
    scene.addSphere(random.inCube(1.0f), random.uniform(0.05f, 0.4f), k % 2 == 0, sides(k));
  return scene;
}

TEST(SegmentFan, MeetsWhatItsSegmentsMeetOneAtATime) {
  RandomNumbers random(31);
  for (const auto& [shapes, spheres] : {std::pair<std::size_t, std::size_t>{1, 0},
                                        {0, 1},
                                        {0, kLanes + 3},
                                        {10, 0},
                                        {2 * kLanes + 5, 0},
                                        {10, 4}}) {
    Tally tally;
    for (const std::size_t kindsOfSides : {1u, 2u}) {
      for (int scenes = 0; scenes < 5; ++scenes) {
        const ShapeScene scene = randomScene(random, shapes, spheres, kindsOfSides);
        const FlatIntersector flat(scene.view());
        expectTheSame(flat, random, Ends::kAnywhere, tally);
        expectTheSame(flat, random, Ends::kNeighbours, tally);
      }
    }
    EXPECT_GT(tally.free, 20) << shapes << " " << spheres;
    EXPECT_GT(tally.occluded, 20) << shapes << " " << spheres;
    EXPECT_GT(tally.partly, 20) << shapes << " " << spheres;
  }
}

TEST(SegmentFan, MeetsTheSameInAHierarchyBesideSpheres) {
  RandomNumbers random(32);
  const ShapeScene scene = randomScene(random, kFewestForHierarchy, 3, 2);
  const Intersector intersector(scene.view(), planFor(scene.view(), ShadowOrigins::kAnywhere));
  Tally tally;
  expectTheSame(intersector, random, Ends::kAnywhere, tally);
  expectTheSame(intersector, random, Ends::kNeighbours, tally);
  EXPECT_GT(tally.free, 20);
  EXPECT_GT(tally.occluded, 20);
  EXPECT_GT(tally.partly, 20);
}

TEST(SegmentFan, MeetsNothingInAnEmptyScene) {
  RandomNumbers random(33);
  const ShapeScene scene;
  const FlatIntersector flat(scene.view());
  for (int k = 0; k < 100; ++k)
    EXPECT_TRUE(none_of(flat.occluded(randomFan(random, Ends::kAnywhere).fan)));
}

TEST(SegmentFan, LanesWithoutASegmentMayHoldAnything) {
  ShapeScene scene;
  scene.addQuad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  scene.addSphere({0, 0, 0}, 0.1f);
  const FlatIntersector flat(scene.view());
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), kInfinity, 0.0f}) {
    SegmentFan fan{{0.5f, 0.5f, -1.0f}, {bad, bad, bad}, SegmentFan::Mask(false)};
    EXPECT_TRUE(none_of(flat.occluded(fan)));
    fan.lanes[0] = true;
    fan.way[0][0] = fan.way[1][0] = 0.0f;
    fan.way[2][0] = 2.0f;
    const SegmentFan::Mask occluded = flat.occluded(fan);
    EXPECT_TRUE(occluded[0]);
    EXPECT_EQ(popcount(occluded), 1);
  }
}

}  // namespace
}  // namespace pathmark::test
