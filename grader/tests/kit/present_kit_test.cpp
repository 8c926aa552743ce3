// The kit of the project as it is: what is in it, that it can be configured, and the command.
#include "kit/kit_plan.h"
#include "kit/project_files.h"
#include "kit/write_kit.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = PATHMARK_ROOT;

// Where CMake lets sources look.
constexpr const char* kIncludeFolders[] = {"framework", "grader", "framework/tests",
                                           "grader/tests"};

// Written once for all tests.
class PresentKit : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    written_ = kit::writeKit(kit::planKit(kRoot, kit::kNothingReleased), kit());
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static fs::path kit() { return *folder_ / "kit"; }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline kit::WrittenKit written_;
};

std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

std::string squeezed(std::string_view text) {
  std::string letters;
  std::copy_if(text.begin(), text.end(), std::back_inserter(letters),
               [](char c) { return std::isspace(static_cast<unsigned char>(c)) == 0; });
  return letters;
}

// Lines of code that say something, without white space.
std::vector<std::string> codeOf(const fs::path& file) {
  std::vector<std::string> lines;
  const std::string text = kit::readFile(file);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = squeezed(std::string_view(text).substr(begin, end - begin));
    const auto words = std::count_if(line.begin(), line.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0;
    });
    if (words >= 4 && !line.starts_with("//") && !line.starts_with("#") &&
        !line.starts_with("namespace"))
      lines.push_back(line);
    begin = end + 1;
  }
  return lines;
}

TEST_F(PresentKit, IsWritten) {
  EXPECT_EQ(written_.inspection.findings, std::vector<std::string>{});
  ASSERT_EQ(written_.outcome, kit::KitOutcome::kWritten);
  EXPECT_EQ(filesOf(kit()).size(), written_.inspection.files);
}

// Not by the means of the kit's own search.
TEST_F(PresentKit, HasNoThreeLinesOfTheSolutionsInAnyFileWhateverItHolds) {
  std::string all;
  for (const fs::path& file : filesOf(kit())) all += squeezed(kit::readFile(file)) + '\n';
  int looked = 0;
  for (const auto& entry : fs::directory_iterator(kRoot / "solutions")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::vector<std::string> lines = codeOf(entry.path());
    for (std::size_t k = 0; k + 3 <= lines.size(); ++k, ++looked) {
      const std::string three = lines[k] + lines[k + 1] + lines[k + 2];
      EXPECT_EQ(all.find(three), std::string::npos) << entry.path() << ": " << three;
    }
  }
  EXPECT_GT(looked, 150);
}

TEST_F(PresentKit, HasNoneOfTheFoldersThatAreHidden) {
  for (const char* name :
       {"solutions", "build", ".git", "grader/grading", "grader/kit", "grader/marking",
        "grader/record", "grader/rubric", "grader/sample_class", "grader/sandbox", "grader/study",
        "grader/submission", "grader/variants", "grader/tests/traps", "framework/tests/solved",
        "grader/report/class_html.cpp", "handouts/grading.md", "handouts/instructors.md"})
    EXPECT_FALSE(fs::exists(kit() / name)) << name;
}

// What includes a file that is not there does not compile; whole builds take too long here.
TEST_F(PresentKit, HasEveryFileThatItsSourcesInclude) {
  const std::regex include("#include \"([^\"\\s]+\\.h)\"");
  int found = 0;
  for (const fs::path& file : filesOf(kit())) {
    if (file.extension() != ".cpp" && file.extension() != ".h") continue;
    const std::string text = kit::readFile(file);
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end;
         ++match) {
      const std::string name = (*match)[1];
      if (name == "host/build_config.h") continue;  // made by CMake
      const bool there =
          std::any_of(std::begin(kIncludeFolders), std::end(kIncludeFolders),
                      [&](const char* folder) { return fs::exists(kit() / folder / name); });
      EXPECT_TRUE(there || fs::exists(file.parent_path() / name)) << file << " includes " << name;
      ++found;
    }
  }
  EXPECT_GT(found, 1000);
}

TEST_F(PresentKit, HasWhatItsChaptersLinkTo) {
  const std::regex link("\\]\\(([^)#:]+)[)#]");
  int found = 0;
  for (const fs::path& file : filesOf(kit())) {
    if (file.extension() != ".md") continue;
    const std::string text = kit::readFile(file);
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      const std::string target = (*match)[1];
      EXPECT_TRUE(fs::exists(file.parent_path() / target)) << file << " links to " << target;
      ++found;
    }
  }
  EXPECT_GT(found, 20);
}

TEST_F(PresentKit, TellsOfNoCommandThatItDoesNotHave) {
  const std::regex command("pathmark (kit|study|grade|pairs|gallery)\\b");
  for (const fs::path& file : filesOf(kit())) {
    if (file.extension() != ".md" && file.extension() != ".json") continue;
    EXPECT_FALSE(std::regex_search(kit::readFile(file), command)) << file;
  }
}

TEST_F(PresentKit, TellsOfNoCommandWithCourseworkThatItDoesNotHave) {
  const std::regex solved("(--with |--estimators )[^`\\s]*\\bsolutions\\b");
  for (const fs::path& file : filesOf(kit())) {
    if (file.extension() != ".md") continue;
    EXPECT_FALSE(std::regex_search(kit::readFile(file), solved)) << file;
  }
}

TEST_F(PresentKit, CanBeConfiguredAndItsStubsCompile) {
  const TemporaryFolder build;
  ProcessRequest request;
  request.arguments = {"cmake", "-S", kit().string(), "-B", build.path().string(), "-G", "Ninja"};
  request.timeLimitSeconds = 600.0;
  const ProcessResult configured = runProcess(request);
  EXPECT_EQ(configured.exitCode, 0) << configured.output;
  // All of it would take minutes.
  request.arguments = {"ninja", "-C", build.path().string(), "-n", "all"};
  EXPECT_EQ(runProcess(request).exitCode, 0);
  request.arguments = {"ninja", "-C", build.path().string(), "pathmark_standins",
                       "coursework_student"};
  const ProcessResult built = runProcess(request);
  EXPECT_EQ(built.exitCode, 0) << built.output;
}

TEST_F(PresentKit, OffersNoCommandThatItDoesNotHave) {
  const ProcessResult help = run({(kit() / "pathmark").string(), "--help"});
  expectSays(help, 0, "\n  check ");
  for (const char* command : {"kit", "study", "grade"}) {
    EXPECT_EQ(help.output.find(std::string("\n  ") + command + " "), std::string::npos) << command;
    expectSays(run({(kit() / "pathmark").string(), command}), 2,
               std::string("There is no command ") + command);
  }
}

ProcessResult kitCommand(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {PATHMARK_PROGRAM, "kit"});
  return run(std::move(arguments), kRoot);
}

TEST(KitCommand, SaysWhatItDid) {
  const TemporaryFolder folder;
  const std::string kit = (folder / "kit 4").string();
  const ProcessResult result = kitCommand({kit, "--release-through", "2"});
  expectSays(result, 0, "Parts 0 to 2 are solved, the others are stubs.");
  expectSays(result, 0, "hidden files is among their");
  expectSays(result, 0, "cd '" + kit + "' && ./pathmark demo");
  expectSays(kitCommand({kit}), 2, "is not empty; a kit is written to a new folder");
}

TEST(KitCommand, RefusesPartsThatDoNotExist) {
  const TemporaryFolder folder;
  for (const char* part : {"10", "-1", "part3", "1.5", ""})
    expectSays(kitCommand({(folder / "kit").string(), "--release-through", part}), 2,
               "allowed is a whole number from 0 to 9");
  EXPECT_EQ(kitCommand({}).exitCode, 2);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(KitCommand, SaysWhereItCannotWrite) {
  expectSays(kitCommand({"/proc/kit"}), 3, "The kit cannot be written to /proc/kit: ");
}

TEST(KitCommand, HelpCarriesExamples) { expectSays(kitCommand({"--help"}), 0, "Examples:"); }

}  // namespace
}  // namespace pathmark::test
