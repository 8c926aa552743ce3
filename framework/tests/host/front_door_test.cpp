// The script at the top: what it does without the program.
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

namespace pathmark::test {
namespace {

constexpr const char* kFrontDoor = PATHMARK_FRONT_DOOR;

// The first word of each line that says what a command is for, in their order.
std::set<std::string> commandsIn(const std::string& help) {
  std::set<std::string> commands;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line == "Examples:") break;
    if (!line.starts_with("  ") || line[2] < 'a' || line[2] > 'z') continue;
    commands.insert(line.substr(2, line.find(' ', 2) - 2));
  }
  return commands;
}

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

TEST(FrontDoor, HasEveryCommandOfTheProgram) {
  const std::set<std::string> program = commandsIn(run({PATHMARK_PROGRAM, "--help"}).output);
  EXPECT_TRUE(program.contains("export"));
  EXPECT_EQ(commandsIn(run({kFrontDoor, "--help"}).output), program);
}

}  // namespace
}  // namespace pathmark::test
