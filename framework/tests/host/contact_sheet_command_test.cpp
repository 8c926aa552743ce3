// pathmark contact-sheet, run as a program.
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace pathmark::test {
namespace {

class ContactSheetCommand : public testing::Test {
 protected:
  std::vector<std::string> commandLine(const std::string& raysPerPixel) {
    return {PATHMARK_PROGRAM,   "contact-sheet", "--thumbnail", "16",
            "--rays-per-pixel", raysPerPixel,    "--with",      coursework_.folder().string()};
  }
  ProcessResult sheet(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = commandLine("1");
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, folder_.path());
  }
  bool wrote(const std::string& name) { return std::filesystem::exists(folder_ / name); }

  TemporaryFolder folder_;
  TestCoursework coursework_;
};

TEST_F(ContactSheetCommand, DrawsTheGivenScenesOnOnePicture) {
  expectSays(sheet({"furnace", "cornell_box", "veach_plates"}), 0,
             "contact_sheet.png: 56x29, 3 of 3 scenes");
  EXPECT_TRUE(wrote("contact_sheet.png"));
}

TEST_F(ContactSheetCommand, TakesScenesByTheirPath) {
  for (const char* student : {"anna", "bert"}) {
    std::filesystem::create_directories(folder_ / student);
    std::ofstream(folder_ / student / "mine.json")
        << R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "fieldOfView": 45},
               "size": [30, 20], "materials": {"m": {"type": "lambertian", "Kd": [0, 0, 0]}},
               "shapes": [{"type": "sphere", "material": "m", "centre": [0, 0, 0], "radius": 1,
                           "emission": [1, 1, 1]}]})";
  }
  const ProcessResult result = sheet({"anna/mine.json", "bert/mine.json", "--output", "a.png"});
  expectSays(result, 0, "anna/mine");
  expectSays(result, 0, "bert/mine");
  expectSays(result, 0, "16x11");
  EXPECT_TRUE(wrote("a.png"));
}

TEST_F(ContactSheetCommand, ASceneThatDoesNotLoadCostsItsOwnTileOnly) {
  std::ofstream(folder_ / "broken.json") << "{";
  const ProcessResult result = sheet({"broken.json", "furnace", "missing.json"});
  expectSays(result, 2, "1 of 3 scenes");
  expectSays(result, 2, "broken.json");
  expectSays(result, 2, "missing.json");
  EXPECT_TRUE(wrote("contact_sheet.png"));
}

TEST_F(ContactSheetCommand, CourseworkThatCrashesIsTheCourseworksFault) {
  coursework_.setTracePath(
      "(void)ray; (void)sampler;\n*(volatile int*)16 = 1;\nreturn Colour(0.0f);");
  const ProcessResult result = sheet({"furnace", "cornell_box"});
  expectSays(result, 1, "0 of 2 scenes");
  expectSays(result, 1, "cornell_box: ");
  EXPECT_TRUE(wrote("contact_sheet.png"));
}

TEST_F(ContactSheetCommand, InvalidValuesAreToldWithTheirScene) {
  coursework_.setTracePath("(void)sampler;\nreturn Colour(std::sqrt(ray.direction.x));");
  expectSays(sheet({"furnace"}), 1, "furnace: renderPixel returned");
  EXPECT_TRUE(wrote("contact_sheet.png"));
}

TEST_F(ContactSheetCommand, InterruptedItWritesWhatThereIs) {
  std::vector<std::string> arguments{"/usr/bin/timeout", "--foreground", "--preserve-status",
                                     "--signal=INT", "4"};
  for (const std::string& word : commandLine("100000000")) arguments.push_back(word);
  arguments.insert(arguments.end(), {"furnace", "cornell_box"});
  expectSays(run(arguments, folder_.path()), 130, "of 2 scenes");
  EXPECT_TRUE(wrote("contact_sheet.png"));
}

TEST_F(ContactSheetCommand, WrongCommandLinesAreSentencesAndWriteNothing) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"corner_box"}, "Did you mean \"cornell_box\"?"},
      {{"furnace", "--output", "a.pfm"}, "a contact sheet is a .png file"},
      {{"furnace", "--output", "no/such/a.png"}, "there is no folder no/such"},
      {{"furnace", "--frobnicate"}, "--frobnicate was not expected"},
  };
  for (const auto& [arguments, words] : cases) expectSays(sheet(arguments), 2, words);
  const ProcessResult small = run({PATHMARK_PROGRAM, "contact-sheet", "--thumbnail", "15"});
  expectSays(small, 2, "from 16 to 1024");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(ContactSheetCommand, HelpCarriesExamples) {
  expectSays(run({PATHMARK_PROGRAM, "contact-sheet", "--help"}), 0, "Examples:");
}

}  // namespace
}  // namespace pathmark::test
