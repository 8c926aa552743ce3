// The contract's table, the markers in the stubs, and the names that the solutions define say the
// same.
#include "host/blob_file.h"
#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "host/session.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

const fs::path kProject{build::kProjectFolder};

// The stubs as they are handed out; a student's own copy has fewer markers.
TEST(Contract, EveryFunctionHasItsStubWithMarkerTaskAndSection) {
  for (const FunctionContract& f : contract()) {
    const std::string file(partNumbered(f.part).file);
    const std::string text = textOf(kProject / "student" / file);
    EXPECT_NE(
        text.find("PATHMARK_UNIMPLEMENTED(\"" + file + "\", \"" + std::string(f.name) + "\")"),
        std::string::npos)
        << f.name;
    EXPECT_NE(text.find("Part " + std::string(f.section) + " (handout section "), std::string::npos)
        << f.name;
  }
}

TEST(Contract, UnwrittenCourseworkBuildsRendersAndIsKnownAsUnwritten) {
  const CourseworkBuild build = buildCoursework(courseworkFolder("student"));
  ASSERT_FALSE(build.worker.empty()) << build.failure();
  const Coursework student{"student", build.folder, build.worker};
  for (const std::string& name : sceneNames()) {
    if (needsShippedBlobFile(findScene(name))) continue;  // its mesh is made, not shipped
    SceneOverrides small;
    small.size = {16, 16};
    RenderOptions options;
    options.raysPerPixel = 4;
    const RenderOutcome outcome = renderScene(student, loadScene(findScene(name), small), options);
    EXPECT_EQ(outcome.stubs.unwritten.size(), contract().size());
    EXPECT_TRUE(outcome.rendered.complete);
    EXPECT_EQ(invalidSentence(outcome.rendered, Estimator::kPath), "") << name;
  }
}

TEST(Contract, VisibleNamesAreThoseThatTheSolutionsDefine) {
  std::set<std::string> listed, defined;
  std::istringstream symbols(textOf(kProject / "framework/worker/contract.symbols"));
  for (std::string line; std::getline(symbols, line);) listed.insert(line);
  TemporaryFolder folder;
  for (const PartContract& part : parts()) {
    const std::string object = folder / (std::string(part.file) + ".o");
    const ProcessResult compiled =
        run({std::string(build::kCompiler), "-std=c++20", "-O1", "-I",
             (kProject / "framework/include").string(), "-c",
             (kProject / "solutions" / part.file).string(), "-o", object});
    ASSERT_EQ(compiled.exitCode, 0) << compiled.output;
    std::istringstream names(run({"nm", "--defined-only", "--extern-only", object}).output);
    for (std::string address, kind, name; names >> address >> kind >> name;)
      if (kind != "W" && name.find("pathmark") != std::string::npos &&
          name.find("8pathmark4BRDFE") == std::string::npos)
        defined.insert(name);
  }
  EXPECT_EQ(listed, defined);
  // Two classes of BRDFs bring three tables each.
  EXPECT_EQ(listed.size(), contract().size() + 6);
}

}  // namespace
}  // namespace pathmark::test
