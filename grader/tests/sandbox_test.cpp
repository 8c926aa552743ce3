// The sandbox on every tier: what it lets through, what it stops, and what it says of it.
#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "host/render_loop.h"
#include "sandbox/self_test.h"
#include "support/sandbox_tiers.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include <sys/types.h>

namespace pathmark::test {
namespace {

using sandbox::Tier;

struct Failure {
  std::optional<WorkerFault> fault;
  std::string sentence;
};

class Sandbox : public testing::TestWithParam<Tier> {
 protected:
  CourseworkBuild build() {
    return buildCoursework(coursework_.folder(), Incomplete::kNoWorker, sandboxOf(GetParam()));
  }

  std::unique_ptr<WorkerProcess> start(WorkerLimits limits) {
    const CourseworkBuild made = build();
    if (made.worker.empty()) throw std::runtime_error(made.failure());
    WorkerProcess::Options options;
    options.program = made.worker;
    options.courseworkFolder = made.folder;
    options.confinement = made.confinement;
    options.limits = limits;
    return std::make_unique<WorkerProcess>(std::move(options));
  }

  static WorkerLimits shortLimits() {
    WorkerLimits limits;
    limits.secondsWithoutAnswer = 2.0;
    limits.memoryBytes = std::size_t{2} << 30;
    return limits;
  }

  static RenderedImage render(WorkerProcess& worker) {
    worker.loadScene(emptyScene(8, 8));
    RenderSettings settings;
    settings.width = settings.height = 8;
    settings.raysPerPixel = 4;
    settings.threads = 2;
    return renderImage(worker, settings, [](const RenderStatus&) { return true; });
  }

  // Of a render, with this body of tracePath; line 4 is its first.
  Failure failureOf(const std::string& tracePath) {
    coursework_.setTracePath(tracePath);
    return failure();
  }

  Failure failure() {
    pid_t pid = -1;
    try {
      const auto worker = start(shortLimits());
      pid = worker->pid();
      render(*worker);
    } catch (const WorkerError& e) {
      EXPECT_TRUE(pid < 0 || isGone(pid));
      return {e.fault(), e.what()};
    }
    return {};
  }

  // A killed process may take a moment to go.
  static bool isGone(pid_t pid) {
    for (int k = 0; k < 200; ++k) {
      if (kill(pid, 0) != 0) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  TestCoursework coursework_;
};

INSTANTIATE_TEST_SUITE_P(Tiers, Sandbox, testing::ValuesIn(expectedTiers()),
                         [](const auto& tier) { return std::string(nameOf(tier.param)); });

#define EXPECT_SAYS(failure, words) \
  EXPECT_NE((failure).sentence.find(words), std::string::npos) << (failure).sentence

TEST_P(Sandbox, Holds) { EXPECT_EQ(sandbox::selfTest(*sandboxOf(GetParam())), ""); }

TEST_P(Sandbox, CourseworkIsCompiledLinkedAndRun) {
  const auto worker = start(shortLimits());
  EXPECT_TRUE(worker->stubs().empty());
  const RenderedImage inside = render(*worker);
  const auto plain = coursework_.start();
  EXPECT_EQ(inside.image.rgb, render(*plain).image.rgb);
}

// Embree and its task scheduler look at the machine when they start, which is after the worker's
// lock.
TEST_P(Sandbox, ALargeMeshIsRendered) {
  FlatScene scene = emptyScene(4, 4);
  scene.shapes.emplace_back();
  for (int k = 0; k < 20000; ++k) {
    const float x = 0.01f * static_cast<float>(k);
    scene.addTriangle({Float3{x, 0, -5}, Float3{x + 0.01f, 0, -5}, Float3{x, 1, -5}}, {0, 0, 1}, 0);
  }
  const auto worker = start(shortLimits());
  worker->loadScene(scene);
  SharedFilm film(4, 4);
  RenderJob job;
  job.threads = 2;
  worker->render(job, film, [](const RenderProgress&) { return true; });
}

TEST_P(Sandbox, WhatTheCompilerSaysNamesTheStudentsFile) {
  coursework_.setFile("part6_roulette.cpp", "int wrong = ;\n");
  const std::string failure = build().failure();
  EXPECT_NE(failure.find("part6_roulette.cpp:3:13: error"), std::string::npos) << failure;
  EXPECT_EQ(failure.find("pathmark-sandbox"), std::string::npos) << failure;
}

TEST_P(Sandbox, AFunctionThatIsNotThereIsNamed) {
  coursework_.setFile("part6_roulette.cpp", "");
  const std::string failure = build().failure();
  EXPECT_NE(failure.find("RussianRoulette"), std::string::npos) << failure;
}

TEST_P(Sandbox, ACrashNamesItsLine) {
  const Failure f = failureOf(
      "(void)ray; auto* p = reinterpret_cast<volatile int*>(64); sampler.next1D();\n*p = 1;\n"
      "return Colour(0);");
  EXPECT_EQ(f.fault, WorkerFault::kCrashed);
  EXPECT_SAYS(f, "part5_path.cpp:5");
  EXPECT_SAYS(f, "SIGSEGV");
}

TEST_P(Sandbox, AStackOverflowIsNamed) {
  const Failure f = failureOf("return tracePath(ray, sampler) + Colour(sampler.next1D());");
  EXPECT_EQ(f.fault, WorkerFault::kCrashed);
  EXPECT_SAYS(f, "stack overflow");
}

TEST_P(Sandbox, AnEndlessLoopInAThreadNamesItsLine) {
  const Failure f = failureOf(
      "(void)ray; volatile float x = 0;\nwhile (x < 1) x = 0 * x;\n"
      "return Colour(sampler.next1D());");
  EXPECT_EQ(f.fault, WorkerFault::kTimeLimit);
  EXPECT_SAYS(f, build::kSanitizers != "thread" ? "part5_path.cpp:5" : "no answer");
}

TEST_P(Sandbox, AnEndlessLoopBeforeMainNamesItsLine) {
  coursework_.setFile("part6_roulette.cpp",
                      "static int loop() { volatile int x = 0; while (x < 1) x = 0; return x; }\n"
                      "int start = loop();\n"
                      "Roulette LitScene::RussianRoulette(const Colour&, int, float) const "
                      "{ return {true, 1.0f}; }\n");
  const Failure f = failure();
  EXPECT_EQ(f.fault, WorkerFault::kTimeLimit);
  EXPECT_SAYS(f, build::kSanitizers != "thread" ? "part6_roulette.cpp:3" : "no answer");
}

TEST_P(Sandbox, MemoryWithoutEndIsTheMemoryLimit) {
  if (build::kSanitized) GTEST_SKIP() << "sanitizers need more address space than can be limited";
  const Failure f = failureOf(
      "(void)ray; float kept = sampler.next1D();\n"
      "for (;;) { float* volatile more = new float[1 << 22]; kept += more[0] = 1; }\n"
      "return Colour(kept);");
  EXPECT_EQ(f.fault, WorkerFault::kMemoryLimit) << f.sentence;
}

TEST_P(Sandbox, PrintingWithoutEndIsTheOutputLimit) {
  const Failure f = failureOf(
      "(void)ray; for (;;) __builtin_puts(\"again and again and again\");\n"
      "return Colour(sampler.next1D());");
  EXPECT_EQ(f.fault, WorkerFault::kOutputLimit);
}

TEST_P(Sandbox, AForbiddenCallNamesItselfAndItsLine) {
  if (build::kSanitized) GTEST_SKIP() << "sanitizers open files while the coursework runs";
  coursework_.setFile("part6_roulette.cpp",
                      "}\n#include <fcntl.h>\n#include <unistd.h>\nnamespace pathmark {\n"
                      "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                      "  return {open(\"/etc/passwd\", O_RDONLY) < 0, 1.0f};\n}");
  coursework_.setTracePath(
      "(void)ray; return Colour(RussianRoulette(Colour(1), 1, "
      "sampler.next1D()).weight);");
  const Failure f = failure();
  EXPECT_EQ(f.fault, WorkerFault::kForbiddenCall) << f.sentence;
  EXPECT_SAYS(f, "part6_roulette.cpp:8, in LitScene::RussianRoulette");
  EXPECT_SAYS(f, "openat of \"/etc/passwd\"");
}

TEST_P(Sandbox, EndingTheProgramIsACrashWithItsLine) {
  for (const std::string call : {"std::exit(3)", "std::_Exit(139)", "std::quick_exit(0)"}) {
    const Failure f = failureOf("(void)ray; (void)sampler;\n" + call + ";\nreturn Colour(0);");
    EXPECT_TRUE(f.fault == WorkerFault::kCrashed || f.fault == WorkerFault::kEnded) << call;
    // Sanitizers need calls that the worker else gives up.
    if (!build::kSanitized) {
      EXPECT_SAYS(f, call != "std::quick_exit(0)" ? "part5_path.cpp:5" : "exit");
    }
  }
}

TEST_P(Sandbox, AProgramThatCannotBeStartedIsTheMachinesFault) {
  WorkerProcess::Options options;
  options.program = coursework_.folder() / "nothing";
  options.confinement = sandboxOf(GetParam());
  try {
    WorkerProcess worker(std::move(options));
    ADD_FAILURE() << "it was started";
  } catch (const WorkerError& e) {
    ADD_FAILURE() << "the coursework was blamed: " << e.what();
  } catch (const std::exception&) {
  }
}

TEST_P(Sandbox, WhatIsNoProgramIsTheMachinesFault) {
  coursework_.write("text", "this is no program");
  std::filesystem::permissions(coursework_.folder() / "text", std::filesystem::perms::all);
  WorkerProcess::Options options;
  options.program = coursework_.folder() / "text";
  options.confinement = sandboxOf(GetParam());
  EXPECT_THROW(WorkerProcess worker(std::move(options)), ConfinementError);
}

// Which compiles for a long time, or to something large.
TEST_P(Sandbox, CompileBombsCostTheirPartOnly) {
  sandbox::Limits limits;
  limits.toolSeconds = 3.0;
  limits.fileBytes = std::size_t{16} << 20;
  const auto confinement = sandbox::openSandbox(GetParam(), limits);
  coursework_.setFile(
      "part6_roulette.cpp",
      "template <int N, int M> struct Bomb {\n"
      "  static constexpr int x = Bomb<N - 1, 2 * M>::x + Bomb<N - 1, 2 * M + 1>::x;\n};\n"
      "template <int M> struct Bomb<0, M> { static constexpr int x = M; };\n"
      "int all = Bomb<24, 1>::x;\n");
  coursework_.setFile("part5_path.cpp", "char large[1u << 29] = {1};\n");
  coursework_.setFile("part4_phong.cpp", "}\n#include </dev/zero>\nnamespace pathmark {");
  const CourseworkBuild made =
      buildCoursework(coursework_.folder(), Incomplete::kCompileOnly, confinement);
  for (const int part : {4, 5, 6})
    EXPECT_FALSE(made.parts.at(static_cast<std::size_t>(part)).compiled);
  for (const int part : {0, 1, 2, 3})
    EXPECT_TRUE(made.parts.at(static_cast<std::size_t>(part)).compiled);
}

}  // namespace
}  // namespace pathmark::test
