// Any file of student/ may stand beside the others of solutions/, and the other way round.
#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "host/session.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

// Copies all parts, those in `fromSolutions` from the solutions and the rest from the stubs.
std::size_t unwrittenIn(const TemporaryFolder& folder, unsigned fromSolutions) {
  const fs::path project{build::kProjectFolder};
  for (const PartContract& part : parts()) {
    const bool solved = (fromSolutions >> part.part & 1u) != 0;
    fs::copy_file(project / (solved ? "solutions" : "student") / part.file,
                  folder.path() / part.file, fs::copy_options::overwrite_existing);
  }
  const CourseworkBuild build = buildCoursework(folder.path());
  EXPECT_FALSE(build.worker.empty()) << build.failure();
  SceneOverrides small;
  small.size = {12, 12};
  RenderOptions options;
  options.raysPerPixel = 4;
  const Coursework mixed{"mixed", build.folder, build.worker};
  std::size_t unwritten = 0;
  for (const char* scene : {"ucl_sphere", "cornell_box"}) {
    const RenderOutcome outcome = renderScene(mixed, loadScene(findScene(scene), small), options);
    EXPECT_EQ(invalidSentence(outcome.rendered, Estimator::kPath), "") << fromSolutions;
    unwritten = outcome.stubs.unwritten.size();
  }
  return unwritten;
}

std::size_t functionsOf(int part) {
  return static_cast<std::size_t>(
      std::count_if(contract().begin(), contract().end(),
                    [part](const FunctionContract& f) { return f.part == part; }));
}

// By number; there are no files of part 7.
constexpr unsigned kAllParts = 0b1101111111u, kFirstHalf = 0b0000001111u;

TEST(SwappedFiles, OneSolvedFileAmongStubsLinksAndRenders) {
  TemporaryFolder folder;
  for (const PartContract& part : parts())
    EXPECT_EQ(unwrittenIn(folder, 1u << part.part), contract().size() - functionsOf(part.part));
}

TEST(SwappedFiles, OneStubFileAmongSolutionsLinksAndRenders) {
  TemporaryFolder folder;
  for (const PartContract& part : parts())
    EXPECT_EQ(unwrittenIn(folder, kAllParts & ~(1u << part.part)), functionsOf(part.part));
}

TEST(SwappedFiles, HalfOfThePartsWrittenRenders) {
  TemporaryFolder folder;
  EXPECT_EQ(unwrittenIn(folder, kFirstHalf),
            functionsOf(4) + functionsOf(5) + functionsOf(6) + functionsOf(8) + functionsOf(9));
  EXPECT_EQ(unwrittenIn(folder, kAllParts & ~kFirstHalf),
            functionsOf(0) + functionsOf(1) + functionsOf(2) + functionsOf(3));
}

}  // namespace
}  // namespace pathmark::test
