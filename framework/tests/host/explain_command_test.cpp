// pathmark render --explain, as a user would run it.
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <fstream>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

class Explain : public testing::Test {
 protected:
  ProcessResult explain(const std::string& scene, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{PATHMARK_PROGRAM, "render", scene, "--explain"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, folder_.path());
  }

  // Without the room that aligns the lines.
  static std::string lineOf(const ProcessResult& result, const std::string& what) {
    const std::size_t start = ("\n" + result.output).find("\n" + what + ":");
    if (start == std::string::npos) return "no such line";
    const std::size_t end = result.output.find('\n', start);
    const std::size_t text = result.output.find_first_not_of(' ', start + what.size() + 1);
    return result.output.substr(text, end - text);
  }

  void expectLine(const ProcessResult& result, const std::string& what, const std::string& words) {
    EXPECT_NE(lineOf(result, what).find(words), std::string::npos) << what << ": " << words << "\n"
                                                                   << result.output;
  }

  TemporaryFolder folder_;
};

TEST_F(Explain, EveryShippedSceneHasAPlanAndNoPictureIsMade) {
  int scenes = 0;
  for (const auto& file : fs::directory_iterator(fs::path(PATHMARK_ROOT) / "scenes")) {
    const fs::path name = file.path().filename();
    // The mesh of the scene blob is made, not shipped.
    if (name.extension() != ".json" || name == "scene.schema.json" || name == "blob.json") continue;
    SCOPED_TRACE(name);
    const ProcessResult result = explain(file.path().string());
    EXPECT_EQ(result.exitCode, 0) << result.output;
    for (const char* what :
         {"triangles", "spheres", "backs", "shadow rays", "materials", "lights", "which light",
          "paths", "points", "replicates", "threads", "coordinates"})
      EXPECT_NE(lineOf(result, what), "no such line") << what << "\n" << result.output;
    ++scenes;
  }
  EXPECT_GE(scenes, 10);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Explain, SplitPathsSayWhatTheyShare) {
  EXPECT_EQ(lineOf(explain("cornell_box"), "camera rays"), "no such line");
  expectLine(explain("cornell_box", {"--split", "4"}), "camera rays",
             "4 paths each (they share the first surface)");
  expectLine(explain("cornell_box", {"--split", "64", "--share-direct"}), "camera rays",
             "64 paths each (they share the first surface and its direct light)");
  expectSays(explain("cornell_box", {"--split", "65"}), 2, "--split");
  expectSays(explain("cornell_box", {"--share-direct"}), 2, "--split");
  expectSays(explain("cornell_box", {"--split", "1", "--share-direct"}), 2, "from --split 2 on");
  expectSays(explain("cornell_box", {"--split", "4", "--mis"}), 2, "--mis");
  expectSays(explain("cornell_box", {"--split", "4", "--warm-up"}), 2, "--warm-up");
}

TEST_F(Explain, PathsThatPixelsShareSayWhichPixels) {
  EXPECT_EQ(lineOf(explain("cornell_box"), "paths of pixels"), "no such line");
  const std::string why = " (the errors of their pixels are not independent)";
  expectLine(explain("cornell_box", {"--reuse", "16"}), "paths of pixels",
             "shared in blocks of 4x4" + why);
  expectLine(explain("cornell_box", {"--reuse", "2", "--direct-paths", "4"}), "paths of pixels",
             "shared in blocks of 2x1, 4 for the direct light of each camera ray" + why);
  expectSays(explain("cornell_box", {"--reuse", "3"}), 2, "2, 4, 8");
  expectSays(explain("cornell_box", {"--reuse", "128"}), 2, "64");
  expectSays(explain("cornell_box", {"--direct-paths", "2"}), 2, "--reuse");
  expectSays(explain("cornell_box", {"--reuse", "4", "--direct-paths", "65"}), 2, "64");
  expectSays(explain("cornell_box", {"--reuse", "1", "--direct-paths", "8"}), 2,
             "from --reuse 2 on");
  for (const std::string other : {"--mis", "--warm-up"})
    expectSays(explain("cornell_box", {"--reuse", "4", other}), 2, other);
  expectSays(explain("cornell_box", {"--reuse", "4", "--split", "4"}), 2, "--split");
  expectSays(explain("cornell_box", {"--reuse", "4", "--paths", "LDE"}), 2, "--paths");
}

TEST_F(Explain, TheCornellBoxIsAFlatLoopWithoutSpheresWhoseWallsCastNoShadow) {
  const ProcessResult result = explain("cornell_box");
  expectLine(result, "triangles", "32 as 16 pairs, a flat loop");
  expectLine(result, "spheres", "none: no sphere test");
  expectLine(result, "backs", "not asked for");
  expectLine(result, "shadow rays", "tested against 22 of 32 triangles (10 triangles bound");
  expectLine(result, "materials", "no Phong lobe is ever evaluated");
  expectLine(result, "lights", "1 x parallelogram by RectangularSampling");
  expectLine(result, "points", "sobol, 64 rays per pixel in 1 pass");
  expectLine(result, "threads", "256 in 256x256");
  expectLine(result, "coordinates", "the file's");
}

TEST_F(Explain, OnlySpheresCanCastShadowsInABoxOfSpheres) {
  const ProcessResult result = explain("cornell_spheres");
  expectLine(result, "shadow rays", "tested against 0 of 10 triangles and 3 of 3 spheres");
  expectLine(result, "lights", "1 x sphere by Sphere::sample");
}

TEST_F(Explain, TheFurnaceHasNoTriangleTestAndItsWallCastsNoShadow) {
  const ProcessResult result = explain("furnace");
  expectLine(result, "triangles", "none: no triangle test");
  expectLine(result, "shadow rays", "tested against 1 of 2 spheres (1 sphere bounds");
  expectLine(result, "lights", "1 x sphere, from inside, by Sphere::sample");
}

TEST_F(Explain, WhatTheCommandLineSaysIsInThePlan) {
  const ProcessResult result =
      explain("cornell_box", {"--max-bounces", "1", "--rays-per-pixel", "1024", "--replicates", "4",
                              "--threads", "3", "--sampler", "pcg", "--size", "40x20"});
  expectLine(result, "paths", "no bounce rays");
  expectLine(result, "points", "pcg, 256 rays per pixel in 4 passes of 64");
  expectLine(result, "replicates", "4");
  expectLine(result, "threads", "3, tiles of 16x16 pixels: 6 in 40x20");
  expectLine(explain("cornell_box", {"--max-bounces", "0"}), "shadow rays", "none");
  const ProcessResult warmUp = explain("cornell_spheres", {"--warm-up"});
  expectLine(warmUp, "triangles", "10, met by part 0");
  expectLine(warmUp, "spheres", "3 left out");
}

TEST_F(Explain, AnEmptySceneIsBlackBecauseEveryRayLeavesIt) {
  std::ofstream(folder_ / "empty.json")
      << R"({"camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "fieldOfView": 45}, "shapes": []})";
  const ProcessResult result = explain("empty.json");
  EXPECT_EQ(result.exitCode, 0) << result.output;
  expectLine(result, "triangles", "none");
  expectLine(result, "spheres", "none");
  expectLine(result, "shadow rays", "none");
  expectLine(result, "picture", "black (there is no shape: every ray leaves the scene)");
}

TEST_F(Explain, AFarSceneIsMovedAndASmallOneScaled) {
  std::ofstream(folder_ / "far.json")
      << R"({"camera": {"eye": [1000000, 0, 0.003], "target": [1000000, 0, 0],
             "fieldOfView": 45}, "shapes": [
             {"type": "sphere", "centre": [1000000, 0, 0], "radius": 0.001, "emission": [1, 1, 1],
              "material": "m"}],
             "materials": {"m": {"type": "lambertian", "Kd": [0, 0, 0]}}})";
  const ProcessResult result = explain("far.json");
  EXPECT_EQ(result.exitCode, 0) << result.output;
  expectLine(result, "coordinates", "(1e+06, 0, 0.001) moved to the origin, scaled by 512");
}

TEST_F(Explain, NeedsNoCourseworkThatCompiles) {
  TestCoursework coursework;
  coursework.setTracePath("return colour;");
  EXPECT_EQ(explain("cornell_box", {"--with", coursework.folder().string()}).exitCode, 0);
}

}  // namespace
}  // namespace pathmark::test
