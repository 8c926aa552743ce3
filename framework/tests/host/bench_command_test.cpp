// pathmark bench, run as a program: what it says, not how fast it is.
#include "support/bench_json.h"

namespace pathmark::test {
namespace {

using nlohmann::json;

TEST_F(BenchCommand, RaysMeasuresEveryKindForEveryNumberOfPrimitives) {
  const json report = benchJson({"rays", "--seconds", "0.0001", "--most-triangles", "64"});
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report.value("command", ""), "bench rays");
  for (const char* kind : {"closest", "occluded", "chained", "path"}) {
    const json& rows = report.at("tables").at(kind);
    ASSERT_EQ(rows.size(), 8u) << "1, 2 ... 64, and the Cornell box";
    EXPECT_EQ(rows.at(0).at("triangles"), 1.0);
    EXPECT_EQ(rows.at(6).at("triangles"), "32: the Cornell box");
    EXPECT_EQ(rows.at(7).at("triangles"), 64.0);
    for (const json& row : rows) {
      EXPECT_GT(row.at("flat").get<double>(), 0.0);
      EXPECT_GT(row.at("embree").get<double>(), 0.0);
      EXPECT_GT(row.at("rawEmbree").get<double>(), 0.0);
      EXPECT_DOUBLE_EQ(row.at("flatOverEmbree").get<double>(),
                       row.at("flat").get<double>() / row.at("embree").get<double>());
    }
  }
  const json& fans = report.at("tables").at("fans");
  ASSERT_EQ(fans.size(), 8u);
  for (const json& row : fans) {
    EXPECT_GT(row.at("apart").get<double>(), 0.0);
    EXPECT_DOUBLE_EQ(row.at("ratio").get<double>(),
                     row.at("together").get<double>() / row.at("apart").get<double>());
  }
  EXPECT_EQ(report.at("tables").at("spheres").size(), 9u);
  EXPECT_EQ(report.at("tables").at("meshes").size(), 3u);
  EXPECT_TRUE(report.at("figures").contains("crossover"));
  EXPECT_TRUE(report.at("figures").at("flatOverRawEmbreeAt32").contains("verdict"));
}

// The flat loop and Embree may part at edges only.
TEST_F(BenchCommand, RaysComparesIntersectorsThatFindTheSame) {
  const json report = benchJson({"rays", "--seconds", "0.0001", "--most-triangles", "32"});
  ASSERT_TRUE(report.is_object());
  for (const json& row : report.at("tables").at("closest"))
    EXPECT_LT(row.at("disagreement").get<double>(), 500.0) << row;
}

TEST_F(BenchCommand, SaysOnWhatItWasMeasured) {
  const json report = benchJson({"rays", "--seconds", "0.0001", "--most-triangles", "32"});
  ASSERT_TRUE(report.is_object());
  const std::string machine = report.at("machine");
  EXPECT_NE(machine.find("processors"), std::string::npos) << machine;
  EXPECT_NE(output_.find(machine), std::string::npos) << output_;
}

// Densities that are no numbers, where the rest is as it is in every TestCoursework.
TEST_F(BenchCommand, StressTakesWhatIsNoNumberForTheWorstError) {
  TestCoursework coursework;
  coursework.setFile("part2_lights.cpp", R"(
LightSample Polygon::TriangularSampling(float, float) const { return {p(0), normal(), NAN}; }
LightSample Polygon::RectangularSampling(float, float) const { return {p(0), normal(), NAN}; }
LightSample Polygon::PolygonSampling(float, float) const { return {p(0), normal(), NAN}; }
LightSample Sphere::sample(const Point&, float, float) const {
  return {centre() + Vector(radius(), 0, 0), Vector(1, 0, 0), 1.0f};
}
float Sphere::pdf(const Point&, const Point&, const Vector&) const { return NAN; }
Colour LitScene::directLighting(const Hit&, const Vector&, Sampler&) const { return Colour(0); })");
  const ProcessResult result = bench({"stress", "--quick", "--only", "lights", "--with",
                                      coursework.folder().string(), "--json", "stress.json"});
  EXPECT_EQ(result.exitCode, 1) << result.output;
  std::ifstream file(folder_ / "stress.json");
  const json report = json::parse(file, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.output;
  for (const char* key : {"polygonDensity", "polygonIrradiance", "spherePdf"})
    EXPECT_EQ(report.at("figures").at(key).value("verdict", ""), "not met") << key;
}

TEST_F(BenchCommand, WrongCommandLinesAreSentencesAndWriteNothing) {
  expectRefuses({}, "cost, lights, preview, skip, stress or targets");
  expectRefuses({"paint"}, "paint was not expected");
  expectRefuses({"rays", "--fast"}, "--fast was not expected; ./pathmark bench rays --help");
  expectRefuses({"rays", "--seconds", "0"}, "a number of seconds from");
  expectRefuses({"rays", "--most-triangles", "16"}, "a whole number from 32");
  expectRefuses({"rays", "--json", "no/such/folder.json"}, "there is no folder no/such");
  expectRefuses({"render", "furnace"}, "its scenes are cornell_box, cornell_spheres and blob");
  expectRefuses({"render", "--peer", "mitsuba"}, "cycles is the only one");
  expectRefuses({"render", "--seeds", "1"}, "a whole number from 2");
  expectRefuses({"render", "--with", "no_such_folder"}, "there is no folder");
  expectRefuses({"lights", "cornel_box"}, "There is no scene cornel_box");
  expectRefuses({"lights", "my_scene"}, "my_scene is no scene in scenes/");
  expectRefuses({"error", "cornel_box"}, "There is no scene cornel_box");
  expectRefuses({"error", "--estimators", "unifrom"}, "or NAME=FOLDER");
  expectRefuses({"error", "--samplers", "halton"}, "--samplers halton: it is one of");
  expectRefuses({"error", "--rays", "4,,8"}, "with commas, such as 4,16,64");
  expectRefuses({"error", "--rays", "0"}, "from 1 to");
  expectRefuses({"error", "--replicates", "0"}, "a whole number from 1");
  expectRefuses({"error", "--peer", "M=none.exr,1"}, "there is no file none.exr");
  expectRefuses({"error", "furnace", "cornell_box", "--reference", "a.exr"}, "of one scene");
  expectRefuses({"error", "--html", "no/such/page.html"}, "there is no folder no/such");
}

TEST_F(BenchCommand, SaysWhenThePeerIsNotInstalled) {
  const ProcessResult result =
      runProcess({.arguments = {"/usr/bin/env", "PATH=/nonexistent", PATHMARK_PROGRAM, "bench",
                                "render", "cornell_box", "--peer", "cycles"},
                  .input = {},
                  .folder = folder_.path()});
  EXPECT_EQ(result.exitCode, 2) << result.output;
  EXPECT_NE(result.output.find("there is no program blender"), std::string::npos) << result.output;
}

TEST_F(BenchCommand, HelpCarriesExamples) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--help"}, {"rays", "--help"}, {"render", "--help"}, {"error", "--help"}}) {
    const ProcessResult result = bench(words);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.output.find("Examples:"), std::string::npos) << result.output;
  }
}

}  // namespace
}  // namespace pathmark::test
