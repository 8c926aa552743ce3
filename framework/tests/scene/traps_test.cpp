// Geometry in which a loader that works in float goes wrong: slivers, no area, vertices that are
// no numbers, and scenes far from the origin. The naive form is in float as one would write it
// first, and the oracle in long double. The other traps are in grader/tests/traps.
#include "scene_files.h"

#include <pathmark/types.h>

#include <cmath>
#include <random>
#include <sstream>
#include <vector>

namespace pathmark {
namespace {

using LongVector = glm::vec<3, long double, glm::defaultp>;
using Corners = std::array<vec3, 3>;

vec3 naiveNormal(const Corners& p) { return normalize(cross(p[1] - p[0], p[2] - p[0])); }

float naiveDensity(const Corners& p) { return 2.0f / length(cross(p[1] - p[0], p[2] - p[0])); }

std::string triangle(const Corners& p, const std::string& more = {}) {
  // All digits, so that the file has exactly these floats.
  const auto vertex = [](const vec3& v) {
    const glm::dvec3 exact(v);
    return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", exact.x, exact.y, exact.z);
  };
  return fmt::format(R"({{"type": "triangle", "material": "a", "vertices": [{}, {}, {}]{}}})",
                     vertex(p[0]), vertex(p[1]), vertex(p[2]), more);
}

std::string listOf(const std::vector<Corners>& triangles, const std::string& more = {}) {
  std::string list;
  for (const Corners& p : triangles) list += (list.empty() ? "" : ",\n") + triangle(p, more);
  return list;
}

// Angles between normals and the exact ones, of slivers whose height is a millionth of their
// length.
TEST(Trap, SliversKeepTheirNormals) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  const auto point = [&] { return vec3(uniform(engine), uniform(engine), uniform(engine)); };
  std::vector<Corners> slivers;
  for (int i = 0; i < 200; ++i) {
    const vec3 a = point(), b = point();
    slivers.push_back({a, b, a + 0.5f * (b - a) + 1e-6f * point()});
  }
  const FlatScene flat = loadText(sceneWith(listOf(slivers))).flat;
  ASSERT_EQ(flat.triangles.size(), slivers.size());
  double naiveWorst = 0.0, shippedWorst = 0.0;
  for (std::size_t i = 0; i < slivers.size(); ++i) {
    const Corners& p = slivers[i];
    const LongVector exact = glm::normalize(
        glm::cross(LongVector(p[1]) - LongVector(p[0]), LongVector(p[2]) - LongVector(p[0])));
    const auto angle = [&](const vec3& n) {
      return static_cast<double>(glm::length(LongVector(n) - exact));
    };
    const Float3& n = flat.triangles[i].normal;
    naiveWorst = std::max(naiveWorst, angle(naiveNormal(p)));
    shippedWorst = std::max(shippedWorst, angle({n[0], n[1], n[2]}));
  }
  RecordProperty("angle", fmt::format("naive {}, shipped {}", naiveWorst, shippedWorst));
  EXPECT_LE(shippedWorst, 1e-6);
  EXPECT_GT(naiveWorst, 1e-2);
}

TEST(Trap, TrianglesWithoutAreaNeverReachAWorker) {
  const vec3 a(0.1f, 0.2f, 0.3f), b(0.7f, -0.4f, 0.5f);
  const std::vector<Corners> degenerate{
      {a, a, a}, {a, b, b}, {a, a, b}, {vec3(0), vec3(1, 0, 0), vec3(2, 0, 0)}};
  std::vector<Corners> triangles = degenerate;
  triangles.push_back({vec3(-1, -1, 0), vec3(1, -1, 0), vec3(0, 1, 0)});
  for (const Corners& p : degenerate) {
    EXPECT_TRUE(std::isnan(naiveNormal(p).x));
    EXPECT_TRUE(std::isinf(naiveDensity(p)));
  }
  const LoadedScene scene = loadText(sceneWith(listOf(triangles, R"(, "emission": [1, 1, 1])")));
  ASSERT_EQ(scene.flat.triangles.size(), 1u);
  ASSERT_EQ(scene.flat.lights.size(), 1u);
  EXPECT_EQ(scene.flat.triangles[0].normal, (Float3{0, 0, 1}));
  ASSERT_FALSE(scene.notes.empty());
  EXPECT_EQ(scene.notes[0], "4 triangles of zero area were left out, the first of /shapes/0.");
}

TEST(Trap, DuplicateVerticesOfAMeshAreLeftOutAndCounted) {
  const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n";
  const Corners twice{vec3(0), vec3(1, 0, 0), vec3(1, 0, 0)};
  EXPECT_TRUE(std::isnan(naiveNormal(twice).x));
  SceneFolder folder;
  folder.write("m.obj", good + "f 1 2 2\nf 1 2 4\n");
  const LoadedScene scene =
      folder.load(sceneWith(R"({"type": "mesh", "material": "a", "file": "m.obj"})"));
  EXPECT_EQ(scene.flat.triangles.size(), 1u);
  ASSERT_FALSE(scene.notes.empty());
  EXPECT_EQ(scene.notes[0], "2 triangles of zero area were left out, the first of /shapes/0.");
}

TEST(Trap, VerticesThatAreNoNumbersAreRefused) {
  for (const char* word : {"nan", "-nan", "inf", "1e999"}) {
    EXPECT_FALSE(std::isfinite(std::strtof(word, nullptr))) << word;
    SceneFolder folder;
    folder.write("m.obj", fmt::format("v 0 0 0\nv 1 0 0\nv 0 {} 0\nf 1 2 3\n", word));
    try {
      folder.load(sceneWith(R"({"type": "mesh", "material": "a", "file": "m.obj"})"));
      ADD_FAILURE() << word << " was read";
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find("m.obj:3: found"), std::string::npos)
          << error.what();
    }
  }
}

// Edges of a triangle of unit size, relative to it. A float coordinate of 1e9 is a multiple of 64.
TEST(Trap, SceneFarFromTheOriginKeepsItsShape) {
  const glm::dvec3 far(6.1e8, -7.7e8, 4.3e8);
  const std::array<glm::dvec3, 3> local{glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0.9, -0.3, 0.2),
                                        glm::dvec3(-0.2, 0.8, -0.4)};
  std::string vertices;
  for (const glm::dvec3& v : local) {
    vertices += fmt::format("{}[{:.17g}, {:.17g}, {:.17g}]", vertices.empty() ? "" : ", ",
                            far.x + v.x, far.y + v.y, far.z + v.z);
  }
  const std::string text = fmt::format(
      R"({{"camera": {{"eye": [{0}, {1}, {2}], "target": [{0}, {1}, {3}], "fieldOfView": 45}},
           "materials": {{"a": {{"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}}}},
           "shapes": [{{"type": "triangle", "material": "a", "vertices": [{4}]}}]}})",
      far.x, far.y, far.z + 5.0, far.z, vertices);
  const FlatScene flat = loadText(text).flat;
  ASSERT_EQ(flat.triangles.size(), 1u);
  const auto corners = viewOf(flat).corners(flat.triangles[0]);
  double naiveWorst = 0.0, shippedWorst = 0.0;
  for (std::size_t k = 1; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double exact = local[k][axis] - local[0][axis];
      const float naive = static_cast<float>(far[axis] + local[k][axis]) -
                          static_cast<float>(far[axis] + local[0][axis]);
      naiveWorst = std::max(naiveWorst, std::abs(static_cast<double>(naive) - exact));
      const float shipped = corners[k][i] - corners[0][i];
      shippedWorst = std::max(shippedWorst, std::abs(static_cast<double>(shipped) - exact));
    }
  }
  RecordProperty("edges", fmt::format("naive {}, shipped {}", naiveWorst, shippedWorst));
  EXPECT_LE(shippedWorst, 1e-6);
  EXPECT_GT(naiveWorst, 0.1);
}

}  // namespace
}  // namespace pathmark
