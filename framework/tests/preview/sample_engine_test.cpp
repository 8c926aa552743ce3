// Whatever coursework does, the sample view has samples or a sentence, and goes on with the next
// build.
#include "preview/samples/sample_engine.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

namespace pathmark::preview::test {
namespace {

using F = CourseworkFunction;
using pathmark::test::TestCoursework;

constexpr double kForever = 1e6;  // seconds

WorkerLimits limitsOf(double seconds) {
  WorkerLimits limits;
  limits.secondsWithoutAnswer = seconds;
  return limits;
}

// Part 3 with this reflection.
void setReflection(TestCoursework& coursework, const std::string& body,
                   const std::string& pdf = "return 1.0f;") {
  coursework.setFile(
      "part3_lambertian.cpp",
      "Colour lambertianBRDF::brdf(const Vector&, const Vector&, const Vector&) "
      "const { return Kd; }\n"
      "float lambertianBRDF::pdf(const Vector&, const Vector&, const Vector&) const "
      "{ " +
          pdf +
          " }\n"
          "DirectionSample lambertianBRDF::reflection(const Vector&, const Vector& n, "
          "float s, float, float) const {\n" +
          body + "\n}");
}

// What an engine answers, one request after another.
class Asking {
 public:
  explicit Asking(double secondsWithoutAnswer = 60.0)
      : engine_([this] { arrived(); }, limitsOf(secondsWithoutAnswer)) {}

  void show(const TestCoursework& coursework, F function, std::uint32_t seed = 0) {
    auto state = std::make_shared<CourseworkState>();
    state->build = std::make_shared<const CourseworkBuild>(
        buildCoursework(coursework.folder(), Incomplete::kCompileOnly));
    state->number = ++builds_;
    state_ = state;
    again(function, seed);
  }
  void again(F function, std::uint32_t seed) {
    settings_ = {};
    settings_.function = function;
    settings_.seed = seed;
    engine_.show(state_, settings_);
  }

  // To the newest request.
  SampleAnswer answer() {
    std::unique_lock lock(mutex_);
    std::shared_ptr<const SampleAnswer> newest;
    changed_.wait(lock, [&] {
      newest = engine_.newest();
      return newest && newest->build == builds_ && newest->settings == settings_;
    });
    return *newest;
  }

 private:
  void arrived() {
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t builds_ = 0;
  SampleSettings settings_;
  std::shared_ptr<const CourseworkState> state_;
  SampleEngine engine_;
};

void expectHas(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(SampleEngine, AnUnwrittenFunctionIsToldWhereToRead) {
  TestCoursework coursework;
  setReflection(
      coursework,
      "PATHMARK_UNIMPLEMENTED(\"part3_lambertian.cpp\", \"lambertianBRDF::reflection\");\n"
      "(void)s; return {n, 0.0f};");
  Asking asking;
  asking.show(coursework, F::kLambertianReflection);
  const SampleAnswer answer = asking.answer();
  EXPECT_EQ(answer.kind, SampleAnswer::Kind::kNotWritten);
  EXPECT_EQ(answer.sentence,
            "lambertianBRDF::reflection is not written yet: see handouts/part3_lambertian.md, "
            "section 3.3.");
  EXPECT_FALSE(answer.set.sketch.strokes.empty()) << "the domain is to be seen all the same";
}

TEST(SampleEngine, AnUnwrittenFunctionThatIsCalledIsNamed) {
  TestCoursework coursework;
  setReflection(coursework, "(void)s; return {n, pdf(n, n, n)};",
                "PATHMARK_UNIMPLEMENTED(\"part3_lambertian.cpp\", \"lambertianBRDF::pdf\");\n"
                "return 0.0f;");
  Asking asking;
  asking.show(coursework, F::kLambertianReflection);
  const SampleAnswer answer = asking.answer();
  EXPECT_EQ(answer.kind, SampleAnswer::Kind::kSamples);
  expectHas(answer.note, "lambertianBRDF::pdf is not written yet");
}

TEST(SampleEngine, ACrashIsASentenceAndTheNextBuildHasSamples) {
  TestCoursework coursework;
  setReflection(coursework, "if (s > 0.5f) *(volatile int*)16 = 1;\nreturn {n, 1.0f};");
  Asking asking;
  asking.show(coursework, F::kLambertianReflection);
  const SampleAnswer crashed = asking.answer();
  EXPECT_EQ(crashed.kind, SampleAnswer::Kind::kTrouble);
  expectHas(crashed.sentence, "part3_lambertian.cpp:6, in lambertianBRDF::reflection");

  setReflection(coursework, "(void)s; return {n, 1.0f};");
  asking.show(coursework, F::kLambertianReflection);
  const SampleAnswer mended = asking.answer();
  EXPECT_EQ(mended.kind, SampleAnswer::Kind::kSamples);
  EXPECT_EQ(mended.set.samples.size(), 512u);
  EXPECT_EQ(mended.sentence, "");
}

TEST(SampleEngine, ACrashOfOneFunctionLeavesTheOthers) {
  TestCoursework coursework;
  setReflection(coursework, "if (s > 0.5f) *(volatile int*)16 = 1;\nreturn {n, 1.0f};");
  Asking asking;
  asking.show(coursework, F::kLambertianReflection);
  EXPECT_EQ(asking.answer().kind, SampleAnswer::Kind::kTrouble);
  asking.again(F::kSampleSphere, 0);
  EXPECT_EQ(asking.answer().kind, SampleAnswer::Kind::kSamples);
  asking.again(F::kLambertianReflection, 1);
  expectHas(asking.answer().sentence, "part3_lambertian.cpp:6");
}

TEST(SampleEngine, AnEndlessLoopIsASentence) {
  TestCoursework coursework;
  setReflection(coursework, "volatile float x = s; while (x < 2.0f) x = s;\nreturn {n, x};");
  Asking asking(0.5);
  asking.show(coursework, F::kLambertianReflection);
  const SampleAnswer answer = asking.answer();
  EXPECT_EQ(answer.kind, SampleAnswer::Kind::kTrouble);
  expectHas(answer.sentence, "no answer for 0.5 s, stopped");
}

TEST(SampleEngine, ThePartThatDoesNotCompileIsNamedAndTheOthersHaveSamples) {
  TestCoursework coursework;
  coursework.setFile("part3_lambertian.cpp", "this is no C++");
  Asking asking;
  asking.show(coursework, F::kLambertianReflection);
  const SampleAnswer answer = asking.answer();
  EXPECT_EQ(answer.kind, SampleAnswer::Kind::kTrouble);
  expectHas(answer.sentence, "part3_lambertian.cpp does not compile");
  asking.again(F::kSampleSphere, 0);
  EXPECT_EQ(asking.answer().kind, SampleAnswer::Kind::kSamples);
}

TEST(SampleEngine, AFunctionThatIsNotDefinedIsNamed) {
  TestCoursework coursework;
  coursework.setFile("part3_lambertian.cpp", "");
  Asking asking;
  asking.show(coursework, F::kLambertianReflection);
  expectHas(asking.answer().sentence, "defines no lambertianBRDF::brdf");
}

// If a worker that hangs were waited for, these would never end.
TEST(SampleEngine, AnotherBuildDoesNotWaitForOneThatHangs) {
  TestCoursework hangs, works;
  setReflection(hangs, "volatile float x = s; while (x < 2.0f) x = s;\nreturn {n, x};");
  Asking asking(kForever);
  asking.show(hangs, F::kLambertianReflection);
  asking.show(works, F::kLambertianReflection);
  EXPECT_EQ(asking.answer().kind, SampleAnswer::Kind::kSamples);
}

TEST(SampleEngine, EndsWhileAWorkerHangs) {
  TestCoursework coursework;
  setReflection(coursework, "volatile float x = s; while (x < 2.0f) x = s;\nreturn {n, x};");
  Asking asking(kForever);
  asking.show(coursework, F::kSampleSphere);
  EXPECT_EQ(asking.answer().kind, SampleAnswer::Kind::kSamples);
  asking.again(F::kLambertianReflection, 0);
}

TEST(SampleEngine, OnlyTheNewestOfManyRequestsHasToBeAnswered) {
  const TestCoursework coursework;
  Asking asking;
  asking.show(coursework, F::kSampleSphere);
  for (std::uint32_t seed = 1; seed <= 500; ++seed) asking.again(F::kSampleSphere, seed);
  EXPECT_EQ(asking.answer().settings.seed, 500u);
}

}  // namespace
}  // namespace pathmark::preview::test
