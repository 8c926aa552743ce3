#include "scene/faces.h"

#include "scene_files.h"

#include <cmath>
#include <string>

namespace pathmark {
namespace {

FlatScene flatOf(std::string_view shapes) { return loadText(sceneWith(shapes)).flat; }

std::string shape(std::string_view type, std::string_view vertices) {
  return fmt::format(R"({{"type": "{}", "material": "b", "emission": [1, 2, 3],
                         "vertices": [{}]}})",
                     type, vertices);
}

TEST(Faces, ATriangleIsOneFaceWithThreeVertices) {
  const FlatScene flat = flatOf(shape("triangle", "[0,0,0],[2,0,0],[0,2,0]"));
  ASSERT_EQ(flat.faces.size(), 1u);
  EXPECT_EQ(flat.faces[0].vertexCount, 3u);
  EXPECT_EQ(flat.faces[0].triangleCount, 1u);
  EXPECT_EQ(flat.faces[0].cumulativeArea, 1.0f);
  EXPECT_EQ(flat.faces[0].normal, (Float3{0.0f, 0.0f, 1.0f}));
}

TEST(Faces, ARectangleAndAParallelogramOfAnyNameAreOneFaceWithFourVertices) {
  for (const char* type : {"rectangle", "quad", "polygon"}) {
    const FlatScene flat = flatOf(shape(type, "[0,0,0],[2,0,0],[3,1,1],[1,1,1]"));
    ASSERT_EQ(flat.faces.size(), 1u) << type;
    EXPECT_EQ(flat.faces[0].vertexCount, 4u);
    EXPECT_EQ(flat.faces[0].triangleCount, 2u);
    EXPECT_EQ(flat.triangles.size(), 2u);
  }
}

TEST(Faces, ANonPlanarQuadIsTwoTrianglesWithNormalsOfTheirOwn) {
  const FlatScene flat = flatOf(shape("quad", "[0,0,0],[1,0,0],[1,1,1],[0,1,0]"));
  ASSERT_EQ(flat.triangles.size(), 2u);
  const auto first = viewOf(flat).corners(flat.triangles[0]);
  const auto second = viewOf(flat).corners(flat.triangles[1]);
  EXPECT_EQ(first[1], (Float3{1, 0, 0}));
  EXPECT_EQ(second[0], (Float3{0, 0, 0}));
  EXPECT_EQ(second[1], (Float3{1, 1, 1}));
  EXPECT_EQ(second[2], (Float3{0, 1, 0}));
  const float r = std::sqrt(0.5f);
  EXPECT_FLOAT_EQ(flat.triangles[0].normal[1], -r);
  EXPECT_FLOAT_EQ(flat.triangles[1].normal[0], -r);
  EXPECT_EQ(flat.lights.size(), 1u);
  EXPECT_EQ(flat.lights[0].faceCount, 2u);
}

TEST(Faces, OfALightShareItsAreaAndEndAtExactlyOne) {
  // A trapezium of areas 3 and 1.
  const FlatScene flat = flatOf(shape("quad", "[0,0,0],[3,0,0],[1,2,0],[0,2,0]"));
  ASSERT_EQ(flat.faces.size(), 2u);
  EXPECT_FLOAT_EQ(flat.faces[0].cumulativeArea, 0.75f);
  EXPECT_EQ(flat.faces[1].cumulativeArea, 1.0f);
}

TEST(Faces, AConcavePolygonIsOneFaceWithItsTriangulation) {
  const FlatScene flat =
      flatOf(shape("polygon", "[0,0,0],[0,0,2],[2,0,2],[2,0,1],[1,0,1],[1,0,0]"));
  ASSERT_EQ(flat.faces.size(), 1u);
  EXPECT_EQ(flat.faces[0].vertexCount, 6u);
  EXPECT_EQ(flat.faces[0].triangleCount, 4u);
  EXPECT_EQ(flat.faces[0].normal, (Float3{0.0f, 1.0f, 0.0f}));
  EXPECT_EQ(flat.triangles.size(), 4u);
}

TEST(Faces, OfOneLightFollowThoseOfThePreviousOnes) {
  const FlatScene flat = flatOf(shape("triangle", "[0,0,0],[2,0,0],[0,2,0]") + "," +
                                shape("quad", "[0,0,0],[1,0,0],[1,1,1],[0,1,0]") + "," +
                                R"({"type": "sphere", "material": "b", "emission": [0,1,0],
                                    "centre": [0,0,0], "radius": 1, "inward": true})");
  ASSERT_EQ(flat.lights.size(), 3u);
  EXPECT_EQ(flat.lights[1].firstFace, 1u);
  EXPECT_EQ(flat.faces[1].firstVertex, 3u);
  EXPECT_EQ(flat.faces[1].firstTriangle, 1u);
  EXPECT_EQ(flat.lights[2].sphere, 0u);
  EXPECT_EQ(flat.spheres[0].inward, 1u);
}

TEST(Faces, TrianglesWithoutAreaAreLeftOutAndCounted) {
  const LoadedScene scene = loadText(
      sceneWith(R"({"type": "triangle", "material": "a", "vertices": [[0,0,0],[1,0,0],[2,0,0]]},
                   {"type": "triangle", "material": "a", "name": "good",
                    "vertices": [[0,0,0],[1,0,0],[0,1,0]]},
                   {"type": "quad", "material": "a", "vertices": [[0,0,0],[1,0,0],[1,0,0],[0,1,0]]},
                   {"type": "triangle", "material": "b", "emission": [1,1,1],
                    "vertices": [[1,1,1],[1,1,1],[1,1,1]]})"));
  EXPECT_EQ(scene.flat.triangles.size(), 2u);
  EXPECT_TRUE(scene.flat.lights.empty());
  ASSERT_EQ(scene.notes.size(), 2u);
  EXPECT_EQ(scene.notes[1], "No shape of the scene has an emission: its picture is black.");
  EXPECT_EQ(scene.notes[0], "3 triangles of zero area were left out, the first of /shapes/0.");
}

TEST(Faces, ALightWhoseAreaUnderflowsIsRefused) {
  const auto lightOfSide = [](const char* half) {
    return flatOf(fmt::format(
        R"({{"type": "box", "material": "a", "low": [-1,-1,-1], "high": [1,1,1]}},
           {{"type": "rectangle", "material": "b", "emission": [1,1,1],
             "vertices": [[-{0},0,-{0}],[{0},0,-{0}],[{0},0,{0}],[-{0},0,{0}]]}})",
        half));
  };
  EXPECT_EQ(lightOfSide("1e-8").lights.size(), 1u);
  try {
    lightOfSide("1e-10");
    FAIL() << "it was accepted";
  } catch (const SceneError& e) {
    EXPECT_NE(std::string(e.what()).find("/shapes/1: found a light whose area is almost nothing"),
              std::string::npos)
        << e.what();
  }
}

TEST(Faces, ALightWithoutRadianceIsNone) {
  EXPECT_TRUE(flatOf(R"({"type": "sphere", "material": "a", "centre": [0,0,0], "radius": 1,
                         "emission": [0, 0, 0]})")
                  .lights.empty());
}

}  // namespace
}  // namespace pathmark
