// The script at the top: what it does without the program.
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
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

// A copy of the script in a folder of its own, with tools that only say what they would do.
class FrontDoorBuild : public testing::Test {
 protected:
  FrontDoorBuild() {
    std::filesystem::copy_file(kFrontDoor, folder_ / "pathmark");
    std::filesystem::create_directory(folder_ / "tools");
    write("apt-get", "exit 1");
    write("dpkg-query", "echo installed");
    write("cmake", "mkdir -p build/$2; touch build/$2/build.ninja");
  }

  // A build of so many steps.
  void setSteps(int steps) {
    write("ninja",
          "program=$2/bin/pathmark\n"
          "if [ \"$3\" = -n ]; then\n"
          "  [ -e \"$program\" ] && echo 'ninja: no work to do.' && exit\n"
          "  for k in $(seq " +
              std::to_string(steps) +
              "); do echo \"[$k] CXX\"; done\n"
              "else\n"
              "  mkdir -p \"$2/bin\"\n"
              "  printf '#!/bin/sh\\necho the program\\n' >\"$program\"; chmod +x \"$program\"\n"
              "fi");
  }

  ProcessResult door(const std::vector<std::string>& words) {
    std::vector<std::string> command{"/usr/bin/env",
                                     "PATH=" + (folder_ / "tools").string() + ":/usr/bin:/bin",
                                     (folder_ / "pathmark").string()};
    command.insert(command.end(), words.begin(), words.end());
    return run(command, folder_.path());
  }
  ProcessResult status() { return door({"status"}); }

  TemporaryFolder folder_;

  void write(const std::string& tool, const std::string& code) {
    const std::filesystem::path file = folder_ / "tools" / tool;
    std::ofstream(file) << "#!/bin/sh\n" << code << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
};

TEST_F(FrontDoorBuild, SaysOnceThatAWholeBuildTakesMinutes) {
  setSteps(345);
  const ProcessResult first = status();
  expectSays(first, 0, "takes some minutes (345 steps)");
  expectSays(first, 0, "the program");
  const ProcessResult second = status();
  expectSays(second, 0, "the program");
  EXPECT_EQ(second.output.find("minutes"), std::string::npos) << second.output;
}

TEST_F(FrontDoorBuild, SaysNothingOfMinutesWhereLittleHasChanged) {
  setSteps(3);
  const ProcessResult result = status();
  expectSays(result, 0, "the program");
  EXPECT_EQ(result.output.find("minutes"), std::string::npos) << result.output;
}

TEST_F(FrontDoorBuild, AFolderThatWasBuiltElsewhereIsMadeAnew) {
  setSteps(3);
  write("cmake",
        "mkdir -p build/$2; touch build/$2/build.ninja\n"
        "echo \"CMAKE_HOME_DIRECTORY:INTERNAL=$PWD\" >build/$2/CMakeCache.txt");
  const std::string words = "was made for";
  expectSays(status(), 0, "the program");
  EXPECT_EQ(status().output.find(words), std::string::npos) << "it is the same place";
  TemporaryFolder old;
  const std::filesystem::path build = folder_ / "build/release";
  std::ofstream(build / "CMakeCache.txt")
      << "CMAKE_HOME_DIRECTORY:INTERNAL=" << old.path().string() << "\n";
  std::ofstream(build / "bin/pathmark") << "#!/bin/sh\necho the old place\n";
  const ProcessResult result = status();
  expectSays(result, 0, words + " " + old.path().string());
  expectSays(result, 0, "the program");
  EXPECT_EQ(result.output.find("the old place"), std::string::npos) << result.output;
}

TEST_F(FrontDoorBuild, APackageOfSeveralArchitecturesIsInstalled) {
  setSteps(3);
  // As dpkg-query does with a format of words and line ends.
  write("dpkg-query",
        "format=$(printf '%s' \"$3\" | sed 's/${db:Status-Status}/installed/')\n"
        "printf \"$format$format\"");
  const ProcessResult result = status();
  expectSays(result, 0, "the program");
  EXPECT_EQ(result.output.find("missing"), std::string::npos) << result.output;
}

TEST_F(FrontDoorBuild, NoAnswerInstallsNothing) {
  setSteps(3);
  write("dpkg-query", "exit 1");
  for (const char* tool : {"apt-get", "sudo"}) write(tool, "echo would install");
  // `script` gives a terminal, and ends its input where its own ends.
  const ProcessResult result =
      run({"/bin/sh", "-c",
           "PATH=" + (folder_ / "tools").string() +
               ":/usr/bin:/bin script -qec './pathmark status' /dev/null </dev/null"},
          folder_.path());
  expectSays(result, 3, "Nothing was installed");
  EXPECT_EQ(result.output.find("would install"), std::string::npos) << result.output;
}

TEST_F(FrontDoorBuild, WithoutAptThePackagesAreANoteAndCMakeDecides) {
  setSteps(3);
  for (const char* tool : {"apt-get", "dpkg-query"})
    std::filesystem::remove(folder_ / "tools" / tool);
  // The system's own may be there: of /usr/bin only what the script needs.
  for (const char* tool : {"bash", "env", "cat", "dirname", "readlink", "mkdir", "touch", "sed",
                           "grep", "rm", "seq", "chmod", "sh"})
    std::filesystem::create_symlink(std::filesystem::path("/usr/bin") / tool,
                                    folder_ / "tools" / tool);
  const auto statusWithoutApt = [&] {
    return run({"/usr/bin/env", "PATH=" + (folder_ / "tools").string(),
                (folder_ / "pathmark").string(), "status"},
               folder_.path());
  };
  const ProcessResult there = statusWithoutApt();
  expectSays(there, 0, "equivalents of these Debian packages");
  expectSays(there, 0, "the program");
  std::filesystem::remove_all(folder_ / "build");
  write("cmake", "echo no glm; exit 1");
  for (int k = 0; k < 2; ++k) {
    const ProcessResult missing = statusWithoutApt();
    expectSays(missing, 3, "no glm");
    expectSays(missing, 3, "equivalents of these Debian packages");
  }
}

TEST_F(FrontDoorBuild, APresetIsTakenInBothForms) {
  setSteps(3);
  write("ctest", "echo \"ctest $*\"");
  expectSays(door({"test", "--preset=fast"}), 2, "takes release, asan or tsan");
  expectSays(door({"test", "--preset", "asan", "-R", "Sphere"}), 0,
             "ctest --preset asan -R Sphere");
  expectSays(door({"test", "--preset=asan", "-R", "Sphere"}), 0, "ctest --preset asan -R Sphere");
}

TEST_F(FrontDoorBuild, LintFailsIfAToolOfClangsFindsSomething) {
  setSteps(3);
  std::filesystem::create_directory(folder_ / "solutions");
  for (const char* name : {"good.cpp", "untidy.cpp", "crooked.h"}) std::ofstream(folder_ / name);
  write("clang-format", "case \"$*\" in *crooked*) echo crooked; exit 1 ;; esac");
  write("clang-tidy", "case \"$*\" in *untidy*) echo untidy; exit 1 ;; esac");
  expectSays(door({"lint", "good.cpp"}), 0, "");
  expectSays(door({"lint", "good.cpp", "untidy.cpp"}), 1, "untidy");
  expectSays(door({"lint", "crooked.h"}), 1, "crooked");
  expectSays(door({"lint", "gone.cpp"}), 2, "There is no file gone.cpp");
  expectSays(door({"lint", "--since", "gone"}), 2, "there is none that is called 'gone'");
  write("git", "");
  expectSays(door({"lint", "--since", "HEAD", "good.cpp"}), 2, "not both: found good.cpp");
  std::filesystem::remove(folder_ / "solutions");
  expectSays(door({"lint", "good.cpp"}), 2, "There is no command lint");
}

TEST(FrontDoor, HasEveryCommandOfTheProgram) {
  const std::set<std::string> program = commandsIn(run({PATHMARK_PROGRAM, "--help"}).output);
  EXPECT_TRUE(program.contains("export"));
  std::set<std::string> door = commandsIn(run({kFrontDoor, "--help"}).output);
  door.erase("lint");  // which needs the files alone
  EXPECT_EQ(door, program);
}

}  // namespace
}  // namespace pathmark::test
