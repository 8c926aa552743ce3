// What a folder of grades keeps: names, rows and records of submissions that come, go and move.
#include "support/background_program.h"
#include "support/grade_command.h"

#include <filesystem>
#include <fstream>

namespace pathmark::test {
namespace {

class GradeFolder : public GradeCommand {};

TEST_F(GradeFolder, HasARowWithoutMarksForEachThatItLeavesOut) {
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

TEST_F(GradeFolder, MarksWhatWasLeftOutOnceItIsHandedInAnew) {
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

TEST_F(GradeFolder, WhatIsLeftOutReplacesNoMarkOfAnother) {
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

TEST_F(GradeFolder, RemarksOnNoFileOfAnotherPartThanTheSelectedOne) {
  add("right");
  for (const auto& entry : fs::directory_iterator(classFolder() / "right"))
    if (entry.path().filename() != "part6_roulette.cpp") fs::remove_all(entry.path());
  ASSERT_EQ(grade().exitCode, 0);
  EXPECT_EQ(record("right")["collecting"], Json::array());
}

TEST_F(GradeFolder, SaysWhatIsHandedInBesideTheSameFiles) {
  add("right");
  fs::remove(classFolder() / "right/part6_roulette.cpp");
  ASSERT_EQ(grade().exitCode, 0);
  const Json before = record("right");
  const std::string csv = textOf(out() / "marks.csv");
  EXPECT_EQ(csv.find("something was handed in"), std::string::npos) << csv;
  std::ofstream(classFolder() / "right/part6_roulette (1).cpp") << "// all of it\n";
  std::ofstream(classFolder() / "right/part6_roulette (2).cpp") << "// or this\n";
  ASSERT_EQ(grade().exitCode, 0);
  Json after = record("right");
  EXPECT_NE(after["collecting"], before["collecting"]);
  after["collecting"] = before["collecting"];
  EXPECT_EQ(after, before) << "the same files, so that it is not graded again";
  const std::string later = textOf(out() / "marks.csv");
  EXPECT_NE(later.find("something was handed in"), std::string::npos) << later;
}

TEST_F(GradeFolder, DoesNotBelieveWhatWasGradedWithoutASandboxOnceThereIsOne) {
  add("right");
  ASSERT_EQ(grade().exitCode, 0);
  Json made = record("right");
  const std::string sandbox = made["build"]["sandbox"];
  if (sandbox == "none") GTEST_SKIP() << "no sandbox works here";
  made["build"]["sandbox"] = "none";
  std::ofstream(recordOf("right")) << made.dump();
  ASSERT_EQ(grade().exitCode, 0);
  EXPECT_EQ(record("right")["build"]["sandbox"], sandbox);
}

TEST_F(GradeFolder, SaysNothingOfItsOwnFolderAmongTheSubmissions) {
  add("right");
  for (int again = 0; again < 2; ++again) {
    const fs::path inside = classFolder() / "grades";
    const ProcessResult result = run({PATHMARK_PROGRAM, "grade", quoted(classFolder()), "--out",
                                      quoted(inside), "--only", "part6"},
                                     kRoot);
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(result.output.find("was left out"), std::string::npos) << result.output;
    EXPECT_EQ(rowOf(textOf(inside / "marks.csv"), "grades"), "");
  }
}

TEST_F(GradeFolder, KeepsApartNamesThatDifferBeyondAscii) {
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

TEST_F(GradeFolder, ReplacesNoRecordOfAnotherSubmission) {
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

TEST_F(GradeFolder, KnowsASubmissionThatWasMoved) {
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

TEST_F(GradeFolder, ASubmissionKeepsItsNameWhoeverComesAndGoes) {
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

TEST_F(GradeFolder, APartsFolderIsTheSameForItsNumberAndItsName) {
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

TEST_F(GradeFolder, LeavesNoRowUnderTheOldNameOfASubmission) {
  add("ada");
  ASSERT_EQ(grade().exitCode, 0);
  // As if the same folder had been called otherwise by then.
  fs::rename(recordOf("ada").parent_path(), out() / "submissions" / "a_a");
  ASSERT_EQ(grade().exitCode, 0);
  EXPECT_FALSE(fs::exists(recordOf("a_a")));
  EXPECT_TRUE(fs::exists(recordOf("ada")));
  EXPECT_EQ(rowOf(textOf(out() / "marks.csv"), "a_a"), "");
}

TEST_F(GradeFolder, KeepsTheSeedOfItsFolder) {
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

TEST_F(GradeFolder, NamesSubmissionsOfTheSameFiles) {
  add("lee");
  add("kim");
  add("ann", kWeight, "return {true, 1.0f};");
  ASSERT_EQ(grade().exitCode, 0);
  const std::string csv = textOf(out() / "marks.csv");
  EXPECT_NE(rowOf(csv, "kim").find("The same files as in lee."), std::string::npos) << csv;
  EXPECT_NE(rowOf(csv, "lee").find("The same files as in kim."), std::string::npos) << csv;
  EXPECT_EQ(rowOf(csv, "ann").find("The same files"), std::string::npos) << csv;
}

TEST_F(GradeFolder, OrdersRowsByNameWhateverIsCapital) {
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

TEST_F(GradeFolder, MakesALostRunAnewFromItsRecords) {
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

TEST_F(GradeFolder, KnowsARunOfTheWholeByItsPictures) {
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

TEST_F(GradeFolder, RefusesAFolderWhoseRunCannotBeKnown) {
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

TEST_F(GradeFolder, SaysWhatItCannotMean) {
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

TEST_F(GradeFolder, OneRunAtATimeInOneFolder) {
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
