// Whatever coursework does wrong is told in a sentence that names function, file and line; the
// worker is gone afterwards, and the host goes on.
#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "host/render_loop.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

namespace pathmark::test {
namespace {

WorkerLimits shortLimits() {
  WorkerLimits limits;
  limits.secondsWithoutAnswer = 1.0;
  return limits;
}

struct Failure {
  WorkerFault fault = WorkerFault::kNonsense;
  std::string sentence;
};

RenderedImage renderWith(WorkerProcess& worker, int size = 32, std::uint32_t threads = 2) {
  worker.loadScene(emptyScene(size, size));
  RenderSettings settings;
  settings.width = settings.height = size;
  settings.raysPerPixel = 4;
  settings.threads = threads;
  return renderImage(worker, settings, [](const RenderStatus&) { return true; });
}

Failure failureOf(TestCoursework& coursework, const WorkerLimits& limits = shortLimits()) {
  const auto worker = coursework.start(limits);
  const pid_t pid = worker->pid();
  try {
    renderWith(*worker);
  } catch (const WorkerError& e) {
    EXPECT_NE(kill(pid, 0), 0) << "the worker is still there";
    return {e.fault(), e.what()};
  }
  ADD_FAILURE() << "nothing was reported";
  return {};
}

void expectContains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

// ThreadSanitizer holds signals back until the next call into its library, which an endless loop
// without calls never makes: then the place cannot be known.
void expectPlaceOfLoop(const std::string& sentence, const std::string& place) {
  if (build::kSanitizers != "thread") expectContains(sentence, place);
}

TEST(WorkerFault, SegmentationFaultNamesFunctionFileAndLine) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray;\nif (sampler.next1D() < 0.01f)\n  *(volatile int*)16 = 1;"
      "\nreturn Colour(0.0f);");
  const Failure failure = failureOf(coursework);
  EXPECT_EQ(failure.fault, WorkerFault::kCrashed);
  expectContains(failure.sentence, "part5_path.cpp:6, in LitScene::tracePath");
  expectContains(failure.sentence, "SIGSEGV");
}

TEST(WorkerFault, ACrashNamesItsCallersAndTheFilesOfThoseInOthers) {
  TestCoursework coursework;
  coursework.write("part5_path.cpp",
                   "#include <pathmark/coursework.h>\nnamespace pathmark {\n"
                   "[[gnu::noinline]] static float helper(float x) {\n"
                   "  *(volatile float*)16 = x;\n  return x + 1.0f;\n}\n"
                   "Colour LitScene::tracePath(const Ray&, Sampler& sampler) const {\n"
                   "  return Colour(helper(sampler.next1D()) + 1.0f);\n}\n}\n");
  const std::string sentence = failureOf(coursework).sentence;
  expectContains(sentence,
                 "part5_path.cpp:4, in helper, called from LitScene::tracePath (line 8), "
                 "called from LitScene::renderPixel (");
  expectContains(sentence, "part1_stratified.cpp, line ");
  expectContains(sentence, "): a segmentation fault (SIGSEGV)");
}

TEST(WorkerFault, EndlessLoopIsStoppedAndNamesItsLine) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp",
                     "Roulette LitScene::RussianRoulette(const Colour&, int, float u) const {\n"
                     "  volatile float x = u;\n"
                     "  while (x < 2.0f) x = u;\n"
                     "  return {true, x};\n}");
  coursework.setTracePath(
      "(void)ray; return Colour(RussianRoulette(Colour(1.0f), 1, "
      "sampler.next1D()).weight);");
  const Failure failure = failureOf(coursework);
  EXPECT_EQ(failure.fault, WorkerFault::kTimeLimit);
  expectPlaceOfLoop(failure.sentence, "part6_roulette.cpp:5, in LitScene::RussianRoulette");
  expectContains(failure.sentence, "no answer for 1 s");
}

TEST(WorkerFault, OneLoopingThreadIsNoticedWhileOthersWork) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)sampler;\nvolatile float x = ray.direction.x;\n"
      "if (x < -0.55f) while (x < 2.0f) {}\nreturn Colour(0.0f);");
  EXPECT_EQ(failureOf(coursework).fault, WorkerFault::kTimeLimit);
}

TEST(WorkerFault, StackOverflowIsNamed) {
  TestCoursework coursework;
  coursework.setTracePath(
      "volatile float big[100] = {sampler.next1D()};\n"
      "return tracePath(ray, sampler) + big[7];");
  const Failure failure = failureOf(coursework);
  EXPECT_EQ(failure.fault, WorkerFault::kCrashed);
  expectContains(failure.sentence, "in LitScene::tracePath");
  expectContains(failure.sentence, ": stack overflow");
}

TEST(WorkerFault, ExceptionIsReportedWithWhatItSays) {
  TestCoursework coursework;
  coursework.write("part5_path.cpp",
                   "#include <pathmark/coursework.h>\n#include <stdexcept>\nnamespace pathmark {\n"
                   "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                   "  throw std::out_of_range(\"no such light\");\n}\n}\n");
  const Failure failure = failureOf(coursework);
  EXPECT_EQ(failure.fault, WorkerFault::kCrashed);
  expectContains(failure.sentence, "part5_path.cpp:5");
  expectContains(failure.sentence, "std::out_of_range: no such light");
}

TEST(WorkerFault, AbortIsNamed) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler; std::abort();");
  expectContains(failureOf(coursework).sentence, "SIGABRT");
}

TEST(WorkerFault, ExitIsNamed) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler;\nstd::exit(0);");
  const Failure failure = failureOf(coursework);
  expectContains(failure.sentence, "part5_path.cpp:5, in LitScene::tracePath");
  expectContains(failure.sentence, ": exit() was called");
}

TEST(WorkerFault, ExitInManyThreadsAtOnceIsNamed) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler;\nstd::exit(0);");
  for (int run = 0; run < 20; ++run) {
    const auto worker = coursework.start(shortLimits());
    try {
      renderWith(*worker);
      FAIL() << "nothing was reported";
    } catch (const WorkerError& e) {
      expectContains(e.what(), "part5_path.cpp:5, in LitScene::tracePath");
      expectContains(e.what(), ": exit() was called");
    }
  }
}

TEST(WorkerFault, QuickExitIsNotMistakenForAnAnswer) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler; std::_Exit(0);");
  const Failure failure = failureOf(coursework);
  EXPECT_EQ(failure.fault, WorkerFault::kEnded);
  expectContains(failure.sentence, "ended by itself with exit code 0");
}

TEST(WorkerFault, PrintingWithoutEndIsStopped) {
  TestCoursework coursework;
  coursework.write("part5_path.cpp",
                   "#include <pathmark/coursework.h>\n#include <cstdio>\nnamespace pathmark {\n"
                   "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                   "  for (int i = 0; i < 1000; ++i) std::puts(\"a line of debugging output\");\n"
                   "  return Colour(0.0f);\n}\n}\n");
  EXPECT_EQ(failureOf(coursework).fault, WorkerFault::kOutputLimit);
}

TEST(WorkerFault, EndlessAllocationEndsInASentence) {
  TestCoursework coursework;
  coursework.write("part5_path.cpp",
                   "#include <pathmark/coursework.h>\n#include <vector>\nnamespace pathmark {\n"
                   "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                   "  std::vector<float> v(std::size_t(1) << 42);\n"
                   "  return Colour(v[12345]);\n}\n}\n");
  const Failure failure = failureOf(coursework);
  // AddressSanitizer ends the program itself where operator new would throw.
  EXPECT_EQ(failure.fault, build::kSanitized ? WorkerFault::kEnded : WorkerFault::kMemoryLimit);
  if (!build::kSanitized) expectContains(failure.sentence, "memory ran out");
}

// Then there is no memory left for whoever is to report it either.
TEST(WorkerFault, MemoryThatIsTakenBitByBitEndsInASentence) {
  if (build::kSanitized) GTEST_SKIP() << "sanitizers need more address space than can be limited";
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; (void)sampler;\nstruct Link { Link* next; float numbers[30]; };\n"
      "Link* volatile chain = nullptr;\nfor (;;) chain = new Link{chain, {1.0f}};\n"
      "return Colour(chain->numbers[0]);");
  WorkerLimits limits;
  limits.memoryBytes = std::size_t{512} << 20;
  const Failure failure = failureOf(coursework, limits);
  EXPECT_EQ(failure.fault, WorkerFault::kMemoryLimit);
  expectContains(failure.sentence, "part5_path.cpp:7, in LitScene::tracePath");
  expectContains(failure.sentence, ": memory ran out");
  expectContains(failure.sentence, "allowed are 512 MiB");
}

TEST(WorkerFault, AWorkerThatTheSystemKillsIsSaidToLackMemory) {
  TestCoursework coursework;
  coursework.write("part5_path.cpp",
                   "#include <pathmark/coursework.h>\n#include <csignal>\nnamespace pathmark {\n"
                   "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                   "  return Colour(static_cast<float>(std::raise(SIGKILL)));\n}\n}\n");
  const Failure failure = failureOf(coursework);
  EXPECT_EQ(failure.fault, WorkerFault::kMemoryLimit);
  expectContains(failure.sentence, "short of memory; does an array grow without end?");
}

std::string wordOf(pid_t process, const std::string& file, const std::string& before) {
  std::ifstream in("/proc/" + std::to_string(process) + "/" + file);
  std::string text(std::istreambuf_iterator<char>(in), {});
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return text;
  const std::size_t begin = text.find_first_not_of(' ', at + before.size());
  return text.substr(begin, text.find_first_of(" \n", begin) - begin);
}

TEST(WorkerFault, AWorkerMayHaveHalfOfTheMemoryAndIsKilledFirst) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  EXPECT_EQ(wordOf(worker->pid(), "oom_score_adj", ""), "1000");
  if (build::kSanitized) GTEST_SKIP() << "sanitizers need more address space than can be limited";
  const auto all = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                   static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE));
  const std::uint64_t allowed = std::stoull(wordOf(worker->pid(), "limits", "Max address space"));
  EXPECT_LE(allowed, std::max(all / 2, std::uint64_t{1} << 30));
  EXPECT_EQ(allowed, WorkerLimits{}.memoryBytes);
}

TEST(WorkerFault, LoopBeforeMainIsStopped) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp",
                     "static int spin() { volatile int i = 0; while (i == 0) {} return i; }\n"
                     "int spun = spin();\n"
                     "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                     "  return {true, 1.0f};\n}");
  try {
    coursework.start(shortLimits());
    FAIL() << "nothing was reported";
  } catch (const WorkerError& e) {
    EXPECT_EQ(e.fault(), WorkerFault::kTimeLimit);
  }
}

TEST(WorkerFault, ScribblingOnTheWireIsNonsense) {
  TestCoursework coursework;
  coursework.write("part5_path.cpp",
                   "#include <pathmark/coursework.h>\n#include <unistd.h>\nnamespace pathmark {\n"
                   "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                   "  const char text[64] = \"nonsense\";\n"
                   "  return Colour(static_cast<float>(write(3, text, sizeof text)));\n}\n}\n");
  EXPECT_EQ(failureOf(coursework).fault, WorkerFault::kNonsense);
}

// Coursework that looks for the shared film and overwrites a page of it, while most pixels are
// done, with a byte.
void scribble(TestCoursework& coursework, const std::string& byte) {
  coursework.write("part5_path.cpp",
                   "#include <pathmark/coursework.h>\n#include <atomic>\n#include <cstdio>\n"
                   "#include <cstring>\nnamespace pathmark {\n"
                   "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                   "  static std::atomic<int> calls{0};\n"
                   "  if (++calls != 4096) return Colour(0.5f);\n"
                   "  std::FILE* maps = std::fopen(\"/proc/self/maps\", \"r\");\n"
                   "  char line[512];\n"
                   "  while (std::fgets(line, sizeof line, maps)) {\n"
                   "    unsigned long begin = 0, end = 0;\n"
                   "    if (std::strstr(line, \"pathmark-film\") &&\n"
                   "        std::sscanf(line, \"%lx-%lx\", &begin, &end) == 2)\n"
                   "      std::memset(reinterpret_cast<char*>(end) - 4 * 4096, " +
                       byte +
                       ", 4096);\n"
                       "  }\n"
                       "  return Colour(0.5f);\n}\n}\n");
}

TEST(WorkerFault, ScribblingOnTheFilmIsNonsense) {
  for (const char* byte : {"0xff", "0x00", "0x11"}) {
    SCOPED_TRACE(byte);
    TestCoursework coursework;
    scribble(coursework, byte);
    EXPECT_EQ(failureOf(coursework).fault, WorkerFault::kNonsense);
  }
}

TEST(WorkerFault, InvalidRadianceIsCountedLocatedAndKeptOutOfTheImage) {
  TestCoursework coursework;
  coursework.setFile(
      "part1_stratified.cpp",
      "Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float,\n"
      "                                      float) const { return {}; }\n"
      "Colour LitScene::renderPixel(int i, int j, const SimpleCamera&, int,\n"
      "                             Sampler&) const {\n"
      "  if (j == 3 && i >= 5) return Colour(0.5f, std::sqrt(-1.0f - i * i), 0.5f);\n"
      "  if (j == 7 && i == 2) return Colour(1.0f / static_cast<float>(i - 2));\n"
      "  if (j == 9 && i == 4) return Colour(-0.25f);\n"
      "  return Colour(0.5f);\n}");
  const auto worker = coursework.start();
  const RenderedImage rendered = renderWith(*worker, 16);
  EXPECT_EQ(rendered.invalid.nan, 11u);
  EXPECT_EQ(rendered.invalid.infinite, 1u);
  EXPECT_EQ(rendered.invalid.negative, 1u);
  EXPECT_EQ(rendered.invalid.firstPixel, 3u * 16u + 5u);
  for (const float value : rendered.image.rgb) EXPECT_TRUE(value == 0.0f || value == 0.5f);
  EXPECT_EQ(rendered.image.invalid[3 * 16 + 5], 1);
  EXPECT_EQ(rendered.image.invalid[0], 0);
}

TEST(WorkerFault, ACallThatNeverReturnsIsStopped) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp",
                     "Roulette LitScene::RussianRoulette(const Colour&, int, float u) const {\n"
                     "  volatile float x = u;\n  while (x < 2.0f) x = u;\n  return {true, x};\n}");
  const auto worker = coursework.start(shortLimits());
  worker->loadScene(emptyScene(4, 4));
  const std::vector<std::uint32_t> inputs(5, 0);
  try {
    worker->call(CourseworkFunction::kRussianRoulette, {}, inputs);
    FAIL() << "nothing was reported";
  } catch (const WorkerError& e) {
    EXPECT_EQ(e.fault(), WorkerFault::kTimeLimit);
    expectPlaceOfLoop(e.what(), "part6_roulette.cpp:5");
  }
}

TEST(WorkerFault, AnObjectThatDoesNotFitTheFunctionIsRefused) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  const std::vector<std::uint32_t> inputs(2, 0), object(3, 0);
  EXPECT_THROW(worker->call(CourseworkFunction::kPolygonSampling, object, inputs), WorkerError);
}

TEST(WorkerFault, ASceneFunctionWithoutASceneIsRefused) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  const std::vector<std::uint32_t> inputs(8, 0);
  EXPECT_THROW(worker->call(CourseworkFunction::kTracePath, {}, inputs), WorkerError);
}

// Who no longer wants the answer does not wait for the time limit, and blames nobody.
TEST(WorkerFault, AWorkerThatGivesNoAnswerCanBeStopped) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp",
                     "Roulette LitScene::RussianRoulette(const Colour&, int, float u) const {\n"
                     "  volatile float x = u;\n"
                     "  while (x < 2.0f) x = u;\n"
                     "  return {true, x};\n}");
  const CourseworkBuild build = buildCoursework(coursework.folder());
  ASSERT_FALSE(build.worker.empty()) << build.failure();
  WorkerProcess::Options options;
  options.program = build.worker;
  options.limits.secondsWithoutAnswer = 1000.0;
  int asked = 0;
  bool calling = false;
  options.goOn = [&] { return !calling || ++asked < 3; };
  WorkerProcess worker(std::move(options));
  worker.loadScene(emptyScene(4, 4));
  const pid_t pid = worker.pid();
  const std::vector<std::uint32_t> call(
      contractOf(CourseworkFunction::kRussianRoulette).inputWords);
  calling = true;
  EXPECT_THROW(worker.call(CourseworkFunction::kRussianRoulette, {}, call), WorkerStopped);
  EXPECT_EQ(asked, 3);
  EXPECT_NE(kill(pid, 0), 0) << "the worker is still there";
}

}  // namespace
}  // namespace pathmark::test
