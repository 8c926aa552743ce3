// pathmark grade as an instructor uses it: the real program on a small class.
#include "support/grade_command.h"
#include "support/background_program.h"
#include "worker/contract.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace pathmark::test {
namespace {

TEST_F(GradeCommand, MarksAClassAndWritesItsReports) {
  add("right");
  add("wrong", kWeight, "return {true, 1.0f};");
  add("broken", kWeight, "return {true, 1.0f / };");
  const ProcessResult result = grade({"--seed", "3"});
  EXPECT_EQ(result.exitCode, 0) << result.output;
  EXPECT_EQ(record("right")["parts"][0]["verdict"], "ok");
  EXPECT_EQ(record("wrong")["parts"][0]["verdict"], "wrong");
  EXPECT_EQ(record("broken")["parts"][0]["verdict"], "does not compile");
  for (const char* name : {"right", "wrong", "broken"}) {
    EXPECT_NE(result.output.find(name), std::string::npos) << result.output;
    for (const char* file : {"report.html", "results.json", "junit.xml"})
      EXPECT_GT(fs::file_size(out() / "submissions" / name / file), 100u) << file;
  }
  for (const char* file : {"report.html", "marks.csv", "junit.xml"})
    EXPECT_GT(fs::file_size(out() / file), 100u) << file;
  EXPECT_FALSE(fs::exists(out() / ".work"));
}

TEST_F(GradeCommand, StubsWithoutTheirMarkersEarnNothing) {
  const fs::path stubs = classFolder() / "nothing";
  fs::create_directories(stubs);
  for (const PartContract& part : parts()) {
    std::ifstream in(kRoot / "student" / part.file);
    std::ofstream out(stubs / part.file);
    for (std::string line; std::getline(in, line);)
      if (line.find("PATHMARK_UNIMPLEMENTED(") == std::string::npos) out << line << '\n';
  }
  const ProcessResult result =
      run({PATHMARK_PROGRAM, "grade", quoted(classFolder()), "--out", quoted(out())}, kRoot);
  EXPECT_EQ(result.exitCode, 0) << result.output;
  const std::string row = rowOf(textOf(out() / "marks.csv"), "nothing");
  EXPECT_TRUE(row.starts_with("nothing,0,100,")) << row;
  for (const Json& part : record("nothing")["parts"]) {
    if (partNumbered(part["part"]).bonus) continue;
    for (const Json& f : part["functions"]) EXPECT_NE(f["mistake"], "") << f["name"];
  }
}

TEST_F(GradeCommand, GradesNothingTwice) {
  add("right");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string before = textOf(recordOf("right"));
  EXPECT_EQ(grade().exitCode, 0);
  // A new record would have other times in it.
  EXPECT_EQ(textOf(recordOf("right")), before);
  add("late");
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_EQ(textOf(recordOf("right")), before);
  EXPECT_TRUE(fs::exists(recordOf("late")));
  std::ofstream(classFolder() / "right" / "part6_roulette.cpp", std::ios::app) << "// new\n";
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_NE(textOf(recordOf("right")), before);
}

TEST_F(GradeCommand, GradesAnewWhatRanOutOfTime) {
  add("slow", kWeight, "for (volatile int i = 0;; i = i + 1) {}");
  const ProcessResult limited = grade({"--time-limit", "1"});
  EXPECT_EQ(limited.exitCode, 0) << limited.output;
  EXPECT_NE(limited.output.find("out of time: the same command grades it anew"), std::string::npos)
      << limited.output;
  EXPECT_TRUE(record("slow")["outOfTime"].get<bool>());
  EXPECT_TRUE(record("slow")["parts"][0]["functions"].empty());
  ASSERT_EQ(grade().exitCode, 0);
  EXPECT_FALSE(record("slow")["outOfTime"].get<bool>());
  EXPECT_EQ(record("slow")["parts"][0]["functions"][0]["verdict"], "time limit");
}

TEST_F(GradeCommand, GoesOnAfterItWasKilled) {
  for (const char* name : {"a", "b", "c", "d"}) add(name);
  {
    BackgroundProgram program(command({"--jobs", "1"}), kRoot, folder_ / "log");
    ASSERT_TRUE(waitFor([&] { return fs::exists(recordOf("a")); }));
    program.signal(SIGKILL);
    program.wait();
  }
  const std::string before = textOf(recordOf("a"));
  ASSERT_FALSE(fs::exists(recordOf("d")));
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_EQ(textOf(recordOf("a")), before);
  EXPECT_EQ(record("d")["parts"][0]["verdict"], "ok");
  EXPECT_FALSE(fs::exists(out() / ".work"));
}

TEST_F(GradeCommand, CtrlCKeepsWhatIsDone) {
  for (const char* name : {"a", "b", "c", "d"}) add(name);
  BackgroundProgram program(command({"--jobs", "1"}), kRoot, folder_ / "log");
  ASSERT_TRUE(waitFor([&] { return fs::exists(recordOf("a")); }));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 130);
  EXPECT_NE(textOf(folder_ / "log").find("goes on from here"), std::string::npos);
  EXPECT_FALSE(fs::exists(recordOf("d")));
  const std::string row = rowOf(textOf(out() / "marks.csv"), "d");
  EXPECT_TRUE(row.starts_with("d,,")) << row;
  EXPECT_NE(row.find("The run was interrupted before it"), std::string::npos) << row;
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_FALSE(rowOf(textOf(out() / "marks.csv"), "d").starts_with("d,,"));
}

TEST_F(GradeCommand, CtrlCDoesNotWaitForACompiler) {
  add("slow");
  // A hundred constants, each of which takes the compiler about a second.
  std::ofstream(classFolder() / "slow" / "part6_roulette.cpp", std::ios::app) << R"(
#include <utility>
template <int K>
constexpr int sum() {
  int s = 0;
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 10000; ++j) s += (i ^ j) % K;
  return s;
}
template <int K>
constexpr int kSum = sum<K + 1>();
template <int... K>
int sums(std::integer_sequence<int, K...>) {
  return (kSum<K> + ...);
}
int allSums() { return sums(std::make_integer_sequence<int, 100>()); }
)";
  BackgroundProgram program(command({"--jobs", "1"}), kRoot, folder_ / "log");
  ASSERT_TRUE(waitFor([&] { return fs::exists(out() / ".work"); }));
  std::this_thread::sleep_for(std::chrono::seconds(3));
  const auto signalled = std::chrono::steady_clock::now();
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 130);
  EXPECT_LT(std::chrono::steady_clock::now() - signalled, std::chrono::seconds(30));
  EXPECT_NE(textOf(folder_ / "log").find("goes on from here"), std::string::npos);
  EXPECT_FALSE(fs::exists(recordOf("slow")));
}

TEST_F(GradeCommand, CtrlCAfterTheLastOneInterruptsNothing) {
  add("a");
  BackgroundProgram program(command({"--jobs", "1"}), kRoot, folder_ / "log");
  ASSERT_TRUE(waitFor([&] { return fs::exists(recordOf("a")); }));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 0);
  EXPECT_EQ(textOf(folder_ / "log").find("goes on from here"), std::string::npos);
  EXPECT_FALSE(rowOf(textOf(out() / "marks.csv"), "a").starts_with("a,,"));
}

TEST_F(GradeCommand, SaysInItsExitCodeThatTheMachineFailedWhereverTheRecordIsFrom) {
  add("right");
  ASSERT_EQ(grade().exitCode, 0);
  Json failed = record("right");
  failed["failure"] = "The grader, or the machine, failed twice: no memory";
  std::ofstream(recordOf("right")) << failed.dump();
  const std::vector<std::string> anew{PATHMARK_PROGRAM, "grade",  "--out",
                                      quoted(out()),    "--only", "part6"};
  EXPECT_EQ(run(anew, kRoot).exitCode, 3);
  EXPECT_TRUE(rowOf(textOf(out() / "marks.csv"), "right").starts_with("right,,"));
  EXPECT_EQ(grade().exitCode, 0) << "it is graded again";
}

TEST_F(GradeCommand, JobsChangeNoMark) {
  add("right");
  add("wrong", kWeight, "return {true, 0.9f / q};");
  add("slow", kWeight, "return {true, 1.0f / q}; for (;;);");
  ASSERT_EQ(grade({"--seed", "9", "--jobs", "1"}).exitCode, 0);
  const std::string one = textOf(out() / "marks.csv");
  fs::remove_all(out());
  ASSERT_EQ(grade({"--seed", "9", "--jobs", "3"}).exitCode, 0);
  EXPECT_EQ(textOf(out() / "marks.csv"), one);
}

TEST_F(GradeCommand, ANewRubricMarksRecordsAnewWithoutRunningThem) {
  add("right");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string before = textOf(recordOf("right")), csv = textOf(out() / "marks.csv");
  Json rubric = Json::parse(textOf(kRoot / "grader/rubric/rubric.json"), nullptr, true, true);
  rubric["parts"]["6"]["points"] = 55;
  std::ofstream(folder_ / "rubric.json") << rubric.dump(1);
  // The submissions themselves are not needed for it.
  fs::remove_all(classFolder());
  const ProcessResult result = run({PATHMARK_PROGRAM, "grade", "--out", quoted(out()), "--rubric",
                                    quoted(folder_ / "rubric.json")},
                                   kRoot);
  EXPECT_EQ(result.exitCode, 0) << result.output;
  EXPECT_EQ(textOf(recordOf("right")), before);
  const std::string row = rowOf(textOf(out() / "marks.csv"), "right");
  EXPECT_TRUE(row.starts_with("right,55,55,")) << row;
  EXPECT_FALSE(rowOf(csv, "right").starts_with("right,55,")) << csv;
}

TEST_F(GradeCommand, LaterRunsMarkByTheRubricOfTheFolder) {
  add("right");
  const fs::path rubric = folder_ / "mine.json";
  std::ofstream(rubric) << R"({"parts": {"6": {"points": 55}}})";
  ASSERT_EQ(grade({"--rubric", quoted(rubric)}).exitCode, 0);
  fs::remove(rubric);
  add("late");
  const ProcessResult later = grade();
  EXPECT_EQ(later.exitCode, 0) << later.output;
  EXPECT_NE(later.output.find("--rubric default takes the project's own again"), std::string::npos)
      << later.output;
  for (const std::string name : {"right", "late"})
    EXPECT_TRUE(rowOf(textOf(out() / "marks.csv"), name).starts_with(name + ",55,55,")) << name;

  std::ofstream(out() / "rubric.json") << "{";
  const ProcessResult damaged = grade();
  EXPECT_EQ(damaged.exitCode, 2) << damaged.output;
  EXPECT_NE(damaged.output.find("grades/rubric.json"), std::string::npos) << damaged.output;

  ASSERT_EQ(grade({"--rubric", "default"}).exitCode, 0);
  EXPECT_FALSE(fs::exists(out() / "rubric.json"));
  EXPECT_TRUE(rowOf(textOf(out() / "marks.csv"), "late").starts_with("late,6,6,"));
}

TEST_F(GradeCommand, GradesAgainWhatHasADamagedRecord) {
  add("right");
  ASSERT_EQ(grade().exitCode, 0);
  std::ofstream(recordOf("right")) << "{";
  const ProcessResult marks =
      run({PATHMARK_PROGRAM, "grade", "--out", quoted(out()), "--only", "part6"}, kRoot);
  EXPECT_EQ(marks.exitCode, 3);
  EXPECT_NE(marks.output.find("this record is damaged"), std::string::npos) << marks.output;
  const std::string row = rowOf(textOf(out() / "marks.csv"), "right");
  EXPECT_TRUE(row.starts_with("right,,")) << row;
  EXPECT_NE(row.find("Its record is damaged"), std::string::npos) << row;
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_EQ(record("right")["parts"][0]["verdict"], "ok");
}

}  // namespace
}  // namespace pathmark::test
