// What pathmark bench measures with: its statistics, its scenes, its processes, the peer's scene.
#include "bench/alternate.h"
#include "bench/child_process.h"
#include "bench/cycles_scene.h"
#include "bench/image_error.h"
#include "bench/ray_scenes.h"
#include "bench/report.h"
#include "bench/stress/worse.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace pathmark::bench {
namespace {

using nlohmann::json;
using test::TemporaryFolder;

TEST(BenchStatistics, TheReferencesOwnVarianceIsNoErrorOfTheImage) {
  const Image image{1, 1, {1.5f, 1.0f, 1.0f}};
  const Image reference{1, 1, {1.0f, 1.0f, 1.0f}, {}, {0.05f, 0.0f, 0.0f}};
  const Deviation deviation = deviationOf(image, reference);
  EXPECT_NEAR(deviation.relativeMse, (0.25 - 0.05) / 1.01 / 3.0, 1e-7);
  EXPECT_NEAR(deviation.mean, 0.5 / 3.0, 1e-12);
}

TEST(BenchStatistics, ErrorsAreThoseOfMeans) {
  const Mean mean = meanOf(std::vector<double>{1.0, 2.0, 3.0});
  EXPECT_DOUBLE_EQ(mean.value, 2.0);
  EXPECT_DOUBLE_EQ(mean.error, std::sqrt(2.0 / 6.0));
  EXPECT_DOUBLE_EQ(meanOf(std::vector<double>{4.0}).error, 0.0);
  const Mean inverse = inverseOfProduct({2.0, 0.2}, {5.0, 0.0});
  EXPECT_DOUBLE_EQ(inverse.value, 0.1);
  EXPECT_DOUBLE_EQ(inverse.error, 0.01);
  const Mean ratio = ratioOf({6.0, 0.3 * 6.0}, {2.0, 0.4 * 2.0});
  EXPECT_DOUBLE_EQ(ratio.value, 3.0);
  EXPECT_DOUBLE_EQ(ratio.error, 1.5) << "both count";
}

TEST(BenchStatistics, AnErrorThatIsNoNumberIsTheWorstOfAll) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(worse(1.0, 2.0), 2.0);
  EXPECT_EQ(worse(2.0, 1.0), 2.0);
  EXPECT_EQ(worse(1.0, none), infinite);
  EXPECT_EQ(worse(none, 1.0), infinite);
  EXPECT_EQ(worse(infinite, 1.0), infinite);
}

TEST(BenchStatistics, TheMedianOfAnEvenNumberLiesBetween) {
  EXPECT_EQ(median({5.0, 1.0, 3.0}), 3.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
}

TEST(BenchReport, VerdictsKnowWhichWayIsBetter) {
  Figure figure{.key = "a", .name = "a", .value = 3.0};
  EXPECT_EQ(figure.verdict(), "");
  figure.target = Target{2.0, 4.0};
  EXPECT_EQ(figure.verdict(), "met");
  figure.target = Target{2.0, 3.0};
  EXPECT_EQ(figure.verdict(), "met, and the aim");
  figure.target = Target{2.0, 1.0, false};
  EXPECT_EQ(figure.verdict(), "not met");
  figure.target = Target{2.0, 1.0, true};
  figure.value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(figure.verdict(), "not met");
}

TEST(BenchReport, NumbersThatAreNoneBecomeNull) {
  Report report{.command = "c", .machine = "m", .tables = {}, .figures = {}};
  report.figures.push_back({.key = "a", .name = "a", .value = std::nan("")});
  EXPECT_TRUE(json::parse(reportJson(report)).at("figures").at("a").at("value").is_null());
}

TEST(BenchScenes, HaveAsManyPrimitivesAsAskedFor) {
  for (const std::size_t n : {1, 2, 11, 12, 13, 32, 100, 4096})
    EXPECT_EQ(boxRoom(n).flat.triangles.size(), n);
  for (const std::size_t n : {1, 2, 256}) EXPECT_EQ(sphereRoom(n).flat.spheres.size(), n);
  EXPECT_EQ(blobOnFloor(3).flat.triangles.size(), 8u * 9u + 4u);
  EXPECT_EQ(cornellBox().flat.triangles.size(), 32u);
}

double component(const Float3& a, const glm::dvec3& b) {
  return a[0] * b.x + a[1] * b.y + a[2] * b.z;
}

// The room's walls show inwards, and its boxes outwards.
TEST(BenchScenes, RoomsHaveFrontsWhereTheRaysAre) {
  const FlatScene scene = boxRoom(24).flat;
  glm::dvec3 box(0.0);
  for (std::size_t i = 12; i < 24; ++i)
    for (const Float3& corner : viewOf(scene).corners(scene.triangles[i]))
      box += glm::dvec3(corner[0], corner[1], corner[2]) / 36.0;
  for (std::size_t i = 0; i < 24; ++i) {
    const Float3 corner = viewOf(scene).corners(scene.triangles[i])[0];
    const glm::dvec3 from(corner[0], corner[1], corner[2]);
    if (i < 12) {
      EXPECT_LT(component(scene.triangles[i].normal, from), 0.0) << i;
    } else {
      EXPECT_GT(component(scene.triangles[i].normal, from - box), 0.0) << i;
    }
  }
}

TEST(BenchProcesses, CpuSecondsAreThoseOfTheWholeFamily) {
  TemporaryFolder folder;
  // A shell that waits for another, which counts.
  const ChildUsage usage = runMeasured(
      {"/bin/sh", "-c", "/bin/sh -c 'i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done'; exit 3"},
      folder / "log");
  EXPECT_EQ(usage.exitCode, 3);
  EXPECT_GT(usage.cpuSeconds, 0.02);
}

TEST(BenchProcesses, PeakMemoryIsTheProgramsOwnAndNotOfWhoStartedIt) {
  TemporaryFolder folder;
  const std::vector<char> held(std::size_t{256} << 20, 1);
  const PeakMemory peak = measureMemory({"/bin/sleep", "0.2"}, folder / "log");
  EXPECT_EQ(peak.exitCode, 0);
  EXPECT_GT(peak.program, std::uint64_t{100} << 10);
  EXPECT_LT(peak.program, std::uint64_t{64} << 20) << held.front();
  EXPECT_EQ(peak.children, 0u);
}

TEST(BenchProcesses, PeakMemoryFindsChildren) {
  TemporaryFolder folder;
  const PeakMemory peak = measureMemory({"/bin/sh", "-c", "/bin/sleep 0.2; true"}, folder / "log");
  EXPECT_GT(peak.children, std::uint64_t{100} << 10);
}

BenchScene benchScene(const std::string& name) {
  return {"s", name, loadScene(shippedSceneFile(name)), {}};
}

TEST(CyclesScene, HasTheGeometryTheLightAndTheCamera) {
  TemporaryFolder folder;
  const auto file =
      writeCyclesScene(benchScene("cornell_box"), {16, 3, folder / "out.exr"}, folder.path());
  std::ifstream in(file);
  const json scene = json::parse(in);
  EXPECT_EQ(scene.at("raysPerPixel"), 16);
  EXPECT_EQ(scene.at("maxBounces"), 8);
  std::size_t triangles = 0, emitters = 0;
  for (const json& mesh : scene.at("meshes")) {
    triangles += std::filesystem::file_size(mesh.at("indices").get<std::string>()) / 12;
    const json& material = scene.at("materials").at(mesh.at("material").get<std::size_t>());
    if (material.at("emission") != json{0.0, 0.0, 0.0}) {
      ++emitters;
      EXPECT_EQ(material.at("emission"), (json{17.0, 12.0, 4.0}));
      EXPECT_EQ(material.at("kd"), (json{0.0, 0.0, 0.0}));
    }
  }
  EXPECT_EQ(triangles, 32u);
  EXPECT_EQ(emitters, 1u);
  const json& camera = scene.at("camera");
  const auto vector = [&](const char* key) {
    const auto v = camera.at(key).get<std::vector<double>>();
    return glm::dvec3(v.at(0), v.at(1), v.at(2));
  };
  EXPECT_NEAR(glm::dot(glm::cross(vector("right"), vector("up")), vector("back")), 1.0, 1e-6);
  EXPECT_NEAR(camera.at("fieldOfView").get<double>(), 39.3 * std::acos(-1.0) / 180.0, 1e-6);
}

TEST(CyclesScene, RefusesPathsWithoutAScatteringEventWhichCyclesDoesNotHave) {
  TemporaryFolder folder;
  BenchScene scene = benchScene("cornell_box");
  scene.scene.flat.maxBounces = 0;
  EXPECT_THROW(writeCyclesScene(scene, {16, 3, folder / "out.exr"}, folder.path()), UsageError);
  scene.scene.flat.maxBounces = 1;
  EXPECT_NO_THROW(writeCyclesScene(scene, {16, 3, folder / "out.exr"}, folder.path()));
}

TEST(CyclesScene, RefusesMaterialsThatCyclesDoesNotHave) {
  TemporaryFolder folder;
  EXPECT_THROW(
      writeCyclesScene(benchScene("cornell_phong"), {16, 3, folder / "out.exr"}, folder.path()),
      UsageError);
}

}  // namespace
}  // namespace pathmark::bench
