// pathmark bench stress and bench skip with the solutions: all that must hold holds.
#include "support/bench_json.h"

namespace pathmark::test {
namespace {

using nlohmann::json;

TEST_F(BenchCommand, StressFindsThatAllThatMustHoldHolds) {
  const json report = benchJson({"stress", "--quick", "--handout", "stress.md"});
  ASSERT_TRUE(report.is_object()) << output_;
  for (const auto& [key, figure] : report.at("figures").items())
    EXPECT_NE(figure.value("verdict", ""), "not met") << key << ": " << figure;
  for (const char* part : {"similarity", "sphereLights", "polygonLights", "directLight", "albedos",
                           "furnaces", "input", "longRuns", "threads", "degenerate"})
    EXPECT_FALSE(report.at("tables").at(part).empty()) << part;
  EXPECT_EQ(report.at("tables").at("input").size(), 23u) << "the functions, and pictures";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "stress.md"));
}

TEST_F(BenchCommand, StressOnlyMakesThePartsThatAreWanted) {
  const json report = benchJson({"stress", "--quick", "--only", "materials"});
  ASSERT_TRUE(report.is_object());
  EXPECT_TRUE(report.at("tables").contains("albedos"));
  EXPECT_FALSE(report.at("tables").contains("similarity"));
}

TEST_F(BenchCommand, StressNamesThePartsThatThereAre) {
  expectRefuses({"stress", "--only", "everything"}, "it is one of similarity, lights");
}

TEST_F(BenchCommand, SkipFindsTheSamePicturesWithAndWithoutEachSkip) {
  const json report =
      benchJson({"skip", "cornell_box", "veach_plates", "--quick", "--rounds", "3"});
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report.at("figures").at("different").at("value"), 0.0);
  const json& rows = report.at("tables").at("skips");
  EXPECT_GE(rows.size(), 8u);
  for (const json& row : rows) EXPECT_GT(row.at("ratio").get<double>(), 0.2) << row;
  EXPECT_FALSE(report.at("tables").at("candidates").empty());
}

}  // namespace
}  // namespace pathmark::test
