// What is in a kit, where it is written, and what is left of one that is not finished.
#include "host/session.h"
#include "kit/small_project.h"
#include "worker/contract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(KitContents, ReleasedPartsAreTheSolutionsAndAllOthersTheStubs) {
  const SmallProject project;
  for (int released = kit::kNothingReleased; released <= kit::kLastPart; ++released) {
    SCOPED_TRACE(released);
    ASSERT_EQ(project.makeKit(released).outcome, kit::KitOutcome::kWritten);
    for (const PartContract& part : parts()) {
      const std::string file(part.file);
      const char* from = part.part <= released ? "solutions/" : "student/";
      EXPECT_EQ(textOf(project.inKit("student/" + file)), project.read(from + file)) << file;
    }
    EXPECT_EQ(textOf(project.inKit("student/scenes/my_scene.json")),
              project.read(released >= kit::kScenesPart ? "solutions/scenes/my_scene.json"
                                                        : "student/scenes/my_scene.json"));
    fs::remove_all(project.destination());
  }
}

TEST(KitContents, TheAnswersOfReleasedPartsMayBeQuotedAndNoOthers) {
  const SmallProject project;
  project.copy("solutions/part0_warmup.cpp", "handouts/answers.md");
  EXPECT_EQ(project.makeKit(0).outcome, kit::KitOutcome::kWritten);
  fs::remove_all(project.destination());
  project.copy("solutions/part1_stratified.cpp", "handouts/answers.md");
  EXPECT_EQ(project.makeKit(0).outcome, kit::KitOutcome::kRefused);
}

TEST(KitContents, WhatNoLineTakesStaysOut) {
  const SmallProject project;
  project.write("grader/marking/family.cpp", "// a family of hidden scenes\n");
  project.write("handouts/secrets/answers.md", "# Answers\n");
  project.write("handouts/.draft.md", "# A draft\n");
  project.write("notes.txt", "for the next term\n");
  ASSERT_EQ(project.makeKit().outcome, kit::KitOutcome::kWritten);
  for (const char* name : {"grader", "handouts/secrets", "handouts/.draft.md", "notes.txt",
                           "solutions", "build", ".git"})
    EXPECT_FALSE(fs::exists(project.inKit(name))) << name;
}

TEST(KitContents, TheReadmeIsTheStudentsAndTheScriptCanBeRun) {
  const SmallProject project;
  ASSERT_EQ(project.makeKit().outcome, kit::KitOutcome::kWritten);
  EXPECT_EQ(textOf(project.inKit("README.md")), project.read("grader/kit/student_readme.md"));
  EXPECT_NE(fs::status(project.inKit("pathmark")).permissions() & fs::perms::owner_exec,
            fs::perms::none);
}

TEST(KitContents, WhatAChapterTellsInstructorsStaysOut) {
  const SmallProject project;
  project.write("handouts/notes.md",
                "# Notes\n\nInstructors: `./pathmark study`,\nwhich takes long.\n\n"
                "```sh\n./pathmark check --with mine  # (instructors: solutions)\n```\n\n"
                "The figures (instructors: by `f(x)`,\nand more) are those\n"
                "(instructors: of a run).\n\nInstructors");
  ASSERT_EQ(project.makeKit().outcome, kit::KitOutcome::kWritten);
  EXPECT_EQ(textOf(project.inKit("handouts/notes.md")),
            "# Notes\n\n```sh\n./pathmark check --with mine  #\n```\n\n"
            "The figures are those.\n\n");
}

TEST(KitContents, WhatIsNoRemarkToInstructorsStaysIn) {
  const SmallProject project;
  const std::string text =
      "Ask your instructors (instructors know).\n\nWhat (instructors: is not closed\n\nends).\n";
  project.write("handouts/notes.md", text);
  ASSERT_EQ(project.makeKit().outcome, kit::KitOutcome::kWritten);
  EXPECT_EQ(textOf(project.inKit("handouts/notes.md")), text);
}

TEST(KitContents, ALineThatTakesNothingIsAnError) {
  const SmallProject project;
  project.append("grader/kit/contents.txt", "text shaders/*\n");
  try {
    project.makeKit();
    FAIL() << "a kit was made";
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "grader/kit/contents.txt:13: no file of the project matches shaders/*.");
  }
}

TEST(KitContents, LinesThatAreNoneAreErrors) {
  for (const char* line : {"scenes/*", "text", "text /etc/passwd", "text a as", "text a as b c",
                           "answers a as b", "text a b"}) {
    SCOPED_TRACE(line);
    EXPECT_THROW(kit::readManifest(line), std::runtime_error);
  }
}

TEST(KitContents, LinksAreRefused) {
  const SmallProject project;
  fs::create_symlink("/etc/hostname", project.path() / "handouts/machine.md");
  EXPECT_THROW(project.makeKit(), std::runtime_error);
  EXPECT_FALSE(fs::exists(project.destination()));
}

TEST(KitInspection, FindsWhatThePlanDoesNotHaveAndWhatIsMissing) {
  const SmallProject project;
  ASSERT_EQ(project.makeKit().outcome, kit::KitOutcome::kWritten);
  std::ofstream(project.inKit("student/part8.cpp")) << "// one more\n";
  fs::create_symlink("/etc", project.inKit("etc"));
  fs::remove(project.inKit("README.md"));
  const kit::Inspection inspection =
      kit::inspectKit(kit::planKit(project.path(), kit::kNothingReleased), project.destination());
  EXPECT_EQ(inspection.findings,
            (std::vector<std::string>{"README.md is missing.", "etc does not belong into a kit.",
                                      "student/part8.cpp does not belong into a kit."}));
}

TEST(KitFolder, MayBeEmptyButHoldNothing) {
  const SmallProject project;
  fs::create_directory(project.destination());
  EXPECT_EQ(project.makeKit().outcome, kit::KitOutcome::kWritten);
  const std::string before = textOf(project.inKit("README.md"));
  EXPECT_THROW(project.makeKit(), UsageError);
  EXPECT_EQ(textOf(project.inKit("README.md")), before);
}

TEST(KitFolder, IsNoFileAndNotInTheProject) {
  const SmallProject project;
  std::ofstream(project.destination()) << "a file\n";
  EXPECT_THROW(project.makeKit(), UsageError);
  EXPECT_EQ(textOf(project.destination()), "a file\n");
  const kit::KitPlan plan = kit::planKit(project.path(), kit::kNothingReleased);
  EXPECT_THROW(kit::writeKit(plan, project.path() / "kit"), UsageError);
  EXPECT_EQ(kit::writeKit(plan, project.path() / "build/kit").outcome, kit::KitOutcome::kWritten);
}

TEST(KitFolder, OfAnInterruptedRunDoesNotExistWhereverItWasStopped) {
  const SmallProject project;
  const kit::KitPlan plan = kit::planKit(project.path(), kit::kNothingReleased);
  for (std::size_t files = 0; files <= plan.files.size(); ++files) {
    std::size_t left = files;
    const kit::WrittenKit written =
        kit::writeKit(plan, project.destination(), [&] { return left-- > 0; });
    EXPECT_EQ(written.outcome, kit::KitOutcome::kStopped);
    EXPECT_TRUE(fs::is_empty(project.destination().parent_path())) << files;
  }
}

TEST(KitFolder, IsMadeAfterARunThatWasKilled) {
  const SmallProject project;
  const fs::path unfinished = kit::unfinishedFolder(project.destination());
  fs::create_directories(unfinished / "solutions");
  std::ofstream(unfinished / "solutions/part3_lambertian.cpp") << "// left behind\n";
  ASSERT_EQ(project.makeKit().outcome, kit::KitOutcome::kWritten);
  EXPECT_FALSE(fs::exists(unfinished));
  EXPECT_FALSE(fs::exists(project.inKit("solutions")));
}

}  // namespace
}  // namespace pathmark::test
