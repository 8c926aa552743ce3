// pathmark bench targets: one command measures all that is asked of the program's speed.
#include "support/bench_json.h"

namespace pathmark::test {
namespace {

using nlohmann::json;

TEST_F(BenchCommand, TargetsMeasuresAllThatIsAskedAndWritesTheChapter) {
  const json report = benchJson({"targets", "--quick", "--handout", "performance.md"});
  ASSERT_TRUE(report.is_object()) << output_;
  const json& figures = report.at("figures");
  for (const char* key : {"flatOverRawEmbreeAt32", "s1RaysOverFlat", "s1MeanOff16", "twoThreads",
                          "sameBits", "s1Start", "s1Memory", "save_to_pixels_cornell_box",
                          "checkFirstAnswer", "checkAll", "gradeOne"}) {
    ASSERT_TRUE(figures.contains(key)) << key << "\n" << output_;
    EXPECT_GT(figures.at(key).at("value").get<double>(), 0.0) << key;
    EXPECT_FALSE(figures.at(key).value("verdict", "").empty()) << key;
  }
  EXPECT_EQ(figures.at("sameBits").at("value"), 1.0);
  EXPECT_LT(figures.at("checkFirstAnswer").at("value").get<double>(),
            figures.at("checkAll").at("value").get<double>());

  std::ifstream in(folder_ / "performance.md");
  const std::string chapter(std::istreambuf_iterator<char>(in), {});
  for (const char* words : {"bench targets --quick", "flat loop / raw Embree",
                            "marking one submission", "tracePathMIS"})
    EXPECT_NE(chapter.find(words), std::string::npos) << words << "\n" << chapter;
}

TEST_F(BenchCommand, TargetsRefusesPeersThatItDoesNotKnow) {
  expectRefuses({"targets", "--peer", "povray"}, "cycles is the only one");
}

}  // namespace
}  // namespace pathmark::test
