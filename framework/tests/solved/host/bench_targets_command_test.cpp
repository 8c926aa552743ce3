// pathmark bench targets: one command measures all that is asked of the program's speed.
#include "support/background_program.h"
#include "support/bench_json.h"

#include <cerrno>
#include <csignal>
#include <fstream>
#include <string>

#include <unistd.h>

namespace pathmark::test {
namespace {

using nlohmann::json;

// One that the process has started from its first thread; 0 if there is none.
pid_t childOf(pid_t process) {
  const std::string name = std::to_string(process);
  std::ifstream in("/proc/" + name + "/task/" + name + "/children");
  pid_t child = 0;
  in >> child;
  return child;
}

TEST_F(BenchCommand, TargetsMeasuresAllThatIsAskedAndWritesTheChapter) {
  const json report = benchJson(
      {"targets", "--quick", "--with", PATHMARK_ROOT "/solutions", "--handout", "performance.md"});
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
  for (const char* words :
       {"bench targets --quick --with " PATHMARK_ROOT "/solutions --handout performance.md",
        "flat loop / raw Embree", "marking one submission", "tracePathMIS"})
    EXPECT_NE(chapter.find(words), std::string::npos) << words << "\n" << chapter;
}

// Not only by Ctrl-C, which a terminal tells to all: what a benchmark has started ends with it.
TEST_F(BenchCommand, EndsWithTheProgramsThatItRunsIfOnlyItIsToldTo) {
  BackgroundProgram bench(
      {PATHMARK_PROGRAM, "bench", "lights", "cornell_box", "--rays-per-pixel", "1000000"},
      folder_.path(), folder_ / "log");
  pid_t render = 0;
  ASSERT_TRUE(waitFor([&] {
    render = childOf(childOf(getpid()));
    const std::string words = textOf("/proc/" + std::to_string(render) + "/cmdline");
    return words.starts_with(std::string("/proc/self/exe\0render", 21)) &&
           childOf(render) > 0;  // its worker
  })) << textOf(folder_ / "log");
  bench.signal(SIGTERM);
  ASSERT_TRUE(waitFor([&] { return bench.ended(); })) << textOf(folder_ / "log");
  EXPECT_EQ(bench.wait(), 130) << textOf(folder_ / "log");
  EXPECT_TRUE(kill(render, 0) < 0 && errno == ESRCH);
}

TEST_F(BenchCommand, TargetsRefusesPeersThatItDoesNotKnow) {
  expectRefuses({"targets", "--peer", "povray"}, "cycles is the only one");
}

}  // namespace
}  // namespace pathmark::test
