// From a folder of files to a worker: what is compiled, what is kept, what is refused.
#include "host/coursework_builder.h"

#include "host/build_config.h"
#include "host/session.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

namespace pathmark::test {
namespace {

// In which every step ends in the same way. Counts how many there are at the same time.
class EndingConfinement : public Confinement {
 public:
  explicit EndingConfinement(ProcessResult ending) : ending_(std::move(ending)) {}

  std::string name() const override { return "ending"; }
  std::filesystem::path visible(const std::filesystem::path& path) override { return path; }
  std::filesystem::path makeScratchFolder() override {
    std::filesystem::path made = folder_ / std::to_string(++scratches_);
    std::filesystem::create_directories(made);
    return made;
  }
  ProcessResult run(const Step&) override {
    const int steps = ++steps_;
    for (int most = mostSteps_; steps > most && !mostSteps_.compare_exchange_weak(most, steps);) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    --steps_;
    return ending_;
  }
  LaunchedWorker launch(const std::filesystem::path&, std::size_t) override {
    throw ConfinementError("nothing is started here");
  }

  int mostSteps() const { return mostSteps_; }

 private:
  ProcessResult ending_;
  TemporaryFolder folder_;
  std::atomic<int> scratches_{0}, steps_{0}, mostSteps_{0};
};

constexpr int kKilled = 128 + 9;

TEST(CourseworkBuilder, NothingIsCompiledTwice) {
  TestCoursework coursework;
  const CourseworkBuild first = buildCoursework(coursework.folder());
  ASSERT_FALSE(first.worker.empty()) << first.failure();
  const auto made = std::filesystem::last_write_time(first.worker);
  const CourseworkBuild second = buildCoursework(coursework.folder());
  EXPECT_EQ(second.worker, first.worker);
  EXPECT_EQ(std::filesystem::last_write_time(second.worker), made);
}

TEST(CourseworkBuilder, AChangedFileGivesAnotherWorker) {
  TestCoursework coursework;
  const auto first = buildCoursework(coursework.folder()).worker;
  coursework.setTracePath("(void)ray; (void)sampler; return Colour(0.125f);");
  EXPECT_NE(buildCoursework(coursework.folder()).worker, first);
}

TEST(CourseworkBuilder, AWarningIsSaidUntilItsCauseIsMended) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray;\nfloat x = sampler.next1D();\nif (x = 0) x = 1;\nreturn Colour(x);");
  for (int build = 0; build < 2; ++build) {
    const PartBuild part = compilePart(coursework.folder(), 5);
    ASSERT_TRUE(part.compiled) << part.messages;
    EXPECT_NE(part.warnings().find("part5_path.cpp:6:"), std::string_view::npos) << part.messages;
    EXPECT_NE(part.warnings().find("-Wparentheses"), std::string_view::npos) << part.messages;
  }
  coursework.setTracePath("(void)ray; return Colour(sampler.next1D());");
  EXPECT_EQ(compilePart(coursework.folder(), 5).messages, "");
}

TEST(CourseworkBuilder, AVariableWithoutAValueIsAWarning) {
  TestCoursework coursework;
  coursework.setTracePath(
      "float best;\nif (sampler.next1D() < 0.5f) best = ray.direction.x;\nreturn Colour(best);");
  EXPECT_NE(compilePart(coursework.folder(), 5).warnings().find("uninitialized"),
            std::string_view::npos);
}

TEST(CourseworkBuilder, StartsNoMoreCompilersThanItIsAllowed) {
  TestCoursework coursework;
  const auto confinement = std::make_shared<EndingConfinement>(ProcessResult{1, false, 0.0, ""});
  buildCoursework(coursework.folder(), Incomplete::kCompileOnly, confinement, 1);
  EXPECT_EQ(confinement->mostSteps(), 1);
  buildCoursework(coursework.folder(), Incomplete::kCompileOnly, confinement, 4);
  EXPECT_LE(confinement->mostSteps(), 4);
  EXPECT_GT(confinement->mostSteps(), 1);
}

// Contracted products and sums would make edge functions of neighbouring triangles disagree, and
// marks depend on the compiler's choices.
TEST(CourseworkBuilder, CompilesWithArithmeticAsItIsWritten) {
  const std::set<std::string_view> flags(build::kCourseworkFlags.begin(),
                                         build::kCourseworkFlags.end());
  EXPECT_TRUE(flags.contains("-ffp-contract=off"));
  for (const char* loose : {"-ffast-math", "-Ofast", "-funsafe-math-optimizations"})
    EXPECT_FALSE(flags.contains(loose)) << loose;
}

TEST(CourseworkBuilder, UsesNothingOfTheFrameworkThatNoHeaderDeclares) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp", R"(
void countRaysOfThisThread(std::uint64_t rays);
Roulette LitScene::RussianRoulette(const Colour&, int, float) const {
  countRaysOfThisThread(1);
  return {true, 1.0f};
})");
  const CourseworkBuild made = buildCoursework(coursework.folder());
  EXPECT_FALSE(made.complete());
  EXPECT_NE(made.failure().find("the coursework uses pathmark::countRaysOfThisThread(unsigned "
                                "long), which is the framework's own"),
            std::string::npos)
      << made.failure();
}

TEST(CourseworkBuilder, ACompilerThatTheMachineKillsIsNoFaultOfTheCoursework) {
  TestCoursework coursework;
  const std::string words = std::filesystem::path(build::kCompiler).filename().string() +
                            ": fatal error: Killed signal terminated program cc1plus\n"
                            "compilation terminated.\n";
  const auto built = [&](const ProcessResult& ending) {
    return buildCoursework(coursework.folder(), Incomplete::kCompileOnly,
                           std::make_shared<EndingConfinement>(ending));
  };
  EXPECT_THROW(built({kKilled, false, 0.0, ""}), std::system_error);
  EXPECT_THROW(built({1, false, 0.0, words}), std::system_error);
  EXPECT_THROW(built({1, false, 0.0, "a warning\n" + words}), std::system_error);
  // Words of the coursework, after its file and line.
  EXPECT_FALSE(built({1, false, 0.0, "part0.cpp:1:2: error: #error " + words}).complete());
  EXPECT_FALSE(built({kKilled, true, 60.0, ""}).complete()) << "stopped at its time limit";
}

TEST(CourseworkBuilder, AnErrorNamesFileAndLineAndGivesNoWorker) {
  TestCoursework coursework;
  coursework.setTracePath("return not_declared;");
  const CourseworkBuild build = buildCoursework(coursework.folder());
  EXPECT_TRUE(build.worker.empty());
  EXPECT_NE(build.failure().find("part5_path.cpp does not compile"), std::string::npos);
  EXPECT_NE(build.failure().find("part5_path.cpp:4:8: error"), std::string::npos)
      << build.failure();
}

TEST(CourseworkBuilder, TheOtherPartsOfABrokenCourseworkCanBeAskedForTheirStubs) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp",
                     "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                     "  PATHMARK_UNIMPLEMENTED(\"part6_roulette.cpp\", "
                     "\"LitScene::RussianRoulette\");\n  return {true, 1.0f};\n}");
  coursework.setFile("part3_lambertian.cpp", "this is not C++");
  const CourseworkBuild build = buildCoursework(coursework.folder(), Incomplete::kLeaveThemOut);
  ASSERT_FALSE(build.worker.empty());
  EXPECT_FALSE(build.complete());
  WorkerProcess::Options options;
  options.program = build.worker;
  EXPECT_EQ(WorkerProcess(std::move(options)).stubs().size(), 1u);
}

TEST(CourseworkBuilder, OnePartIsCompiledWithoutTheOthers) {
  TestCoursework coursework;
  coursework.setFile("part3_lambertian.cpp", "this is not C++");
  const PartBuild broken = compilePart(coursework.folder(), 3);
  EXPECT_FALSE(broken.compiled);
  EXPECT_NE(broken.messages.find("part3_lambertian.cpp:3:1: error"), std::string::npos)
      << broken.messages;
  const PartBuild path = compilePart(coursework.folder(), 5);
  EXPECT_TRUE(path.compiled);
  EXPECT_EQ(path.object,
            buildCoursework(coursework.folder(), Incomplete::kCompileOnly).parts[5].object);
}

TEST(CourseworkBuilder, AMissingFunctionReturnValueIsAnErrorNotAWarning) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler;");
  EXPECT_TRUE(buildCoursework(coursework.folder()).worker.empty());
}

// The byte order marks of little and big endian.
TEST(CourseworkBuilder, AnEncodingThatTheCompilerCannotReadIsNamed) {
  using namespace std::string_literals;
  for (const auto& [start, encoding] : {std::pair{"\xff\xfe/\0"s, "UTF-16"},
                                        {"\xfe\xff\0/"s, "UTF-16"},
                                        {"\xff\xfe\0\0/\0\0\0"s, "UTF-32"},
                                        {"\0\0\xfe\xff\0\0\0/"s, "UTF-32"}}) {
    TestCoursework coursework;
    coursework.write("part5_path.cpp", start);
    const PartBuild part = compilePart(coursework.folder(), 5);
    EXPECT_FALSE(part.compiled);
    EXPECT_TRUE(part.failure().ends_with("part5_path.cpp does not compile: it is saved as "s +
                                         encoding + "; save it as UTF-8."))
        << part.failure();
  }
}

TEST(CourseworkBuilder, AMarkOfUtf8IsRead) {
  TestCoursework coursework;
  std::ifstream in(coursework.folder() / "part5_path.cpp");
  const std::string code(std::istreambuf_iterator<char>(in), {});
  coursework.write("part5_path.cpp", "\xef\xbb\xbf" + code);
  EXPECT_TRUE(compilePart(coursework.folder(), 5).compiled);
}

TEST(CourseworkBuilder, AMissingFileIsNamed) {
  TestCoursework coursework;
  std::filesystem::remove(coursework.folder() / "part4_phong.cpp");
  const CourseworkBuild build = buildCoursework(coursework.folder());
  EXPECT_TRUE(build.worker.empty());
  EXPECT_NE(build.failure().find("part4_phong.cpp is missing;"), std::string::npos)
      << build.failure();
  EXPECT_EQ(build.failure().find("compile"), std::string::npos) << build.failure();
}

TEST(CourseworkBuilder, AMissingFileIsNamedBesideTheFilesOfAnotherCoursework) {
  TestCoursework coursework, others;
  std::filesystem::remove(coursework.folder() / "part4_phong.cpp");
  const LinkedWorker linked =
      linkWithOthers(buildCoursework(coursework.folder(), Incomplete::kCompileOnly), std::array{4},
                     buildCoursework(others.folder(), Incomplete::kCompileOnly));
  EXPECT_TRUE(linked.failure.ends_with("part4_phong.cpp is missing.")) << linked.failure;
}

// The solutions of a long run are compiled once, and linked with each submission.
TEST(CourseworkBuilder, ALinkMarksTheObjectsAsUsed) {
  using Clock = std::filesystem::file_time_type::clock;
  TestCoursework coursework, others;
  const CourseworkBuild own = buildCoursework(coursework.folder(), Incomplete::kCompileOnly),
                        solutions = buildCoursework(others.folder(), Incomplete::kCompileOnly);
  const std::filesystem::path object = solutions.parts.at(3).object;
  for (const char* when : {"linked anew", "linked already"}) {
    std::filesystem::last_write_time(object, Clock::now() - std::chrono::hours(2));
    ASSERT_EQ(linkWithOthers(own, std::array{4}, solutions).failure, "");
    EXPECT_GT(std::filesystem::last_write_time(object), Clock::now() - std::chrono::hours(1))
        << when;
  }
}

TEST(CourseworkBuilder, AWorkerThatIsStartedIsMarkedAsUsed) {
  using Clock = std::filesystem::file_time_type::clock;
  TestCoursework coursework;
  const std::filesystem::path program = buildCoursework(coursework.folder()).worker;
  std::filesystem::last_write_time(program.parent_path(), Clock::now() - std::chrono::hours(2));
  WorkerProcess::Options options;
  options.program = program;
  const WorkerProcess worker(options);
  EXPECT_GT(std::filesystem::last_write_time(program.parent_path()),
            Clock::now() - std::chrono::hours(1));
}

TEST(CourseworkBuilder, AFunctionThatIsNotThereIsNamed) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp", "");
  const CourseworkBuild build = buildCoursework(coursework.folder());
  EXPECT_TRUE(build.worker.empty());
  EXPECT_NE(build.failure().find("RussianRoulette"), std::string::npos) << build.failure();
}

// A helper file would vanish when the coursework is marked.
TEST(CourseworkBuilder, OtherFilesOfTheFolderCannotBeIncluded) {
  TestCoursework coursework;
  coursework.write("helper.h", "");
  coursework.setFile("part6_roulette.cpp", "}\n#include \"helper.h\"\nnamespace pathmark {");
  EXPECT_NE(buildCoursework(coursework.folder()).failure().find("helper.h"), std::string::npos);
}

// The names of helpers belong to their file alone: two parts may use the same, and a function
// named like one of the C library or of the framework replaces nothing.
TEST(CourseworkBuilder, HelpersOfTheSameNameDoNotClash) {
  TestCoursework coursework;
  coursework.setFile(
      "part6_roulette.cpp",
      "float helper() { return 1.0f; }\n"
      "struct Helper { virtual ~Helper() = default; virtual float f() { return 1; } };\n"
      "template <class T> T shared() { return T(0.25); }\n"
      "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
      "  Helper h; return {true, helper() * h.f() * shared<float>()};\n}");
  coursework.setFile(
      "part5_path.cpp",
      "float helper() { return 2.0f; }\n"
      "struct Helper { virtual ~Helper() = default; virtual float f() { return 3; } };\n"
      "template <class T> T shared() { return T(0.5); }\n"
      "bool viewScene() { return false; }\n"
      "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
      "  Helper h;\n"
      "  return Colour(helper() * h.f() * shared<float>(),\n"
      "                RussianRoulette(Colour(1), 1, 0).weight, viewScene());\n}\n"
      "}\nextern \"C\" int raise(int) { return 0; }\n"
      "extern \"C\" void* malloc(decltype(sizeof 0)) { return nullptr; }\n"
      "namespace pathmark {");
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(1, 1));
  const std::vector<std::uint32_t> inputs(8, 0);
  const auto words = worker->call(CourseworkFunction::kTracePath, {}, inputs);
  ASSERT_EQ(words.size(), 3u);
  EXPECT_EQ(std::bit_cast<float>(words[0]), 3.0f);
  EXPECT_EQ(std::bit_cast<float>(words[1]), 0.25f);
  EXPECT_EQ(std::bit_cast<float>(words[2]), 0.0f);
}

TEST(CourseworkBuilder, FoldersWithAwkwardNamesWork) {
  TestCoursework coursework;
  const std::filesystem::path awkward = coursework.folder() / "a b \"c\" $d=e";
  std::filesystem::create_directory(awkward);
  for (const PartContract& part : parts())
    std::filesystem::copy_file(coursework.folder() / part.file, awkward / part.file);
  const CourseworkBuild build = buildCoursework(awkward);
  EXPECT_FALSE(build.worker.empty()) << build.failure();
}

TEST(CourseworkOption, NamesTheFolderForACommandInTheProjectsFolder) {
  const std::filesystem::path root = PATHMARK_ROOT;
  EXPECT_EQ(withOption(root / "student"), "");
  EXPECT_EQ(withOption(root / "solutions"), " --with solutions");
  EXPECT_EQ(withOption(root / "mine/part 2"), " --with 'mine/part 2'");
  EXPECT_EQ(withOption("/tmp/student"), " --with /tmp/student");
  EXPECT_EQ(withOption("/tmp/Ana's"), " --with '/tmp/Ana'\\''s'");
}

}  // namespace
}  // namespace pathmark::test
