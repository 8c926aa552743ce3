// The runs of bench error: kept, read back, summed up.
#include "bench/error_runs.h"
#include "bench/error_peers.h"
#include "bench/error_summary.h"
#include "bench/log_chart.h"
#include "host/session.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace pathmark::bench {
namespace {

ErrorRun run(const std::string& estimator, std::uint64_t rays, std::uint64_t replicate,
             double error) {
  return {{"scene", estimator, "sobol", rays},
          replicate,
          1e-3 * static_cast<double>(rays),
          {2.0 * error, error, 0.001, 0.25},
          "made"};
}

TEST(ErrorRuns, CsvReadsBackToTheSameBits) {
  const test::TemporaryFolder folder;
  const std::vector<ErrorRun> runs{run("a b", 4, 0, 0.1), run("c", 16, 3, 1.0 / 3.0)};
  std::ofstream(folder / "runs.csv") << csvOf(runs);
  const std::vector<ErrorRun> read = readCsv(folder / "runs.csv");
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read[k].point, runs[k].point);
    EXPECT_EQ(read[k].replicate, runs[k].replicate);
    EXPECT_EQ(read[k].cpuSeconds, runs[k].cpuSeconds);
    EXPECT_EQ(read[k].deviation.mse, runs[k].deviation.mse);
    EXPECT_EQ(read[k].deviation.relativeMse, runs[k].deviation.relativeMse);
    EXPECT_EQ(read[k].deviation.worstShare, runs[k].deviation.worstShare);
    EXPECT_EQ(read[k].deviation.mean, runs[k].deviation.mean);
    EXPECT_EQ(read[k].made, runs[k].made);
  }
}

TEST(ErrorRuns, AFileThatIsNoneOfOursIsRefusedWithItsLine) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "other.csv") << "name,mark\n";
  EXPECT_THROW(readCsv(folder / "other.csv"), UsageError);
  std::ofstream(folder / "cut.csv") << csvOf({run("a", 4, 0, 0.1)}) << "scene,a,sobol,4,1,0.0\n";
  try {
    readCsv(folder / "cut.csv");
    ADD_FAILURE() << "it was accepted";
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("cut.csv:3"), std::string::npos) << e.what();
  }
}

TEST(ErrorRuns, ARunOfAnotherProgramIsNoneToGoOnFrom) {
  ErrorRuns runs;
  runs.add(run("a", 4, 0, 0.1));
  EXPECT_NE(runs.find({"scene", "a", "sobol", 4}, 0, "made"), nullptr);
  EXPECT_EQ(runs.find({"scene", "a", "sobol", 4}, 0, "other"), nullptr);
  EXPECT_EQ(runs.find({"scene", "a", "sobol", 4}, 1, "made"), nullptr);
  runs.add(run("b", 4, 0, 0.1));
  runs.keepOnly("scene", "a", "newer");
  ASSERT_EQ(runs.all().size(), 1u);
  EXPECT_EQ(runs.all().front().point.estimator, "b");
}

TEST(ErrorRuns, OfOneMeasureAreThoseOfItsSceneAndReferenceAlone) {
  ErrorRuns runs;
  for (const auto& [estimator, made] : {std::pair{"a", madeBy("large", "program 1")},
                                        {"b", madeBy("large", "program 2")},
                                        {"c", madeBy("small", "program 1")},
                                        {"d", std::string("older")}}) {
    ErrorRun one = run(estimator, 4, 0, 0.1);
    one.made = made;
    runs.add(std::move(one));
  }
  const std::vector<ErrorRun> large = runs.of("large"), small = runs.of("small");
  ASSERT_EQ(large.size(), 2u);
  EXPECT_EQ(large[1].point.estimator, "b");
  ASSERT_EQ(small.size(), 1u);
  EXPECT_EQ(small[0].point.estimator, "c");
}

// Errors that fall as 1 / rays, with times in proportion to rays.
TEST(ErrorSummary, OfRunsThatFallAsTheyShould) {
  std::vector<ErrorRun> runs;
  for (std::uint64_t k = 0; k < 4; ++k)
    for (const std::uint64_t rays : {64u, 4u, 16u})
      runs.push_back(
          run("a", rays, k, (1.0 + 0.01 * static_cast<double>(k)) / static_cast<double>(rays)));
  const SceneSummary summary = summarise("scene", {}, runs);
  ASSERT_EQ(summary.curves.size(), 1u);
  const CurveSummary& curve = summary.curves.front();
  ASSERT_EQ(curve.points.size(), 3u);
  EXPECT_EQ(curve.points[0].raysPerPixel, 4u) << "in the order of their rays";
  EXPECT_EQ(curve.points[2].replicates, 4u);
  EXPECT_NEAR(curve.slope.value, -1.0, 1e-9);
  for (const PointSummary& p : curve.points) {
    EXPECT_NEAR(p.efficiency.value, 1.0 / (1.015 * 1e-3), 1e-6);
    EXPECT_LT(p.efficiency.low, p.efficiency.value);
    EXPECT_NEAR(p.mse.value, 2.0 * p.relativeMse.value, 1e-12);
  }
  EXPECT_TRUE(summarise("another scene", {}, runs).curves.empty());
}

TEST(ErrorSummary, AnErrorBelowTheReferencesOwnIsNoPointOfASlope) {
  std::vector<ErrorRun> runs;
  for (std::uint64_t k = 0; k < 3; ++k) {
    runs.push_back(run("a", 4, k, 1.0 / 4.0));
    runs.push_back(run("a", 16, k, 1.0 / 16.0));
    runs.push_back(run("a", 64, k, -1e-5));
  }
  const CurveSummary curve = summarise("scene", {}, runs).curves.front();
  EXPECT_FALSE(curve.points[2].isMeasured());
  EXPECT_NEAR(curve.slope.value, -1.0, 1e-9);
}

class ErrorPeers : public testing::Test {
 protected:
  ErrorPeers() { std::ofstream(folder_ / "box.exr") << "any"; }
  std::string refusal(const std::vector<std::string>& words) {
    try {
      readPeers(words);
    } catch (const UsageError& e) {
      return e.what();
    }
    return "accepted";
  }
  std::string image() const { return (folder_ / "box.exr").string(); }
  test::TemporaryFolder folder_;
};

TEST_F(ErrorPeers, AreReadFromWordsAndLists) {
  std::ofstream(folder_ / "list.json")
      << R"([{"name": "M", "scene": "s", "image": "box.exr", "seconds": 1.5, "raysPerPixel": 16}])";
  const std::vector<PeerImage> peers = readPeers(
      {"P=" + image() + ",2.5", "Q=" + image() + ",3,64", (folder_ / "list.json").string()});
  ASSERT_EQ(peers.size(), 3u);
  EXPECT_EQ(peers[0].name, "P");
  EXPECT_EQ(peers[0].cpuSeconds, 2.5);
  EXPECT_EQ(peers[0].raysPerPixel, 0u);
  EXPECT_EQ(peers[1].raysPerPixel, 64u);
  EXPECT_EQ(peers[2].scene, "s");
  EXPECT_EQ(peers[2].image, folder_ / "box.exr");
}

TEST_F(ErrorPeers, ThatCannotBeMeantAreRefused) {
  for (const auto& [words, part] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"P"}, "NAME=IMAGE,SECONDS"},
           {{"P=" + image()}, "NAME=IMAGE,SECONDS"},
           {{"P=" + image() + ",fast"}, "NAME=IMAGE,SECONDS"},
           {{"P=" + image() + ",0"}, "a number above 0"},
           {{"P=nowhere.exr,1"}, "there is no file nowhere.exr"},
           {{"=" + image() + ",1"}, "has a name"},
           {{"P=" + image() + ",1", "P=" + image() + ",2"}, "each must say its rays"},
           {{"no_list.json"}, "cannot be read"}})
    EXPECT_NE(refusal(words).find(part), std::string::npos) << refusal(words);
  std::ofstream(folder_ / "bad.json") << R"([{"name": "M", "image": 3}])";
  EXPECT_NE(refusal({(folder_ / "bad.json").string()}).find("\"image\" must be a text"),
            std::string::npos);
}

}  // namespace
}  // namespace pathmark::bench
