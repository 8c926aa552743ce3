// Scenes for other renderers: read back by what pbrt's and Mitsuba's documentation says.
#include "export/export_scene.h"
#include "host/session.h"
#include "scene/load_scene.h"
#include "support/pbrt_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstring>

namespace pathmark::test {
namespace {

LoadedScene shipped(const std::string& name) { return loadScene(shippedSceneFile(name)); }

const PbrtStatement& only(const std::vector<PbrtStatement>& all, const std::string& directive) {
  const PbrtStatement* found = nullptr;
  for (const PbrtStatement& s : all)
    if (s.directive == directive) {
      EXPECT_EQ(found, nullptr) << directive << " stands there twice";
      found = &s;
    }
  EXPECT_NE(found, nullptr) << directive;
  return *found;
}

std::vector<PbrtStatement> pbrtOf(const LoadedScene& scene, std::uint64_t rays = 64) {
  return readPbrt(exportPbrt(worldScene(scene), {"scene", rays}).front().content);
}

TEST(ExportPbrt, EveryShippedSceneFollowsTheGrammar) {
  for (const std::string& name : shippedSceneNames()) {
    if (name == "blob") continue;  // its mesh is made by a command
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(pbrtOf(shipped(name)));
  }
}

TEST(ExportPbrt, FilmRaysAndBouncesAreTheScenes) {
  const LoadedScene scene = shipped("veach_plates");
  const std::vector<PbrtStatement> all = pbrtOf(scene, 144);
  EXPECT_EQ(only(all, "Film").numbers("xresolution").at(0), 288.0);
  EXPECT_EQ(only(all, "Film").numbers("yresolution").at(0), 192.0);
  EXPECT_EQ(only(all, "Sampler").numbers("pixelsamples").at(0), 144.0);
  EXPECT_EQ(only(all, "Integrator").words.at(0), "path");
  EXPECT_EQ(only(all, "Integrator").numbers("maxdepth").at(0), 4.0);
}

// Through the film's corner goes the same ray. pbrt: x right, y up, z forward, left-handed, with
// the field of view along the shorter side; Scale -1 1 1 turns x round.
void expectSameCamera(const LoadedScene& scene) {
  const std::vector<PbrtStatement> all = pbrtOf(scene);
  EXPECT_EQ(only(all, "Scale").bare, (std::vector<double>{-1, 1, 1}));
  const std::vector<double>& l = only(all, "LookAt").bare;
  ASSERT_EQ(l.size(), 9u);
  const glm::dvec3 eye(l[0], l[1], l[2]), target(l[3], l[4], l[5]), up(l[6], l[7], l[8]);
  const glm::dvec3 forward = normalize(target - eye);
  const glm::dvec3 right = -normalize(cross(up, forward)), above = cross(right, forward);
  const double fov = only(all, "Camera").numbers("fov").at(0) * glm::pi<double>() / 180.0;
  const FlatCamera& c = scene.flat.camera;
  const double half = std::tan(0.5 * fov) / std::min(c.width, c.height);
  const glm::dvec3 corner = normalize(forward - half * c.width * right + half * c.height * above);
  const glm::dvec3 ours = normalize(glm::dvec3(c.topLeft[0], c.topLeft[1], c.topLeft[2]));
  EXPECT_LT(length(corner - ours), 1e-5);
}

TEST(ExportPbrt, TheCameraSeesTheSame) {
  expectSameCamera(shipped("cornell_box"));
  expectSameCamera(shipped("veach_plates"));
  expectSameCamera(
      loadScene(shippedSceneFile("cornell_box"), {.size = {{64, 96}}, .maxBounces = {}}));
}

TEST(ExportPbrt, LightsShineFromTheSideOfTheNormal) {
  const std::vector<PbrtStatement> all = pbrtOf(shipped("cornell_box"));
  const PbrtStatement& light = only(all, "AreaLightSource");
  EXPECT_EQ(light.words.at(0), "diffuse");
  EXPECT_EQ(light.texts("twosided"), (std::vector<std::string>{"false"}));
  EXPECT_EQ(light.numbers("L").size(), 3u);
}

TEST(ExportPbrt, ASphereThatShinesInwardsIsTurnedRound) {
  int turned = 0;
  for (const PbrtStatement& s : pbrtOf(shipped("furnace")))
    turned += s.directive == "ReverseOrientation" ? 1 : 0;
  EXPECT_GE(turned, 1);
}

// Triangles keep their order: (p1 - p0) x (p2 - p0) points to the front.
TEST(ExportPbrt, TrianglesFaceTheWayTheyDo) {
  const LoadedScene scene = shipped("cornell_box");
  const WorldScene world = worldScene(scene);
  std::size_t triangles = 0;
  for (const WorldMesh& mesh : world.meshes) {
    std::size_t next = 0;
    for (const FlatTriangle& flat : scene.flat.triangles) {
      if (flat.shape != mesh.shape) continue;
      const auto& t = mesh.triangles.at(next++);
      const glm::dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
      const glm::dvec3 n(flat.normal[0], flat.normal[1], flat.normal[2]);
      EXPECT_GT(dot(normalize(cross(b - a, c - a)), n), 0.999);
    }
    triangles += next;
  }
  EXPECT_EQ(triangles, scene.flat.triangles.size());
}

LoadedScene loadText(const std::string& text) { return loadScene(SceneSource{"made.json", text}); }

// Two spheres, small and large, in front of an eye, with all lengths in this unit.
std::string spheresInUnits(double unit, const std::string& caption = "") {
  return fmt::format(R"({{
    "caption": "{1}",
    "camera": {{"eye": [0, 0, {2}], "target": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 45}},
    "materials": {{"white": {{"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}}}},
    "shapes": [{{"type": "sphere", "material": "white", "centre": [0, 0, 0], "radius": {0}}},
               {{"type": "sphere", "material": "white", "centre": [0, 0, {3}],
                 "radius": {4}}}]}})",
                     unit, caption, 1.001 * unit, -20000.0 * unit, 15000.0 * unit);
}

std::string mitsubaOf(const LoadedScene& scene) {
  return exportMitsuba(worldScene(scene), {"scene"}).front().content;
}

double valueIn(const std::string& xml, const std::string& name) {
  const std::string before = "name=\"" + name + "\" value=\"";
  const std::size_t at = xml.find(before);
  EXPECT_NE(at, std::string::npos) << name;
  return at == std::string::npos ? 0.0 : std::stod(xml.substr(at + before.size()));
}

// From the sphere's nearest point, 0.001 units away, to the other sphere's farthest.
TEST(ExportMitsuba, WhatTheCameraSeesLiesBetweenTheClippingPlanes) {
  for (const double unit : {1e-13, 1e-5, 1.0, 1000.0, 1e13}) {
    SCOPED_TRACE(unit);
    const std::string xml = mitsubaOf(loadText(spheresInUnits(unit)));
    const float near = static_cast<float>(valueIn(xml, "near_clip"));
    const float far = static_cast<float>(valueIn(xml, "far_clip"));
    EXPECT_GT(near, 0.0f);
    EXPECT_LT(near, 0.1 * 0.001 * unit);
    EXPECT_GT(far, 35001.0 * unit);
    EXPECT_LT(far, 1e6 * unit);
    // Mitsuba divides by it.
    EXPECT_TRUE(std::isnormal(near * far));
  }
}

TEST(ExportMitsuba, ACommentHasNoCharacterThatXmlForbids) {
  const std::string xml =
      mitsubaOf(loadText(spheresInUnits(1.0, R"(a\u0001b\u001bc\ufffed, na\u00efve --- one)")));
  EXPECT_NE(xml.find("<!-- a?b?c?d, na\u00efve - - - one -->"), std::string::npos)
      << xml.substr(0, 1000);
}

TEST(ExportFloats, HoldScenesOfOrdinarySizes) {
  for (const double unit : {1e-13, 1e-5, 1.0, 1e13})
    EXPECT_NO_THROW(requireFloats(worldScene(loadText(spheresInUnits(unit))))) << unit;
}

TEST(ExportFloats, ASceneThatTheyCannotHoldIsRefused) {
  for (const double unit : {1e-60, 1e-25, 1e18, 1e60})
    EXPECT_THROW(requireFloats(worldScene(loadText(spheresInUnits(unit)))), SceneError) << unit;
  WorldScene wide = worldScene(loadText(spheresInUnits(1.0)));
  wide.camera.fieldOfView = 179.9999999;
  EXPECT_THROW(requireFloats(wide), SceneError);
}

// A scene that is tiny and far away is normalised for our worker. It has its size again there, but
// stays at the origin.
TEST(ExportWorld, LengthsAreThoseOfTheFile) {
  const std::string text = R"({
    "camera": {"eye": [1000000, 0, 0.003], "target": [1000000, 0, 0], "up": [0, 1, 0],
               "fieldOfView": 45},
    "materials": {"white": {"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
    "shapes": [{"type": "sphere", "material": "white", "centre": [1000000, 0.00025, 0],
                "radius": 0.001}]})";
  const LoadedScene scene = loadText(text);
  ASSERT_NE(scene.normalisation.shift[0], 0.0);
  const WorldScene world = worldScene(scene);
  const glm::dvec3 origin(world.origin[0], world.origin[1], world.origin[2]);
  EXPECT_NEAR(world.camera.eye.x + origin.x, 1e6, 1e-6);
  EXPECT_NEAR(world.camera.eye.z + origin.z, 0.003, 1e-7);
  EXPECT_NEAR(world.spheres.at(0).centre.y + origin.y, 0.00025, 1e-9);
  EXPECT_NEAR(world.spheres.at(0).radius, 0.001, 1e-9);
  EXPECT_LT(length(world.camera.eye), 0.01);
}

// A room with a lamp of 1 x 1, where floats are 8 apart.
std::string roomFarAway() {
  return R"({
    "camera": {"eye": [1e8, 50000001, 3.4], "target": [1e8, 50000001, 0], "fieldOfView": 50},
    "materials": {"white": {"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
    "shapes": [{"type": "box", "low": [99999998, 50000000, -2], "high": [100000002, 50000002.5, 3.5],
                "inward": true, "material": "white"},
               {"type": "rectangle", "material": "white", "emission": [9, 8, 7],
                "vertices": [[99999999.5, 50000002.4, -0.5], [100000000.5, 50000002.4, -0.5],
                             [100000000.5, 50000002.4, 0.5], [99999999.5, 50000002.4, 0.5]]}]})";
}

glm::dvec3 pointAt(const std::vector<double>& numbers, double index) {
  const auto at = 3 * static_cast<std::size_t>(index);
  return {numbers.at(at), numbers.at(at + 1), numbers.at(at + 2)};
}

TEST(ExportPbrt, ALampFarFromTheOriginKeepsItsArea) {
  const std::vector<PbrtStatement> all = pbrtOf(loadText(roomFarAway()));
  double area = 0.0;
  bool shines = false;
  for (const PbrtStatement& s : all) {
    if (s.directive == "AttributeBegin") shines = false;
    if (s.directive == "AreaLightSource") shines = true;
    if (s.directive != "Shape" || !shines) continue;
    const std::vector<double>&points = s.numbers("P"), &indices = s.numbers("indices");
    for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
      const glm::dvec3 a = pointAt(points, indices[t]);
      area += 0.5 * length(cross(pointAt(points, indices[t + 1]) - a,
                                 pointAt(points, indices[t + 2]) - a));
    }
  }
  EXPECT_NEAR(area, 1.0, 1e-5);
  expectSameCamera(loadText(roomFarAway()));
}

TEST(ExportNotes, SayThatAFarSceneIsMoved) {
  const LoadedScene far = loadText(roomFarAway());
  const WorldScene world = worldScene(far);
  ASSERT_TRUE(world.isMoved());
  for (const ExportFormat format : {ExportFormat::kPbrt, ExportFormat::kMitsuba})
    EXPECT_NE(exportNotes(world, format).at(0).find("the point (100000000, 50000001.25, 0.75)"),
              std::string::npos)
        << exportNotes(world, format).at(0);
  const std::string pbrt = exportPbrt(world, {"scene"}).front().content;
  EXPECT_NE(pbrt.find("# Note: The scene is far from the origin"), std::string::npos);
  EXPECT_NE(mitsubaOf(far).find("<!-- Note: The scene is far from the origin"), std::string::npos);
  EXPECT_FALSE(worldScene(shipped("cornell_box")).isMoved());
}

TEST(ExportPhong, TheMixtureReflectsAsMuch) {
  const FlatMaterial m{FlatMaterialKind::kPhong, {0.3f, 0.2f, 0.1f}, {0.5f, 0.4f, 0.3f}, 50.0f};
  const PhongMixture mixture = phongMixture(m);
  EXPECT_FALSE(mixture.clamped);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR((1.0 - mixture.weight) * mixture.diffuse[k], m.kd[static_cast<std::size_t>(k)],
                1e-6);
    EXPECT_NEAR(mixture.weight * mixture.specular[k], m.ks[static_cast<std::size_t>(k)], 1e-6);
    EXPECT_LE(mixture.diffuse[k], 1.0);
    EXPECT_LE(mixture.specular[k], 1.0);
  }
}

TEST(ExportPhong, WhatNoMixtureReflectsIsSaid) {
  const FlatMaterial m{FlatMaterialKind::kPhong, {0.9f, 0.0f, 0.0f}, {0.0f, 0.9f, 0.0f}, 50.0f};
  EXPECT_TRUE(phongMixture(m).clamped);
}

// The width of both lobes, as the mean square of the half vector's angle to the normal: of
// cos^m(2 h) and of exp(-tan^2 h / alpha^2) cos^-4 h, over the plane of small h.
TEST(ExportPhong, TheLobeIsAboutAsWide) {
  for (const double m : {30.0, 300.0, 3000.0}) {
    double phong = 0.0, phongAll = 0.0, beckmann = 0.0, beckmannAll = 0.0;
    const double alpha = phongRoughness(m);
    for (int k = 0; k < 20000; ++k) {
      const double h = (k + 0.5) * 1e-3 * 0.7 / 20.0;
      const double p = std::pow(std::max(std::cos(2.0 * h), 0.0), m) * h;
      const double b = std::exp(-std::pow(std::tan(h) / alpha, 2.0)) * h;
      phong += h * h * p;
      phongAll += p;
      beckmann += h * h * b;
      beckmannAll += b;
    }
    EXPECT_NEAR(std::sqrt(phong / phongAll) / std::sqrt(beckmann / beckmannAll), 1.0, 0.03) << m;
  }
}

TEST(ExportNotes, SayWhatHasNoCounterpart) {
  const auto has = [](const std::vector<std::string>& notes, const std::string& words) {
    for (const std::string& note : notes)
      if (note.find(words) != std::string::npos) return true;
    return false;
  };
  const WorldScene phong = worldScene(shipped("cornell_phong"));
  for (const ExportFormat format : {ExportFormat::kPbrt, ExportFormat::kMitsuba}) {
    EXPECT_TRUE(has(exportNotes(phong, format), "no modified Phong"));
    EXPECT_TRUE(has(exportNotes(phong, format), "from its front only"));
  }
  const WorldScene box = worldScene(shipped("cornell_box"));
  EXPECT_TRUE(exportNotes(box, ExportFormat::kMitsuba).empty());
  EXPECT_TRUE(has(exportNotes(box, ExportFormat::kPbrt), "both sides"));
}

TEST(ExportPly, HoldsTheMesh) {
  WorldMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2.5, 0}};
  mesh.triangles = {{0, 1, 2}};
  const std::string ply = plyText(mesh);
  const std::string end = "end_header\n";
  const std::size_t body = ply.find(end) + end.size();
  ASSERT_EQ(ply.size() - body, std::size_t{9} * sizeof(float) + 1 + 3 * sizeof(std::int32_t));
  float y = 0.0f;
  std::memcpy(&y, ply.data() + body + 7 * sizeof(float), sizeof y);
  EXPECT_EQ(y, 2.5f);
  EXPECT_EQ(ply[body + 9 * sizeof(float)], 3);
}

}  // namespace
}  // namespace pathmark::test
