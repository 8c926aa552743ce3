// The script at the top: what it does without the program.
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

constexpr const char* kFrontDoor = PATHMARK_FRONT_DOOR;

TEST(FrontDoor, HelpNeedsNoBuildAndCarriesExamples) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--help"}, {"help"}, {"test", "--help"}, {"clean", "--help"}}) {
    std::vector<std::string> command{kFrontDoor};
    command.insert(command.end(), words.begin(), words.end());
    const ProcessResult result = run(command);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.output.find("Examples:"), std::string::npos) << result.output;
  }
}

TEST(FrontDoor, UnknownCommandsAndOptionsAreSentences) {
  const ProcessResult unknown = run({kFrontDoor, "paint"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_NE(unknown.output.find("There is no command paint"), std::string::npos);
  EXPECT_EQ(run({kFrontDoor}).exitCode, 2);
  EXPECT_EQ(run({kFrontDoor, "test", "--preset", "fast"}).exitCode, 2);
  EXPECT_EQ(run({kFrontDoor, "clean", "everything"}).exitCode, 2);
}

TEST(FrontDoor, WorksThroughALinkAndFromAnyFolder) {
  TemporaryFolder folder;
  std::filesystem::create_symlink(kFrontDoor, folder / "pathmark");
  EXPECT_EQ(run({"./pathmark", "--help"}, folder.path()).exitCode, 0);
}

}  // namespace
}  // namespace pathmark::test
