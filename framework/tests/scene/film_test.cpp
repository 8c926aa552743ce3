#include "scene/film.h"

#include "scene/to_float.h"
#include "scene_files.h"

#include <cmath>

namespace pathmark {
namespace {

const std::filesystem::path kRoot = PATHMARK_ROOT;

// The film point, in pixels from the top left, at which the camera sees a point of the scene.
glm::dvec2 filmPoint(const FlatCamera& camera, const glm::dvec3& point) {
  const glm::dvec3 toPoint = point - toDouble3(camera.eye);
  const glm::dvec3 right = toDouble3(camera.pixelRight), down = toDouble3(camera.pixelDown);
  const glm::dvec3 normal = glm::cross(right, down);
  const glm::dvec3 topLeft = toDouble3(camera.topLeft);
  const double stretch = glm::dot(topLeft, normal) / glm::dot(toPoint, normal);
  EXPECT_GT(stretch, 0.0) << "the point is behind the camera";
  const glm::dvec3 onFilm = stretch * toPoint - topLeft;
  return {glm::dot(onFilm, right) / glm::dot(right, right),
          glm::dot(onFilm, down) / glm::dot(down, down)};
}

void expectNear(const glm::dvec2& found, const glm::dvec2& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
}

TEST(Film, SeesTheTargetInTheMiddle) {
  const LoadedScene scene = loadText(sceneWith(""), {.size = std::array{300, 200}});
  expectNear(filmPoint(scene.flat.camera, {0, 0, 0}), {150, 100}, 1e-4);
}

TEST(Film, SeesTheRedWallOfTheCornellBoxOnTheLeft) {
  const FlatCamera camera = loadScene(kRoot / "scenes" / "cornell_box.json").flat.camera;
  const glm::dvec2 red = filmPoint(camera, {550, 273, 280});
  const glm::dvec2 green = filmPoint(camera, {0, 273, 280});
  EXPECT_LT(red.x, 64);
  EXPECT_GT(green.x, 192);
}

TEST(Film, SeesTheCornersOfTheCornellBoxWherePerspectivePutsThem) {
  const FlatCamera camera = loadScene(kRoot / "scenes" / "cornell_box.json").flat.camera;
  const double focal = 128.0 / std::tan(39.3 / 2.0 * 3.14159265358979323846 / 180.0);
  const glm::dvec3 corners[] = {{552.8, 0, 0}, {0, 0, 559.2}, {556, 548.8, 559.2}, {0, 548.8, 0}};
  for (const glm::dvec3& c : corners) {
    const double depth = c.z + 800.0;
    const glm::dvec2 expected{128.0 - focal * (c.x - 278.0) / depth,
                              128.0 - focal * (c.y - 273.0) / depth};
    expectNear(filmPoint(camera, c), expected, 1e-3);
  }
}

TEST(Film, OfTheUclSceneIsTheWindowOfTwoAroundTheAxis) {
  const FlatCamera camera = loadScene(kRoot / "scenes" / "ucl_rectangle.json").flat.camera;
  expectNear(filmPoint(camera, {-2, 2, 2}), {0, 0}, 1e-3);
  expectNear(filmPoint(camera, {2, -2, 2}), {250, 250}, 1e-3);
}

TEST(Film, ItsUpVectorHasUnitLengthWhateverTheFilesHas) {
  for (const char* length : {"1e-300", "1e-170", "1", "1e99"}) {
    std::string text = sceneWith("");
    text.insert(text.find("\"fieldOfView\""), fmt::format("\"up\": [0, {}, 0], ", length));
    EXPECT_EQ(loadText(text).up, (std::array{0.0, 1.0, 0.0})) << length;
  }
}

TEST(Film, HasSquarePixelsInEverySize) {
  for (const auto& size : {std::array{640, 360}, std::array{1, 1000}, std::array{16384, 3}}) {
    const FlatCamera camera = loadText(sceneWith(""), {.size = size}).flat.camera;
    const glm::dvec3 right = toDouble3(camera.pixelRight), down = toDouble3(camera.pixelDown);
    EXPECT_NEAR(glm::length(right) / glm::length(down), 1.0, 1e-6);
    EXPECT_NEAR(glm::dot(right, down) / glm::dot(right, right), 0.0, 1e-6);
  }
}

TEST(Film, KeepsTheVerticalFieldOfViewInEverySize) {
  for (const auto& size : {std::array{100, 100}, std::array{400, 100}, std::array{40, 100}}) {
    const FlatCamera camera = loadText(sceneWith(""), {.size = size}).flat.camera;
    // At distance 5 the film of 45 degrees reaches up to 5 tan(22.5 degrees).
    const glm::dvec2 top = filmPoint(camera, {0, 5.0 * std::tan(3.14159265358979323846 / 8), 0});
    expectNear(top, {size[0] / 2.0, 0.0}, 1e-3);
  }
}

TEST(Film, IsWellScaledForEveryFieldOfView) {
  const SceneSource source;
  const Place top(source);
  for (const double degrees : {1e-300, 1e-3, 1.0, 90.0, 179.0, 179.999999999}) {
    CameraDescription camera;
    camera.eye = {1e90, -3.0, 1e-90};
    camera.target = {0.0, 1e80, 0.0};
    camera.fieldOfView = degrees;
    const FlatCamera film = makeFilm(camera, 64, 48, top);
    const double length = glm::length(toDouble3(film.topLeft));
    EXPECT_GT(length, 0.5) << degrees;
    EXPECT_LT(length, 2.0) << degrees;
  }
}

TEST(Film, SaysWhenItsPixelsCannotBeToldApart) {
  std::string text = sceneWith("");
  text.replace(text.find("45"), 2, "1e-6");
  const LoadedScene scene = loadText(text);
  ASSERT_EQ(scene.notes.size(), 2u);  // the scene is empty as well
  EXPECT_NE(scene.notes[0].find("field of view"), std::string::npos);
}

}  // namespace
}  // namespace pathmark
