// pathmark export, run as a program.
#include "host/session.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

class ExportedCommands : public testing::Test {
 protected:
  ExportedCommands() {
    for (const char* program : {"mitsuba", "pbrt", "pathmark"}) {
      std::ofstream(folder_ / program) << "#!/bin/sh\nfor word; do echo \"<$word>\"; done\n";
      fs::permissions(folder_ / program, fs::perms::owner_all);
    }
  }

  ProcessResult exportScene(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {PATHMARK_PROGRAM, "export"});
    return run(arguments, folder_.path());
  }

  // The commands that were printed: each on a line of its own, moved to the right.
  static std::vector<std::string> commandsIn(const std::string& output) {
    std::vector<std::string> commands;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("  ")) commands.push_back(line.substr(2));
    return commands;
  }

  // What the program gets if a shell is given the command.
  std::string wordsOf(const std::string& command) {
    return run({"/bin/sh", "-c", "PATH=.:$PATH; " + command}, folder_.path()).output;
  }

  std::string contentOf(const std::string& file) {
    std::ifstream in(folder_ / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  TemporaryFolder folder_;
};

TEST_F(ExportedCommands, PrintsCommandsThatAShellTakesAsTheyAreMeant) {
  fs::create_directory(folder_ / "my scenes");
  fs::copy_file(shippedSceneFile("ucl_rectangle"), folder_ / "my scenes" / "the $1 lamp.json");
  const std::string scene = "my scenes/the $1 lamp.json";
  for (const auto& [format, name, ending, called] :
       {std::array{"mitsuba", "Mitsuba", ".xml", "<-m>\n<llvm_ad_rgb>\n"},
        std::array{"pbrt", "pbrt", ".pbrt", ""}}) {
    const std::string output = "my scenes/it's one" + std::string(ending);
    const ProcessResult result = exportScene({scene, "--format", format, "--output", output});
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::vector<std::string> commands = commandsIn(result.output);
    ASSERT_EQ(commands.size(), 2u) << result.output;
    EXPECT_EQ(wordsOf(commands[0]), std::string(called) + "<it's one" + ending + ">\n");
    EXPECT_EQ(wordsOf(commands[1]), "<bench>\n<error>\n<" + scene + ">\n<--peer>\n<" + name +
                                        "=my scenes/it's one.exr,SECONDS>\n");
  }
}

TEST_F(ExportedCommands, TheFileNamesTheCommandThatIsPrinted) {
  for (const auto& [format, file] :
       {std::array{"mitsuba", "a lamp.xml"}, std::array{"pbrt", "a lamp.pbrt"}}) {
    const ProcessResult result =
        exportScene({"ucl_rectangle", "--format", format, "--output", file});
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::vector<std::string> commands = commandsIn(result.output);
    ASSERT_FALSE(commands.empty());
    EXPECT_NE(contentOf(file).find(commands[0]), std::string::npos) << contentOf(file);
  }
}

TEST_F(ExportedCommands, CompareWithAReferenceOfTheSameSizeAndBounces) {
  for (const std::string format : {"mitsuba", "pbrt"}) {
    const ProcessResult result =
        exportScene({"ucl_rectangle", "--format", format, "--size", "8x6", "--max-bounces", "0"});
    expectSays(result, 0, "bench error ucl_rectangle --size 8x6 --max-bounces 0 --peer ");
  }
}

TEST_F(ExportedCommands, ASceneThatIsNoFloatsIsRefused) {
  std::ofstream(folder_ / "huge.json") << R"({
    "camera": {"eye": [0, 0, 4e60], "target": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 45},
    "materials": {"white": {"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
    "shapes": [{"type": "sphere", "material": "white", "centre": [0, 0, 0], "radius": 1e60}]})";
  for (const std::string format : {"mitsuba", "pbrt"})
    expectSays(exportScene({"huge.json", "--format", format}), 2,
               "huge: found a coordinate of size 4e+60, but pbrt and Mitsuba compute in float");
  EXPECT_FALSE(fs::exists(folder_ / "huge.xml"));
}

TEST_F(ExportedCommands, RefusesNamesThatAreNoText) {
  for (const std::string name : {"a\x01.xml", "a\xff.xml"})
    expectSays(exportScene({"ucl_rectangle", "--format", "mitsuba", "--output", name}), 2,
               "it must be UTF-8");
}

TEST_F(ExportedCommands, SaysWhatToDoWithoutLlvm) {
  expectSays(exportScene({"ucl_rectangle", "--format", "mitsuba"}), 0, "-m scalar_rgb");
  const std::string pbrt = exportScene({"ucl_rectangle", "--format", "pbrt"}).output;
  EXPECT_EQ(pbrt.find("LLVM"), std::string::npos) << pbrt;
}

}  // namespace
}  // namespace pathmark::test
