// pathmark mesh, run as a program.
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace pathmark::test {
namespace {

class MeshCommand : public testing::Test {
 protected:
  ProcessResult mesh(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {PATHMARK_PROGRAM, "mesh"});
    return run(arguments, folder_.path());
  }
  void expectRefuses(std::vector<std::string> arguments, const std::string& words) {
    const ProcessResult result = mesh(std::move(arguments));
    EXPECT_EQ(result.exitCode, 2) << result.output;
    EXPECT_NE(result.output.find(words), std::string::npos) << result.output;
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  }

  TemporaryFolder folder_;
};

TEST_F(MeshCommand, WritesTheFileItNamesAndCountsItsTriangles) {
  const ProcessResult result = mesh({"blob", "--subdivisions", "3", "--output", "small.obj"});
  EXPECT_EQ(result.exitCode, 0) << result.output;
  EXPECT_EQ(result.output.find("small.obj: 72 triangles, "), 0u) << result.output;
  std::ifstream file(folder_ / "small.obj");
  int vertices = 0, faces = 0;
  for (std::string line; std::getline(file, line);) {
    vertices += line.starts_with("v ") ? 1 : 0;
    faces += line.starts_with("f ") ? 1 : 0;
  }
  EXPECT_EQ(vertices, 38);
  EXPECT_EQ(faces, 72);
}

TEST_F(MeshCommand, WrongCommandLinesAreSentencesAndWriteNothing) {
  expectRefuses({}, "MESH");
  expectRefuses({"blub", "--output", "a.obj"}, "There is no mesh blub");
  expectRefuses({"blob", "--subdivisions", "0", "--output", "a.obj"}, "from 1 to 2000");
  expectRefuses({"blob", "--subdivisions", "2001", "--output", "a.obj"}, "from 1 to 2000");
  expectRefuses({"blob", "--subdivisions", "3.5", "--output", "a.obj"}, "a whole number");
  expectRefuses({"blob", "--output", "no/such/folder.obj"}, "there is no folder no/such");
  expectRefuses({"blob", "--output", "."}, "this is a folder");
}

TEST_F(MeshCommand, HelpCarriesExamples) {
  const ProcessResult result = mesh({"--help"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.output.find("Examples:"), std::string::npos);
}

}  // namespace
}  // namespace pathmark::test
