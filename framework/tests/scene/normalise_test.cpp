#include "scene/normalise.h"

#include "scene/flatten.h"
#include "scene/read_scene.h"
#include "scene/read_text.h"
#include "scene_files.h"

#include <algorithm>
#include <cmath>

namespace pathmark {
namespace {

const std::filesystem::path kCornell =
    std::filesystem::path(PATHMARK_ROOT) / "scenes" / "cornell_box.json";

const SceneSource& cornellSource() {
  static const SceneSource source{kCornell, readText(kCornell, "a scene is a JSON file")};
  return source;
}

SceneDescription cornell() { return readScene(cornellSource()); }

// The same scene in other units, `shift` in its own units before they change.
SceneDescription moved(SceneDescription scene, double scale, const glm::dvec3& shift) {
  const auto move = [&](glm::dvec3& p) { p = (p + shift) * scale; };
  move(scene.camera.eye);
  move(scene.camera.target);
  for (ShapeDescription& shape : scene.shapes) {
    move(shape.centre);
    shape.radius *= scale;
    for (glm::dvec3& vertex : shape.vertices) move(vertex);
  }
  return scene;
}

struct Result {
  Normalisation normalisation;
  FlatScene flat;
};

Result normalisedFlat(SceneDescription scene) {
  Result result;
  result.normalisation = chooseNormalisation(scene);
  normalise(scene, result.normalisation);
  std::vector<std::string> notes;
  result.flat = flatten(scene, Place(cornellSource()), notes);
  EXPECT_TRUE(notes.empty());
  return result;
}

double halfExtent(const FlatScene& flat) {
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    float low = flat.camera.eye[k], high = low;
    for (const Float3& p : flat.vertices) {
      low = std::min(low, p[k]);
      high = std::max(high, p[k]);
    }
    largest = std::max(largest, 0.5 * (static_cast<double>(high) - static_cast<double>(low)));
  }
  return largest;
}

// The largest distance between a vertex and where the original has it, in half extents.
double largestError(const Result& result, double scale, const glm::dvec3& shift) {
  const SceneDescription original = cornell();
  double error = 0.0;
  std::size_t triangle = 0;
  for (const ShapeDescription& shape : original.shapes) {
    for (const auto& corners : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      const auto found = viewOf(result.flat).corners(result.flat.triangles.at(triangle++));
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3& p = shape.vertices[static_cast<std::size_t>(corners[k])];
        const glm::dvec3 expected = normalisedPoint(result.normalisation, (p + shift) * scale);
        for (std::size_t i = 0; i < 3; ++i) {
          error = std::max(
              error, std::abs(static_cast<double>(found[k][i]) - expected[static_cast<int>(i)]));
        }
      }
    }
  }
  return error / halfExtent(result.flat);
}

TEST(Normalise, LeavesComfortableScenesAlone) {
  for (const double scale : {1e-4, 1e-2, 1.0, 10.0}) {
    EXPECT_TRUE(isIdentity(chooseNormalisation(moved(cornell(), scale, {0, 0, 0})))) << scale;
  }
  EXPECT_TRUE(isIdentity(chooseNormalisation(moved(cornell(), 1.0, {1000, -1000, 500}))));
}

TEST(Normalise, BringsEveryScaleAndShiftNearOneAndTheOrigin) {
  for (int exponent = -90; exponent <= 90; exponent += 6) {
    for (const double shift : {0.0, 1e4, -1e6, 1e9}) {
      SCOPED_TRACE(fmt::format("scale 1e{}, shift {}", exponent, shift));
      const double scale = std::pow(10.0, exponent);
      const Result result = normalisedFlat(moved(cornell(), scale, glm::dvec3(shift)));
      const double half = halfExtent(result.flat);
      if (isIdentity(result.normalisation)) {
        EXPECT_GE(half, 0.99e-2);
        EXPECT_LE(half, 1.01e4);
      } else if (result.normalisation.scale != 1.0) {
        EXPECT_GE(half, 0.999);
        EXPECT_LE(half, 2.001);
      }
      // Double carries the shift with 16 digits, float the result with 7.
      const double lost = std::abs(shift) * 1e-15;
      EXPECT_LE(largestError(result, scale, glm::dvec3(shift)), 4e-7 + lost);
    }
  }
}

TEST(Normalise, ScalesByPowersOfTwoSoThatFloatsKeepTheirDigits) {
  const FlatScene original = normalisedFlat(cornell()).flat;
  for (const int exponent : {-300, -40, 40, 300}) {
    const Result result = normalisedFlat(moved(cornell(), std::ldexp(1.0, exponent), {0, 0, 0}));
    int found = 0;
    EXPECT_EQ(std::frexp(result.normalisation.scale, &found), 0.5);
    const float ratio = result.flat.camera.eye[2] / original.camera.eye[2];
    ASSERT_EQ(result.flat.triangles.size(), original.triangles.size());
    for (std::size_t i = 0; i < original.triangles.size(); ++i) {
      EXPECT_EQ(result.flat.triangles[i].normal, original.triangles[i].normal);
    }
    ASSERT_EQ(result.flat.vertices.size(), original.vertices.size());
    for (std::size_t i = 0; i < original.vertices.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(result.flat.vertices[i][c], ratio * original.vertices[i][c]);
      }
    }
  }
}

TEST(Normalise, LeavesAScenesDetailAloneThatIsOffTheMiddle) {
  // A floor from 0 to 8e5 has its middle at 4e5: near it, float has steps of 0.03.
  const LoadedScene scene = loadText(sceneWith(
      R"({"type": "quad", "material": "a", "vertices": [[0,0,0],[8e5,0,0],[8e5,0,-8e5],[0,0,-8e5]]},
         {"type": "sphere", "material": "a", "centre": [1.1, 0.7, -1.3], "radius": 0.3})"));
  const double x = static_cast<double>(scene.flat.spheres[0].centre[0]);
  const Normalisation& n = scene.normalisation;
  EXPECT_NEAR(x / n.scale + n.shift[0], 1.1, 1e-7);
  EXPECT_FALSE(isIdentity(n));
}

TEST(Normalise, SaysWhatItDidInTheCoordinatesOfTheFile) {
  std::string text =
      sceneWith(R"({"type": "sphere", "material": "a", "centre": [1e7, 0, 0], "radius": 2})");
  text.replace(text.find("[0, 0, 5]"), 9, "[1e7, 0, 5]");
  text.replace(text.find("[0, 0, 0]"), 9, "[1e7, 0, 0]");
  const LoadedScene scene = loadText(text);
  EXPECT_EQ(scene.normalisation.shift, (std::array{1e7, 0.0, 1.5}));
  EXPECT_EQ(scene.normalisation.scale, 1.0);
  ASSERT_FALSE(scene.notes.empty());
  EXPECT_NE(scene.notes[0].find("1e+07"), std::string::npos) << scene.notes[0];
}

TEST(Normalise, AcceptsAnEmptySceneAnywhere) {
  std::string text = sceneWith("");
  text.replace(text.find("[0, 0, 5]"), 9, "[1e99, 0, 5]");
  EXPECT_TRUE(loadText(text).flat.triangles.empty());
}

}  // namespace
}  // namespace pathmark
