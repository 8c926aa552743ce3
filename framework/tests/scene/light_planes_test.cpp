// Lights in the plane of another shape are told of; those beside it, or with a gap, are not.
#include "scene_files.h"

namespace pathmark {
namespace {

// Inside of a room of 4 x 2.5 x 5.5, seen from its middle.
LoadedScene roomWith(const std::string& shapes, double x = 0.0) {
  return loadText(fmt::format(R"({{
    "camera": {{"eye": [{0}, 1, 3.4], "target": [{0}, 1, 0], "fieldOfView": 50}},
    "materials": {{"a": {{"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
                  "b": {{"type": "lambertian", "Kd": [0, 0, 0]}}}},
    "shapes": [{{"type": "box", "material": "a", "low": [{1}, 0, -2], "high": [{2}, 2.5, 3.5],
                "inward": true}}, {3}]}})",
                              x, x - 2.0, x + 2.0, shapes));
}

// Of an L below the ceiling, looking down.
std::string lamp(double y, double x = 0.0) {
  return fmt::format(R"({{"type": "polygon", "material": "b", "emission": [5, 4, 3], "vertices":
    [[{1},{0},-2],[{3},{0},-2],[{3},{0},-1],[{2},{0},-1],[{2},{0},1],[{1},{0},1]]}})",
                     y, x - 2.0, x - 1.0, x);
}

std::string rectangle(const std::string& emission, const std::string& vertices) {
  return fmt::format(
      R"({{"type": "rectangle", "material": "b", "emission": {}, "vertices": [{}]}})", emission,
      vertices);
}

TEST(LightPlanes, ALightInThePlaneOfTheCeilingIsToldOf) {
  const LoadedScene scene = roomWith(lamp(2.5));
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            "The light /shapes/1 lies in the plane of /shapes/0, which it overlaps: which of the "
            "two is seen there is by chance; move the light by a thousandth of its size.");
}

TEST(LightPlanes, AThousandthOfItsSizeIsEnough) {
  EXPECT_TRUE(roomWith(lamp(2.498)).notes.empty());
}

TEST(LightPlanes, FarFromTheOriginItIsTheSame) {
  EXPECT_EQ(roomWith(lamp(2.5, 1e6), 1e6).notes.size(), 2u);  // that it is moved, too
  EXPECT_EQ(roomWith(lamp(2.498, 1e6), 1e6).notes.size(), 1u);
}

TEST(LightPlanes, ALargeLightBehindASmallShapeIsToldOf) {
  const LoadedScene scene =
      roomWith(rectangle("[1,1,1]", "[-1,1,-1],[1,1,-1],[1,2,-1],[-1,2,-1]") + "," +
               rectangle("[0,0,0]", "[-0.1,1.4,-1],[0.1,1.4,-1],[0.1,1.6,-1],[-0.1,1.6,-1]"));
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_NE(scene.notes[0].find("/shapes/1 lies in the plane of /shapes/2"), std::string::npos);
}

TEST(LightPlanes, LightsThatOverlapAreCountedOnce) {
  const std::string a = rectangle("[1,1,1]", "[-1,1,-1],[1,1,-1],[1,2,-1],[-1,2,-1]");
  const std::string b = rectangle("[2,2,2]", "[0,1,-1],[1.5,1,-1],[1.5,2,-1],[0,2,-1]");
  ASSERT_EQ(roomWith(a + "," + b).notes.size(), 1u);
  EXPECT_TRUE(roomWith(a + "," + b).notes[0].starts_with("The light /shapes/1 "));
  const LoadedScene two = roomWith(a + "," + b + "," + lamp(2.5));
  ASSERT_EQ(two.notes.size(), 1u);
  EXPECT_TRUE(
      two.notes[0].starts_with("2 lights lie in the planes of shapes that they overlap, "
                               "the first, /shapes/1, in that of /shapes/2: "))
      << two.notes[0];
}

TEST(LightPlanes, LightsThatHaveOnlyAnEdgeInCommonAreNone) {
  EXPECT_TRUE(roomWith(rectangle("[1,1,1]", "[-1,1,-1],[0.1,1,-1],[0.1,2,-1],[-1,2,-1]") + "," +
                       rectangle("[2,2,2]", "[0.1,1,-1],[1,1,-1],[1,2,-1],[0.1,2,-1]"))
                  .notes.empty());
}

// Only the box hides it, whose bottom nobody sees.
TEST(LightPlanes, ABoxThatStandsOnALightIsNone) {
  EXPECT_TRUE(roomWith(rectangle("[1,1,1]", "[-1,0.1,1],[1,0.1,1],[1,0.1,-1],[-1,0.1,-1]") +
                       R"(,{"type": "box", "material": "a", "low": [-0.5, 0.1, -0.5],
                           "high": [0.5, 1, 0.5]})")
                  .notes.empty());
}

TEST(LightPlanes, OneShapeWithItselfIsNone) {
  EXPECT_TRUE(roomWith(R"({"type": "box", "material": "b", "emission": [1,1,1],
                           "low": [-0.5, 1, -0.5], "high": [0.5, 1.5, 0.5]})")
                  .notes.empty());
}

}  // namespace
}  // namespace pathmark
