#include "scene/normalise.h"
#include "scene_files.h"

#include <algorithm>
#include <vector>

namespace pathmark {
namespace {

const std::filesystem::path kRoot = PATHMARK_ROOT;

std::vector<std::filesystem::path> sceneFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  // A student kit has no solutions.
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() == ".json" && file.stem().extension() != ".schema") files.push_back(file);
  }
  return files;
}

LoadedScene shipped(const std::string& name) {
  return loadScene(kRoot / "scenes" / (name + ".json"));
}

std::size_t litFaces(const LoadedScene& scene) { return scene.flat.faces.size(); }

TEST(ShippedScenes, AllLoadWithACaptionAndWithoutNotes) {
  const auto files = sceneFiles(kRoot / "scenes");
  EXPECT_GE(files.size(), 6u);
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    const LoadedScene scene = loadScene(file);
    EXPECT_EQ(scene.name, file.stem().string());
    EXPECT_FALSE(scene.caption.empty());
    EXPECT_TRUE(scene.notes.empty());
    EXPECT_FALSE(scene.flat.lights.empty());
  }
}

TEST(ShippedScenes, KeepTheCoordinatesOfTheirFile) {
  for (const auto& file : sceneFiles(kRoot / "scenes")) {
    EXPECT_TRUE(isIdentity(loadScene(file).normalisation)) << file;
  }
}

// The stub as it is handed out; a student's own copy is theirs to change and to break.
TEST(ShippedScenes, TheStudentsSceneIsValidAndNotWrittenYet) {
  if (!std::filesystem::exists(kRoot / "solutions")) GTEST_SKIP() << "a student's own copy";
  EXPECT_TRUE(loadScene(kRoot / "student" / "scenes" / "my_scene.json").caption.empty());
}

TEST(ShippedScenes, TheSolvedSceneHasACaption) {
  for (const auto& file : sceneFiles(kRoot / "solutions" / "scenes")) {
    const LoadedScene scene = loadScene(file);
    EXPECT_FALSE(scene.caption.empty()) << file;
    EXPECT_TRUE(scene.notes.empty()) << file;
  }
}

TEST(ShippedScenes, CornellBoxIsSixteenQuadsAndARectangle) {
  const LoadedScene scene = shipped("cornell_box");
  EXPECT_EQ(scene.flat.camera.width, 256u);
  EXPECT_EQ(scene.flat.maxBounces, 8u);
  EXPECT_EQ(scene.flat.shapes.size(), 16u);
  EXPECT_EQ(scene.flat.triangles.size(), 32u);
  ASSERT_EQ(scene.flat.lights.size(), 1u);
  ASSERT_EQ(litFaces(scene), 1u);
  EXPECT_EQ(scene.flat.faces[0].vertexCount, 4u);
  EXPECT_EQ(scene.flat.faces[0].normal, (Float3{0.0f, -1.0f, 0.0f}));
  EXPECT_EQ(scene.flat.lights[0].emission, (Float3{17.0f, 12.0f, 4.0f}));
}

TEST(ShippedScenes, TheFrontsOfTheCornellBoxFaceItsInside) {
  const LoadedScene scene = shipped("cornell_box");
  for (const FlatTriangle& t : scene.flat.triangles) {
    if (t.shape >= 6) continue;  // the blocks
    const std::array<float, 3> inside{278.0f, 273.0f, 280.0f};
    float side = 0.0f;
    for (std::size_t k = 0; k < 3; ++k)
      side += t.normal[k] * (inside[k] - scene.flat.vertices[t.vertex[0]][k]);
    EXPECT_GT(side, 0.0f) << "shape " << t.shape;
  }
}

TEST(ShippedScenes, TheUclLightsAreARectangleATriangleAndASphere) {
  EXPECT_EQ(shipped("ucl_rectangle").flat.faces.at(0).vertexCount, 4u);
  EXPECT_EQ(shipped("ucl_rectangle").exposure, 30.0);
  EXPECT_EQ(shipped("ucl_triangle").flat.faces.at(0).vertexCount, 3u);
  const LoadedScene sphere = shipped("ucl_sphere");
  EXPECT_EQ(litFaces(sphere), 0u);
  EXPECT_EQ(sphere.flat.lights.at(0).sphere, 2u);
}

TEST(ShippedScenes, TheFrontWallOfTheUclBoxIsOnlySeenFromInside) {
  const LoadedScene scene = shipped("ucl_rectangle");
  for (const FlatShape& shape : scene.flat.shapes) {
    const bool isSphere =
        std::any_of(scene.flat.spheres.begin(), scene.flat.spheres.end(),
                    [&](const FlatSphere& s) { return &scene.flat.shapes[s.shape] == &shape; });
    EXPECT_EQ(shape.frontOnly, isSphere ? 0u : 1u);
  }
}

TEST(ShippedScenes, EverySurfaceOfTheFurnaceReflectsAndEmitsOneHalf) {
  const LoadedScene scene = shipped("furnace");
  EXPECT_TRUE(scene.flat.triangles.empty());
  ASSERT_EQ(scene.flat.spheres.size(), 2u);
  EXPECT_EQ(scene.flat.lights.size(), 2u);
  for (const FlatShape& shape : scene.flat.shapes) {
    EXPECT_EQ(shape.emission, (Float3{0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(scene.flat.materials[shape.material].kd, (Float3{0.5f, 0.5f, 0.5f}));
  }
  EXPECT_EQ(scene.flat.spheres[0].inward, 1u);
  EXPECT_EQ(scene.flat.spheres[1].inward, 0u);
}

}  // namespace
}  // namespace pathmark
