// Boxes, meshes and their transforms, as a worker gets them.
#include "scene/obj_mesh.h"
#include "scene_files.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdlib>

namespace pathmark {
namespace {

glm::dvec3 toDouble(const Float3& v) { return {v[0], v[1], v[2]}; }

double areaOf(const FlatScene& flat) {
  double area = 0.0;
  for (const FlatTriangle& t : flat.triangles) {
    const auto p = viewOf(flat).corners(t);
    area += 0.5 * glm::length(
                      glm::cross(toDouble(p[1]) - toDouble(p[0]), toDouble(p[2]) - toDouble(p[0])));
  }
  return area;
}

// Signed: positive if the vertices run counter-clockwise seen from outside.
double volumeOf(const FlatScene& flat) {
  double volume = 0.0;
  for (const FlatTriangle& t : flat.triangles) {
    const auto p = viewOf(flat).corners(t);
    volume += glm::dot(toDouble(p[0]), glm::cross(toDouble(p[1]), toDouble(p[2]))) / 6.0;
  }
  return volume;
}

void expectNormalsFitVertices(const FlatScene& flat) {
  for (const FlatTriangle& t : flat.triangles) {
    const auto p = viewOf(flat).corners(t);
    const glm::dvec3 n = glm::normalize(
        glm::cross(toDouble(p[1]) - toDouble(p[0]), toDouble(p[2]) - toDouble(p[0])));
    EXPECT_GT(glm::dot(n, toDouble(t.normal)), 0.9999);
  }
}

FlatScene box(const std::string& more) {
  return loadText(sceneWith(R"({"type": "box", "material": "a", "low": [-1, -2, -0.5],
                                "high": [1, 0, 1])" +
                            more + "}"))
      .flat;
}

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

FlatScene mesh(std::string_view obj, const std::string& more = {}) {
  SceneFolder folder;
  folder.write("m.obj", obj);
  return folder.load(sceneWith(R"({"type": "mesh", "material": "a", "file": "m.obj")" + more + "}"))
      .flat;
}

TEST(Box, HasSixFacesThatLookOutwards) {
  const FlatScene flat = box("");
  EXPECT_EQ(flat.triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(areaOf(flat), 2 * (2 * 2 + 2 * 1.5 + 2 * 1.5));
  EXPECT_DOUBLE_EQ(volumeOf(flat), 2 * 2 * 1.5);
  expectNormalsFitVertices(flat);
}

TEST(Box, LooksInwardsWhenItIsARoom) {
  const FlatScene flat = box(R"(, "inward": true)");
  EXPECT_DOUBLE_EQ(volumeOf(flat), -2 * 2 * 1.5);
  expectNormalsFitVertices(flat);
}

TEST(Box, IsOneLightOfSixRectanglesChosenByArea) {
  const FlatScene flat = box(R"(, "emission": [1, 2, 3])");
  ASSERT_EQ(flat.lights.size(), 1u);
  EXPECT_EQ(flat.lights[0].faceCount, 6u);
  double below = 0.0;
  for (const FlatFace& face : flat.faces) {
    EXPECT_EQ(face.vertexCount, 4u);
    const double wanted = std::abs(face.normal[0]) > 0.5f   ? 3.0
                          : std::abs(face.normal[1]) > 0.5f ? 3.0
                                                            : 4.0;
    EXPECT_NEAR(static_cast<double>(face.cumulativeArea) - below, wanted / 20.0, 1e-6);
    below = static_cast<double>(face.cumulativeArea);
  }
  EXPECT_EQ(flat.faces.back().cumulativeArea, 1.0f);
}

TEST(Transform, ScalesThenRotatesThenMoves) {
  const FlatScene flat = mesh("v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n",
                              R"(, "transform": {"translate": [1, 0, 0], "scale": [1, 2, 3],
                                  "rotate": {"axis": [0, 0, 5], "angle": 90}})");
  const std::vector<Float3> wanted{{1, 1, 0}, {-1, 0, 0}, {1, 0, 3}};
  ASSERT_EQ(flat.vertices.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(flat.vertices[i][k], wanted[i][k], 1e-6f);
  }
}

TEST(Transform, TurnsAnyNumberOfTimes) {
  for (const char* angle : {"0", "360", "-720", "3.6e17"}) {
    const FlatScene flat =
        mesh(kTetrahedron, fmt::format(R"(, "transform": {{"rotate": {{"axis": [1, 2, 3],
                                           "angle": {}}}}})",
                                       angle));
    EXPECT_NEAR(flat.vertices[1][0], 1.0f, 1e-6f) << angle;
  }
}

TEST(Transform, KeepsFrontsOutsideWhenItMirrors) {
  for (const char* scale : {"-1", "[1, -1, 1]", "[-1, -1, 1]", "[2, 2, 2]"}) {
    const std::string transform = fmt::format(R"(, "transform": {{"scale": {}}})", scale);
    EXPECT_GT(volumeOf(mesh(kTetrahedron, transform)), 0.0) << scale;
    EXPECT_GT(volumeOf(box(transform)), 0.0) << scale;
    expectNormalsFitVertices(mesh(kTetrahedron, transform));
    EXPECT_LT(volumeOf(box(transform + R"(, "inward": true)")), 0.0) << scale;
  }
}

TEST(Mesh, SharesItsVertices) {
  const FlatScene flat = mesh(kTetrahedron);
  EXPECT_EQ(flat.vertices.size(), 4u);
  EXPECT_EQ(flat.triangles.size(), 4u);
  EXPECT_NEAR(volumeOf(flat), 1.0 / 6.0, 1e-7);
  expectNormalsFitVertices(flat);
}

TEST(Mesh, IsOneLightWithAFaceForEachTriangle) {
  const FlatScene flat = mesh(kTetrahedron, R"(, "emission": [1, 1, 1])");
  ASSERT_EQ(flat.lights.size(), 1u);
  EXPECT_EQ(flat.lights[0].faceCount, 4u);
  const double slanted = std::sqrt(3.0) / 2, all = 1.5 + slanted;
  EXPECT_NEAR(static_cast<double>(flat.faces[2].cumulativeArea), 1.5 / all, 1e-6);
}

TEST(Mesh, MeansTheSameInEveryDialect) {
  const FlatScene expected = mesh(kTetrahedron);
  for (const char* text : {
           "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1\r\nf 1 3 2\r\nf 1 2 4\r\nf 1 4 3\r\nf 2 3 4",
           "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4",
           "# made by hand\nmtllib x.mtl\no thing\nv 0 0 0 1\nv +1 0 0.0 1\nv 0 1.0e0 0\n"
           "v 0 0 1 1 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\ng side\nusemtl red\ns off\n"
           "f 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1 # a comment\n\tf -4 -1 -2\nf 2/1 3/1 4/1\n",
           "v 0 0 0\nv 1 \\\n 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 \\\r\n2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
       }) {
    const FlatScene found = mesh(text);
    EXPECT_EQ(found.vertices, expected.vertices) << text;
    ASSERT_EQ(found.triangles.size(), expected.triangles.size()) << text;
    for (std::size_t i = 0; i < found.triangles.size(); ++i) {
      EXPECT_EQ(found.triangles[i].vertex, expected.triangles[i].vertex) << text;
    }
  }
}

TEST(Mesh, ReadsEveryWayToWriteANumberToTheNearestDouble) {
  SceneFolder folder;
  for (const char* number :
       {"0", "-0", "7", "-7.", ".5", "-.25", "00012.50", "0.1", "123456.789012345",
        "-99999999999999.9", "0.000000000000001", "1234567890123456", "0.1234567890123456789",
        "1e-3", "+2.5E2", "5e-324", "0.30000000000000004"}) {
    folder.write("m.obj", fmt::format("v {0} {0} {0}\nv 1 0 0\nv 0 {0}\t{0}\r\nf 1 2 3", number));
    const glm::dvec3 expected(std::strtod(number, nullptr));
    const Mesh mesh = readObj(folder.path() / "m.obj");
    EXPECT_EQ(mesh.vertices[0], expected) << number;
    EXPECT_EQ(std::signbit(mesh.vertices[0].x), std::signbit(expected.x)) << number;
    EXPECT_EQ(mesh.vertices[2].y, expected.y) << number;
    EXPECT_EQ(mesh.vertices[2].z, expected.z) << number;
  }
}

// Files are read in pieces: every way to end a line stands at every place where a piece may end.
TEST(Mesh, MeansTheSameHoweverLongItsFileIs) {
  const FlatScene expected = mesh(kTetrahedron);
  const std::string statements =
      std::string(kTetrahedron) + "f 1 \\\r\n 3 \\\n 2 # and \\\n so on\r\n";
  for (const std::string& filling : {std::string("# seven\n"), std::string("#\\\n12345\n"),
                                     std::string("\\\r\n   \\\n"), std::string("vn 1 2 3\r\n")}) {
    std::string text;
    for (std::size_t i = 0; text.size() < (std::size_t{3} << 18); ++i) {
      text += filling;
      if (i % 97 == 0) text += ' ';
    }
    const FlatScene found = mesh(text + "\n" + statements);
    EXPECT_EQ(found.vertices, expected.vertices) << filling;
    ASSERT_EQ(found.triangles.size(), expected.triangles.size() + 1) << filling;
    EXPECT_EQ(found.triangles.back().vertex, (std::array{0u, 2u, 1u})) << filling;
  }
}

// Each gets triangles of its own, also the one that is last.
TEST(Mesh, MayBeUsedByManyShapes) {
  SceneFolder folder;
  folder.write("m.obj", kTetrahedron);
  const std::string shape = R"({"type": "mesh", "material": "a", "file": "m.obj"})";
  const std::string other = R"({"type": "mesh", "material": "b", "file": ".//m.obj"})";
  const FlatScene flat = folder.load(sceneWith(shape + "," + other + "," + shape)).flat;
  const FlatScene one = mesh(kTetrahedron);
  const std::size_t n = one.vertices.size();
  ASSERT_EQ(flat.vertices.size(), 3 * n);
  ASSERT_EQ(flat.triangles.size(), 3 * one.triangles.size());
  for (std::size_t i = 0; i < 3 * n; ++i) EXPECT_EQ(flat.vertices[i], one.vertices[i % n]);
}

TEST(Mesh, CutsFacesOfManyVerticesIntoTriangles) {
  // An L, a quad that is not planar, and a quad with a corner that points inwards.
  const FlatScene l = mesh("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
  EXPECT_EQ(l.triangles.size(), 4u);
  EXPECT_DOUBLE_EQ(areaOf(l), 3.0);
  EXPECT_EQ(mesh("v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n").triangles.size(), 2u);
  const FlatScene dart = mesh("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 0.5 1 0\nf 1 2 3 4\n");
  EXPECT_DOUBLE_EQ(areaOf(dart), 1.5);
}

TEST(Mesh, ForgetsVerticesThatNoFaceUses) {
  const FlatScene flat = mesh("v 1e30 0 0\nv 0 0 0\nv 1 0 0\nv 7 7 7\nv 0 1 0\nf 2 3 5\n");
  EXPECT_EQ(flat.vertices.size(), 3u);
  EXPECT_EQ(flat.vertices[2], (Float3{0, 1, 0}));
}

TEST(Mesh, CountsTrianglesWithoutAreaAndLeavesThemOut) {
  SceneFolder folder;
  folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 4\n");
  const LoadedScene scene = folder.load(
      sceneWith(R"({"type": "mesh", "name": "bent", "material": "a", "file": "m.obj"})"));
  EXPECT_EQ(scene.flat.triangles.size(), 1u);
  ASSERT_FALSE(scene.notes.empty());
  EXPECT_EQ(scene.notes[0],
            "2 triangles of zero area were left out, the first of /shapes/0 (\"bent\").");
}

TEST(Mesh, IsReadInDouble) {
  // The extent is 1e-6 at 1e6: float would see a point.
  const FlatScene flat = [&] {
    SceneFolder folder;
    folder.write("m.obj",
                 "v 1000000.000001 0 0\nv 1000000.000002 0 0\nv 1000000 1e-6 0\nf 1 2 3\n");
    std::string text = sceneWith(R"({"type": "mesh", "material": "a", "file": "m.obj"})");
    text.replace(text.find("[0, 0, 5]"), 9, "[1e6, 0, 5e-6]");
    text.replace(text.find("[0, 0, 0]"), 9, "[1e6, 0, 0]");
    return folder.load(text).flat;
  }();
  ASSERT_EQ(flat.triangles.size(), 1u);
  const auto p = viewOf(flat).corners(flat.triangles[0]);
  EXPECT_NEAR((p[1][0] - p[0][0]) / (p[2][1] - p[0][1]), 1.0f, 1e-3f);
}

TEST(Mesh, OfAFileThatTwoShapesShareIsPutAtBothPlaces) {
  SceneFolder folder;
  folder.write("m.obj", kTetrahedron);
  const FlatScene flat = folder
                             .load(sceneWith(
                                 R"({"type": "mesh", "material": "a", "file": "m.obj"},
                 {"type": "mesh", "material": "b", "file": "m.obj", "transform": {"scale": 2}})"))
                             .flat;
  EXPECT_EQ(flat.triangles.size(), 8u);
  EXPECT_NEAR(volumeOf(flat), 9.0 / 6.0, 1e-6);
}

}  // namespace
}  // namespace pathmark
