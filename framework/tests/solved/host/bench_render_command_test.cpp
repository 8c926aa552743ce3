// pathmark bench render with the solutions, run as a program: what it says, not how fast it is.
#include "support/bench_json.h"

namespace pathmark::test {
namespace {

using nlohmann::json;

TEST_F(BenchCommand, RenderHasEveryFigureOfItsScene) {
  const json report = benchJson({"render", "cornell_box", "--quick"});
  ASSERT_TRUE(report.is_object());
  const json& rows = report.at("tables").at("efficiency");
  ASSERT_EQ(rows.size(), 2u);
  for (const json& row : rows) {
    EXPECT_EQ(row.at("scene"), "s1 cornell_box");
    EXPECT_EQ(row.at("renderer"), "pathmark");
    EXPECT_GT(row.at("relMse").get<double>(), 0.0);
    EXPECT_GT(row.at("cpuSeconds").get<double>(), 0.0);
  }
  // Four times the rays: a quarter of the squared error or less. The seeds are always the same, so
  // that this is never a matter of luck.
  EXPECT_GT(rows.at(0).at("relMse").get<double>(), 3.0 * rows.at(1).at("relMse").get<double>());
  const json& figures = report.at("figures");
  for (const char* key : {"s1MeanOff4", "s1MeanOff16", "s1Paths", "s1Rays", "s1RaysOverFlat",
                          "twoThreads", "s1Start", "s1Memory", "memoryGrowth"})
    EXPECT_TRUE(figures.contains(key)) << key;
  EXPECT_EQ(figures.at("sameBits").at("value"), 1.0);
  EXPECT_EQ(figures.at("sameBits").at("verdict"), "met");
  EXPECT_LT(figures.at("s1MeanOff16").at("value").get<double>(), 2.0) << "percent";
  EXPECT_FALSE(figures.contains("s3Start")) << "of a scene that was not asked for";
}

}  // namespace
}  // namespace pathmark::test
