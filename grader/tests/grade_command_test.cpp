// pathmark grade as an instructor uses it: the real program on a small class.
#include "support/background_program.h"
#include "support/coursework_copy.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"
#include "worker/contract.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kRoot = PATHMARK_ROOT;

std::string quoted(const fs::path& path) { return path.string(); }

// Of the last part only, which is the quickest to grade.
class GradeCommand : public testing::Test {
 protected:
  void add(const std::string& name, const std::string& from = {}, const std::string& to = {}) {
    CourseworkCopy copy;
    if (!from.empty()) copy.replace("part6_roulette.cpp", from, to);
    fs::create_directories(classFolder());
    fs::copy(copy.with(), classFolder() / name, fs::copy_options::recursive);
  }

  std::vector<std::string> command(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{PATHMARK_PROGRAM, "grade",       quoted(classFolder()),
                                   "--out",          quoted(out()), "--only",
                                   "part6"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  ProcessResult grade(std::vector<std::string> more = {}) const {
    return run(command(std::move(more)), kRoot);
  }

  fs::path classFolder() const { return folder_ / "class"; }
  fs::path out() const { return folder_ / "grades"; }
  fs::path recordOf(const std::string& name) const {
    return out() / "submissions" / name / "record.json";
  }
  Json record(const std::string& name) const { return Json::parse(textOf(recordOf(name))); }

  TemporaryFolder folder_;
};

// A marked row's points, from marks.csv.
std::string rowOf(const std::string& csv, const std::string& name) {
  const std::size_t at = csv.find("\n" + name + ",");
  return at == std::string::npos ? "" : csv.substr(at + 1, csv.find('\n', at + 1) - at - 1);
}

constexpr const char* kWeight = "return {true, 1.0f / q};";

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
  EXPECT_NE(marks.output.find("this record is damaged"), std::string::npos) << marks.output;
  const std::string row = rowOf(textOf(out() / "marks.csv"), "right");
  EXPECT_TRUE(row.starts_with("right,,")) << row;
  EXPECT_NE(row.find("Its record is damaged"), std::string::npos) << row;
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_EQ(record("right")["parts"][0]["verdict"], "ok");
}

TEST_F(GradeCommand, HasARowWithoutMarksForEachThatItLeavesOut) {
  add("right");
  std::ofstream(classFolder() / "damaged.zip") << "PK\3\4garbage";
  std::ofstream(classFolder() / "other.7z") << "7z";
  fs::create_directories(classFolder() / "empty");
  fs::create_directory_symlink(classFolder() / "right", classFolder() / "link");
  const ProcessResult result = grade();
  EXPECT_EQ(result.exitCode, 0) << result.output;
  const std::string csv = textOf(out() / "marks.csv"), html = textOf(out() / "report.html");
  for (const std::string name : {"damaged", "other", "empty", "link"}) {
    const std::string row = rowOf(csv, name);
    EXPECT_TRUE(row.starts_with(name + ",,")) << csv;
    EXPECT_NE(row.find("No marks: "), std::string::npos) << csv;
    EXPECT_NE(html.find("submissions/" + name + "/report.html"), std::string::npos) << name;
    EXPECT_TRUE(fs::exists(out() / "submissions" / name / "report.html")) << name;
  }
  EXPECT_FALSE(rowOf(csv, "right").starts_with("right,,")) << csv;
  EXPECT_NE(html.find("4 have no marks."), std::string::npos);
  // Made anew, from the records alone.
  fs::remove_all(classFolder());
  EXPECT_EQ(
      run({PATHMARK_PROGRAM, "grade", "--out", quoted(out()), "--only", "part6"}, kRoot).exitCode,
      0);
  EXPECT_EQ(textOf(out() / "marks.csv"), csv);
}

TEST_F(GradeCommand, MarksWhatWasLeftOutOnceItIsHandedInAnew) {
  add("right");
  fs::create_directories(classFolder() / "bob");
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_TRUE(rowOf(textOf(out() / "marks.csv"), "bob").starts_with("bob,,"));
  fs::remove_all(classFolder() / "bob");
  std::ofstream(classFolder() / "bob.7z") << "7z";
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_TRUE(rowOf(textOf(out() / "marks.csv"), "bob").starts_with("bob,,"));
  // What is of no use still lies beside it.
  add("bob");
  EXPECT_EQ(grade().exitCode, 0);
  const std::string csv = textOf(out() / "marks.csv");
  EXPECT_FALSE(rowOf(csv, "bob").starts_with("bob,,")) << csv;
  EXPECT_TRUE(rowOf(csv, "bob-2").starts_with("bob-2,,")) << csv;
}

TEST_F(GradeCommand, WhatIsLeftOutReplacesNoMarkOfAnother) {
  add("ada");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string before = rowOf(textOf(out() / "marks.csv"), "ada");
  fs::create_directories(folder_ / "group2/ada");
  fs::copy(classFolder() / "ada", folder_ / "group2/ben");
  // No copy, of which there would be a remark.
  std::ofstream(folder_ / "group2/ben/part6_roulette.cpp", std::ios::app) << "// mine\n";
  for (int again = 0; again < 2; ++again) {
    const ProcessResult result = run({PATHMARK_PROGRAM, "grade", quoted(folder_ / "group2"),
                                      "--out", quoted(out()), "--only", "part6"},
                                     kRoot);
    EXPECT_EQ(result.exitCode, 0) << result.output;
    const std::string csv = textOf(out() / "marks.csv");
    EXPECT_EQ(rowOf(csv, "ada"), before);
    EXPECT_TRUE(rowOf(csv, "ada-2").starts_with("ada-2,,")) << csv;
    EXPECT_EQ(rowOf(csv, "ada-3"), "") << csv;
  }
}

TEST_F(GradeCommand, RemarksOnNoFileOfAnotherPartThanTheSelectedOne) {
  add("right");
  for (const auto& entry : fs::directory_iterator(classFolder() / "right"))
    if (entry.path().filename() != "part6_roulette.cpp") fs::remove_all(entry.path());
  ASSERT_EQ(grade().exitCode, 0);
  EXPECT_EQ(record("right")["collecting"], Json::array());
}

TEST_F(GradeCommand, KeepsApartNamesThatDifferBeyondAscii) {
  for (const char* name : {"M\u00fcller", "M\u00f6ller"}) {
    add(name);
    const ProcessResult result = run({PATHMARK_PROGRAM, "grade", quoted(classFolder() / name),
                                      "--out", quoted(out()), "--only", "part6"},
                                     kRoot);
    EXPECT_EQ(result.exitCode, 0) << result.output;
  }
  EXPECT_EQ(record("M\u00fcller")["source"], quoted(classFolder() / "M\u00fcller"));
  EXPECT_EQ(record("M\u00f6ller")["source"], quoted(classFolder() / "M\u00f6ller"));
  const std::string csv = textOf(out() / "marks.csv");
  EXPECT_FALSE(rowOf(csv, "M\u00fcller").empty()) << csv;
  EXPECT_FALSE(rowOf(csv, "M\u00f6ller").empty()) << csv;
}

TEST_F(GradeCommand, ReplacesNoRecordOfAnotherSubmission) {
  add("ada");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string before = textOf(recordOf("ada"));
  fs::copy(classFolder(), folder_ / "group2", fs::copy_options::recursive);
  const std::vector<std::string> other{
      PATHMARK_PROGRAM, "grade", quoted(folder_ / "group2/ada"), "--out", quoted(out()),
      "--only",         "part6"};
  const ProcessResult result = run(other, kRoot);
  EXPECT_EQ(result.exitCode, 0) << result.output;
  EXPECT_NE(result.output.find("another submission has been graded as ada"), std::string::npos)
      << result.output;
  EXPECT_EQ(textOf(recordOf("ada")), before);
  EXPECT_EQ(record("ada-2")["source"], quoted(folder_ / "group2/ada"));
}

TEST_F(GradeCommand, KnowsASubmissionThatWasMoved) {
  add("ada");
  ASSERT_EQ(grade().exitCode, 0);
  Json moved = record("ada");
  const std::string place = quoted(folder_ / "group2/ada");
  moved["source"] = place;
  fs::rename(classFolder(), folder_ / "group2");
  const std::vector<std::string> other{PATHMARK_PROGRAM, "grade",  place,  "--out",
                                       quoted(out()),    "--only", "part6"};
  EXPECT_EQ(run(other, kRoot).exitCode, 0);
  EXPECT_EQ(record("ada"), moved) << "the same files, so that it is not graded again";
  std::ofstream(folder_ / "group2/ada/part6_roulette.cpp", std::ios::app) << "// new\n";
  EXPECT_EQ(run(other, kRoot).exitCode, 0);
  EXPECT_NE(record("ada")["contents"], moved["contents"]);
  EXPECT_FALSE(fs::exists(recordOf("ada-2")));
}

TEST_F(GradeCommand, ASubmissionKeepsItsNameWhoeverComesAndGoes) {
  add("Alex_Kim");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string before = textOf(recordOf("Alex_Kim"));
  // Of the same safe name, and before the other in order.
  add("Alex Kim");
  const ProcessResult both = grade();
  EXPECT_EQ(both.exitCode, 0) << both.output;
  EXPECT_EQ(textOf(recordOf("Alex_Kim")), before);
  const std::string second = textOf(recordOf("Alex_Kim-2"));
  EXPECT_EQ(record("Alex_Kim-2")["source"], quoted(classFolder() / "Alex Kim"));
  fs::remove_all(classFolder() / "Alex_Kim");
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_EQ(textOf(recordOf("Alex_Kim")), before);
  EXPECT_EQ(textOf(recordOf("Alex_Kim-2")), second);
}

TEST_F(GradeCommand, APartsFolderIsTheSameForItsNumberAndItsName) {
  add("right");
  const fs::path made = folder_ / "grades-part6";
  ASSERT_EQ(run({PATHMARK_PROGRAM, "grade", quoted(classFolder()), "--only", "6"}, folder_.path())
                .exitCode,
            0);
  EXPECT_TRUE(fs::exists(made / "marks.csv"));
  fs::remove(made / "marks.csv");
  EXPECT_EQ(run({PATHMARK_PROGRAM, "grade", "--only", "part6"}, folder_.path()).exitCode, 0);
  EXPECT_TRUE(fs::exists(made / "marks.csv"));
}

TEST_F(GradeCommand, LeavesNoRowUnderTheOldNameOfASubmission) {
  add("ada");
  ASSERT_EQ(grade().exitCode, 0);
  // As if the same folder had been called otherwise by then.
  fs::rename(recordOf("ada").parent_path(), out() / "submissions" / "a_a");
  ASSERT_EQ(grade().exitCode, 0);
  EXPECT_FALSE(fs::exists(recordOf("a_a")));
  EXPECT_TRUE(fs::exists(recordOf("ada")));
  EXPECT_EQ(rowOf(textOf(out() / "marks.csv"), "a_a"), "");
}

TEST_F(GradeCommand, KeepsTheSeedOfItsFolder) {
  add("right");
  ASSERT_EQ(grade({"--seed", "3"}).exitCode, 0);
  const ProcessResult other = grade({"--seed", "4"});
  EXPECT_EQ(other.exitCode, 2);
  EXPECT_NE(other.output.find("was graded with seed 3"), std::string::npos) << other.output;
  EXPECT_EQ(grade().exitCode, 0);
  const ProcessResult all =
      run({PATHMARK_PROGRAM, "grade", quoted(classFolder()), "--out", quoted(out())}, kRoot);
  EXPECT_EQ(all.exitCode, 2);
  EXPECT_NE(all.output.find("part 6 only"), std::string::npos) << all.output;
}

TEST_F(GradeCommand, NamesSubmissionsOfTheSameFiles) {
  add("lee");
  add("kim");
  add("ann", kWeight, "return {true, 1.0f};");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string csv = textOf(out() / "marks.csv");
  EXPECT_NE(rowOf(csv, "kim").find("The same files as in lee."), std::string::npos) << csv;
  EXPECT_NE(rowOf(csv, "lee").find("The same files as in kim."), std::string::npos) << csv;
  EXPECT_EQ(rowOf(csv, "ann").find("The same files"), std::string::npos) << csv;
}

TEST_F(GradeCommand, OrdersRowsByNameWhateverIsCapital) {
  for (const char* name : {"zoe", "Yan", "task10", "Task9", "ada"})
    fs::create_directories(classFolder() / name);
  add("Ben");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string csv = textOf(out() / "marks.csv");
  std::size_t before = 0;
  for (const std::string name : {"ada", "Ben", "Task9", "task10", "Yan", "zoe"}) {
    const std::size_t at = csv.find("\n" + name + ",");
    ASSERT_NE(at, std::string::npos) << name << "\n" << csv;
    EXPECT_GT(at, before) << name << "\n" << csv;
    before = at;
  }
}

TEST_F(GradeCommand, MakesALostRunAnewFromItsRecords) {
  add("right");
  fs::create_directories(classFolder() / "empty");
  ASSERT_EQ(grade({"--seed", "3"}).exitCode, 0);
  const fs::path file = out() / "run.json";
  const std::string run1 = textOf(file), csv = textOf(out() / "marks.csv"),
                    before = textOf(recordOf("right"));
  const std::vector<std::string> anew{PATHMARK_PROGRAM, "grade", "--out", quoted(out())};
  for (const char* damaged : {"", "{", "[]", "{\"seed\": 3, \"parts\": [6]}"}) {
    std::ofstream(file) << damaged;
    const ProcessResult result = run(anew, kRoot);
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(textOf(file), run1) << damaged;
  }
  fs::remove(file);
  const ProcessResult other = grade({"--seed", "4"});
  EXPECT_EQ(other.exitCode, 2);
  EXPECT_NE(other.output.find("was graded with seed 3"), std::string::npos) << other.output;
  EXPECT_EQ(grade().exitCode, 0);
  EXPECT_EQ(textOf(file), run1);
  EXPECT_EQ(textOf(recordOf("right")), before) << "it was not graded again";
  EXPECT_EQ(textOf(out() / "marks.csv"), csv);
}

TEST_F(GradeCommand, KnowsARunOfTheWholeByItsPictures) {
  add("right");
  ASSERT_EQ(grade({"--seed", "3"}).exitCode, 0);
  Json whole = record("right");
  whole["pictures"] = whole["parts"][0]["pictures"];
  std::ofstream(recordOf("right")) << whole.dump();
  fs::remove(out() / "run.json");
  ASSERT_EQ(run({PATHMARK_PROGRAM, "grade", "--out", quoted(out())}, kRoot).exitCode, 0);
  const Json known = Json::parse(textOf(out() / "run.json"));
  EXPECT_EQ(known["whole"], true);
  EXPECT_EQ(known["seed"], 3);
  EXPECT_EQ(known["parts"].size(), parts().size());
}

TEST_F(GradeCommand, RefusesAFolderWhoseRunCannotBeKnown) {
  for (const char* name : {"a", "b"}) add(name);
  ASSERT_EQ(grade({"--seed", "3"}).exitCode, 0);
  fs::remove(out() / "run.json");
  const std::vector<std::string> anew{PATHMARK_PROGRAM, "grade", "--out", quoted(out())};
  Json other = record("b");
  other["seed"] = 4;
  std::ofstream(recordOf("b")) << other.dump();
  const ProcessResult disagree = run(anew, kRoot);
  EXPECT_EQ(disagree.exitCode, 2) << disagree.output;
  EXPECT_NE(disagree.output.find("not all of the same seed and parts"), std::string::npos)
      << disagree.output;
  for (const char* name : {"a", "b"}) std::ofstream(recordOf(name)) << "{";
  const ProcessResult damaged = run(anew, kRoot);
  EXPECT_EQ(damaged.exitCode, 2) << damaged.output;
  EXPECT_NE(damaged.output.find("no record here can be read"), std::string::npos) << damaged.output;
  EXPECT_FALSE(fs::exists(out() / "run.json"));
}

TEST_F(GradeCommand, SaysWhatItCannotMean) {
  const auto says = [](const std::vector<std::string>& words, const std::string& sentence) {
    std::vector<std::string> command{PATHMARK_PROGRAM, "grade"};
    command.insert(command.end(), words.begin(), words.end());
    const ProcessResult result = run(command, kRoot);
    EXPECT_EQ(result.exitCode, 2) << result.output;
    EXPECT_NE(result.output.find(sentence), std::string::npos) << result.output;
  };
  const std::string nowhere = quoted(folder_ / "nowhere");
  says({"--out", nowhere}, "Name what is to be graded");
  says({nowhere}, nowhere);
  says({"solutions", nowhere, "--out", nowhere}, nowhere + ": there is no such file or folder.");
  says({"solutions", "--only", "part7", "--out", nowhere}, "allowed is a part: part0 to part6");
  says({"solutions", "--rubric", nowhere}, nowhere);
  says({"solutions", "--jobs", "0"}, "--jobs");
  says({"solutions", "--sandbox", "none", "--out", nowhere}, "none");
  says({"README.md", "--out", nowhere}, "README.md");
  EXPECT_FALSE(fs::exists(nowhere));
}

TEST_F(GradeCommand, OneRunAtATimeInOneFolder) {
  for (const char* name : {"a", "b"}) add(name);
  BackgroundProgram program(command({"--jobs", "1"}), kRoot, folder_ / "log");
  ASSERT_TRUE(waitFor([&] { return fs::exists(recordOf("a")); }));
  const ProcessResult second = grade();
  program.signal(SIGINT);
  program.wait();
  EXPECT_EQ(second.exitCode, 2);
  EXPECT_NE(second.output.find("another run is grading"), std::string::npos) << second.output;
}

}  // namespace
}  // namespace pathmark::test
