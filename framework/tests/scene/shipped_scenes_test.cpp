#include "shipped_scenes.h"
#include "scene/normalise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace pathmark {
namespace {

std::size_t litFaces(const LoadedScene& scene) { return scene.flat.faces.size(); }

TEST(ShippedScenes, AllLoadWithACaptionAndWithoutNotes) {
  const auto files = sceneFiles(kRoot / "scenes");
  EXPECT_GE(files.size(), 15u);
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    const LoadedScene scene = loadShipped(file);
    EXPECT_EQ(scene.name, file.stem().string());
    EXPECT_FALSE(scene.caption.empty());
    EXPECT_TRUE(scene.notes.empty());
    EXPECT_FALSE(scene.flat.lights.empty());
    for (const FlatLight& light : scene.flat.lights) EXPECT_GT(powerOf(scene.flat, light), 0.0);
  }
}

TEST(ShippedScenes, KeepTheCoordinatesOfTheirFile) {
  for (const auto& file : sceneFiles(kRoot / "scenes")) {
    EXPECT_TRUE(isIdentity(loadShipped(file).normalisation)) << file;
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

TEST(ShippedScenes, CornellPhongHasOnePhongBallAndASphereLight) {
  const FlatScene scene = shipped("cornell_phong").flat;
  int phongSpheres = 0;
  for (const FlatSphere& sphere : scene.spheres) {
    const FlatMaterial& material = scene.materials[scene.shapes[sphere.shape].material];
    if (material.kind != FlatMaterialKind::kPhong) continue;
    ++phongSpheres;
    // The tint: red is reflected best, blue least.
    EXPECT_GT(material.ks[0], material.ks[1]);
    EXPECT_GT(material.ks[1], material.ks[2]);
  }
  EXPECT_EQ(phongSpheres, 1);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_NE(scene.lights[0].sphere, FlatLight::kNoSphere);
}

TEST(ShippedScenes, ManyLightsAreTwelveOfAllShapesAndOfVeryUnequalPower) {
  const FlatScene scene = shipped("many_lights").flat;
  ASSERT_EQ(scene.lights.size(), 12u);
  std::vector<double> powers;
  std::set<std::uint32_t> corners;
  for (const FlatLight& light : scene.lights) {
    powers.push_back(powerOf(scene, light));
    corners.insert(light.sphere != FlatLight::kNoSphere ? 0
                                                        : scene.faces[light.firstFace].vertexCount);
  }
  EXPECT_EQ(corners, (std::set<std::uint32_t>{0, 3, 4}));
  std::sort(powers.begin(), powers.end());
  EXPECT_GT(powers.back() / powers.front(), 100.0);
  // The caption: the weaker six have a fifteenth of the power.
  const double weak = std::accumulate(powers.begin(), powers.begin() + 6, 0.0);
  const double all = std::accumulate(powers.begin(), powers.end(), 0.0);
  EXPECT_NEAR(all / weak, 15.0, 0.5);
}

TEST(ShippedScenes, TheStarOfPolygonLightIsConcave) {
  const FlatScene scene = shipped("polygon_light").flat;
  for (const FlatFace& face : scene.faces) {
    const auto vertex = [&](std::uint32_t k) {
      return toDouble(scene.lightVertices[face.firstVertex + k % face.vertexCount]);
    };
    int left = 0, right = 0;
    for (std::uint32_t k = 0; k < face.vertexCount; ++k) {
      const glm::dvec3 turn = glm::cross(vertex(k + 1) - vertex(k), vertex(k + 2) - vertex(k + 1));
      (glm::dot(turn, toDouble(face.normal)) > 0.0 ? left : right)++;
    }
    EXPECT_EQ(left, 5);
    EXPECT_EQ(right, 5);
  }
}

TEST(ShippedScenes, VeachsLightsHaveEqualPowerAndHisPlatesVeryUnequalExponents) {
  const FlatScene scene = shipped("veach_plates").flat;
  ASSERT_EQ(scene.lights.size(), 4u);
  for (const FlatLight& light : scene.lights) {
    ASSERT_NE(light.sphere, FlatLight::kNoSphere);
    EXPECT_NEAR(powerOf(scene, light), powerOf(scene, scene.lights[0]), 1e-3);
  }
  std::set<float> exponents;
  for (const FlatMaterial& material : scene.materials)
    if (material.kind == FlatMaterialKind::kPhong) exponents.insert(material.exponent);
  EXPECT_EQ(exponents, (std::set<float>{30.0f, 300.0f, 3000.0f, 30000.0f}));
}

// The mirror direction at each plate's centre leads from the eye to the row of lights.
TEST(ShippedScenes, VeachsPlatesMirrorTheLightsToTheEye) {
  const FlatScene scene = shipped("veach_plates").flat;
  const glm::dvec3 eye = toDouble(scene.camera.eye);
  int halves = 0;
  for (const FlatTriangle& t : scene.triangles) {
    if (scene.materials[scene.shapes[t.shape].material].kind != FlatMaterialKind::kPhong) continue;
    ++halves;
    const glm::dvec3 a = toDouble(scene.vertices[t.vertex[0]]),
                     b = toDouble(scene.vertices[t.vertex[1]]),
                     c = toDouble(scene.vertices[t.vertex[2]]);
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    // Both halves of a rectangle share the diagonal from the first corner to the third.
    const glm::dvec3 centre = std::abs((a.x + c.x) / 2.0) < 1e-6 ? (a + c) / 2.0 : (a + b) / 2.0;
    const glm::dvec3 toLight = glm::reflect(glm::normalize(centre - eye), n);
    EXPECT_LT(glm::length(glm::cross(toLight, -centre)), 0.01);
  }
  EXPECT_EQ(halves, 8);
}

// From the camera, all that faces it is white: the painted sides are those of the fins that look
// away from the eye.
TEST(ShippedScenes, NoColourOfTheHiddenColoursFacesTheEye) {
  const FlatScene scene = shipped("diy_hidden_colours").flat;
  const glm::dvec3 eye = toDouble(scene.camera.eye);
  int painted = 0;
  for (const FlatTriangle& t : scene.triangles) {
    const FlatShape& shape = scene.shapes[t.shape];
    const Float3& kd = scene.materials[shape.material].kd;
    if (kd[0] == kd[1] && kd[1] == kd[2]) continue;
    ++painted;
    const glm::dvec3 a = toDouble(scene.vertices[t.vertex[0]]),
                     b = toDouble(scene.vertices[t.vertex[1]]),
                     c = toDouble(scene.vertices[t.vertex[2]]);
    EXPECT_LT(glm::dot(glm::cross(b - a, c - a), eye - a), 0.0);
  }
  EXPECT_EQ(painted, 10);
}

TEST(ShippedScenes, TheCausticIsThrownByPhongAndLitByOneSmallLamp) {
  const FlatScene scene = shipped("diy_caustic").flat;
  ASSERT_EQ(scene.lights.size(), 1u);
  std::size_t phong = 0;
  for (const FlatTriangle& t : scene.triangles)
    phong += scene.materials[scene.shapes[t.shape].material].kind == FlatMaterialKind::kPhong;
  EXPECT_EQ(phong, 80u);
}

TEST(ShippedScenes, TheLampBehindTheDoorIsInTheOtherRoom) {
  const FlatScene scene = shipped("diy_door_ajar").flat;
  ASSERT_EQ(scene.lights.size(), 1u);
  ASSERT_NE(scene.lights[0].sphere, FlatLight::kNoSphere);
  const FlatSphere& lamp = scene.spheres[scene.lights[0].sphere];
  EXPECT_LT(lamp.centre[2] + lamp.radius, -2.12f);
  EXPECT_GT(scene.camera.eye[2], -2.0f);
}

TEST(ShippedScenes, TheBlobIsAFloorALightAndItsMesh) {
  const FlatScene scene = shipped("blob").flat;
  constexpr int kTriangles = 8 * BlobFolder::kSubdivisions * BlobFolder::kSubdivisions;
  EXPECT_EQ(scene.shapes.size(), 3u);
  EXPECT_EQ(scene.triangles.size(), static_cast<std::size_t>(kTriangles) + 4);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].emission, (Float3{10.0f, 10.0f, 10.0f}));
}

}  // namespace
}  // namespace pathmark
