// Paths that are recorded for the window, of coursework that does what it should and of some that
// does not.
#include "preview/paths/path_engine.h"

#include "host/session.h"
#include "support/background_program.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

namespace pathmark::preview {
namespace {

using test::emptyScene;
using test::TestCoursework;

constexpr int kSide = 8;

std::shared_ptr<const PreviewScene> previewSceneOf(LoadedScene loaded) {
  auto scene = std::make_shared<PreviewScene>();
  scene->loaded = std::move(loaded);
  scene->hash = sceneHash(scene->loaded);
  return scene;
}

std::shared_ptr<const CourseworkState> build(const TestCoursework& coursework,
                                             std::uint64_t number = 1) {
  auto state = std::make_shared<CourseworkState>();
  state->build = std::make_shared<CourseworkBuild>(buildCoursework(coursework.folder()));
  state->number = number;
  if (!state->build->worker.empty()) {
    WorkerProcess::Options options;
    options.program = state->build->worker;
    state->stubs = makeStubReport(WorkerProcess(std::move(options)).stubs());
  }
  return state;
}

class PathEngineTest : public testing::Test {
 protected:
  PathEngineTest() {
    LoadedScene loaded;
    loaded.flat = emptyScene(kSide, kSide);
    request_.scene = previewSceneOf(std::move(loaded));
    request_.camera = request_.scene->loaded.flat.camera;
    request_.column = 3;
    request_.row = 5;
  }

  std::shared_ptr<const PathAnswer> answerTo(const TestCoursework& coursework) {
    request_.coursework = build(coursework, ++builds_);
    return answerToRequest();
  }

  std::shared_ptr<const PathAnswer> answerToRequest() {
    std::promise<void> answered;
    engine_.ask(request_, [&] { answered.set_value(); });
    answered.get_future().wait();
    EXPECT_FALSE(engine_.working());
    return engine_.answer();
  }

  PathRequest request_;
  PathEngine engine_;
  std::uint64_t builds_ = 0;
};

TEST_F(PathEngineTest, HasTheFirstRaysOfThePixelOutOfWholePasses) {
  TestCoursework coursework;
  request_.rays = 10;
  const auto ten = answerTo(coursework);
  EXPECT_EQ(ten->failure, "");
  ASSERT_EQ(ten->paths.size(), 10u);
  EXPECT_EQ(ten->accounts.size(), 10u);
  EXPECT_EQ(ten->pixelRays, 64u);
  EXPECT_EQ(ten->remark, "");
  request_.rays = 65;
  const auto more = answerToRequest();
  ASSERT_EQ(more->paths.size(), 65u);
  EXPECT_EQ(more->pixelRays, 128u);
  for (std::size_t m = 0; m < 10; ++m) EXPECT_EQ(ten->paths[m].radiance, more->paths[m].radiance);
  request_.column = 4;
  EXPECT_NE(answerToRequest()->paths[0].radiance, more->paths[0].radiance);
}

TEST_F(PathEngineTest, SeesThePixelThroughTheCameraOfTheRequest) {
  TestCoursework coursework;
  request_.camera.eye = {7.0f, 8.0f, 9.0f};
  EXPECT_EQ(answerTo(coursework)->paths[0].camera.origin, Point(7.0f, 8.0f, 9.0f));
  request_.camera.eye = {1.0f, 2.0f, 3.0f};
  EXPECT_EQ(answerToRequest()->paths[0].camera.origin, Point(1.0f, 2.0f, 3.0f));
}

TEST_F(PathEngineTest, ACrashIsASentenceAndTheNextBuildIsRecorded) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; (void)sampler;\nvolatile int k = 0;\n*(volatile int*)16 = k;\nreturn {};");
  const auto crashed = answerTo(coursework);
  EXPECT_NE(crashed->failure.find("part5_path.cpp:6, in LitScene::tracePath"), std::string::npos)
      << crashed->failure;
  EXPECT_TRUE(crashed->paths.empty());
  coursework.setTracePath("(void)ray; (void)sampler; return Colour(0.5f);");
  const auto mended = answerTo(coursework);
  EXPECT_EQ(mended->failure, "");
  EXPECT_EQ(mended->paths.size(), 64u);
}

TEST_F(PathEngineTest, AnEndlessLoopIsASentence) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; (void)sampler;\nvolatile int k = 0;\nfor (;;) k = 1;\nreturn {};");
  const std::string failure = answerTo(coursework)->failure;
  EXPECT_NE(failure.find("part5_path.cpp:6, in LitScene::tracePath"), std::string::npos) << failure;
}

TEST_F(PathEngineTest, AnswersWhatIsAskedLastThoughTheCodeBeforeHangs) {
  TestCoursework coursework;
  request_.coursework = build(coursework, 2);
  PathRequest hanging = request_;
  coursework.setTracePath("(void)ray; (void)sampler; for (volatile int k = 0;;) k = 1;");
  hanging.coursework = build(coursework, 1);
  engine_.ask(hanging, [] { ADD_FAILURE() << "there is no answer to that"; });
  EXPECT_TRUE(engine_.working());
  EXPECT_EQ(answerToRequest()->paths.size(), 64u);
}

TEST_F(PathEngineTest, SaysWhichFunctionIsNotWritten) {
  TestCoursework coursework;
  coursework.setFile("part1_stratified.cpp", R"(
Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float, float) const { return {}; }
Colour LitScene::renderPixel(int, int, const SimpleCamera&, int, Sampler&) const {
  PATHMARK_UNIMPLEMENTED("part1_stratified.cpp", "LitScene::renderPixel");
  return Colour(0.0f);
})");
  EXPECT_EQ(answerTo(coursework)->failure,
            "No paths to see: LitScene::renderPixel (part 1) is not written yet.");
}

std::string part8With(const std::string& tracePathMis) {
  return "float powerHeuristic(float, float) { return 1.0f; }\n"
         "float solidAnglePdf(const Point&, const LightSample&) { return 1.0f; }\n"
         "Colour LitScene::tracePathMIS(const Ray&, Sampler& sampler) const {\n" +
         tracePathMis + "\n}";
}

TEST_F(PathEngineTest, OfPart8HasThePathsOfTracePathMis) {
  TestCoursework coursework;
  coursework.setFile("part8_mis.cpp", part8With("return Colour(sampler.next1D());"));
  coursework.setTracePath("(void)ray; (void)sampler; return Colour(2.0f);");
  request_.made = pictureOfPart(8);
  request_.rays = 10;
  const auto answer = answerTo(coursework);
  EXPECT_EQ(answer->failure, "");
  EXPECT_EQ(answer->remark, "");
  ASSERT_EQ(answer->paths.size(), 10u);
  for (const TracedPath& path : answer->paths) EXPECT_LT(path.radiance.r, 1.0f);
  EXPECT_NE(answer->paths[0].radiance, answer->paths[1].radiance);
}

TEST_F(PathEngineTest, OfPart8SaysIfTracePathMisIsNotWritten) {
  TestCoursework coursework;
  coursework.setFile("part8_mis.cpp",
                     part8With("(void)sampler;\n"
                               "PATHMARK_UNIMPLEMENTED(\"part8_mis.cpp\", "
                               "\"LitScene::tracePathMIS\");\nreturn Colour(0.0f);"));
  request_.made = pictureOfPart(8);
  EXPECT_EQ(answerTo(coursework)->failure,
            "No paths to see: LitScene::tracePathMIS (part 8) is not written yet.");
}

TEST_F(PathEngineTest, OfCodeThatDoesNotCompileSaysSo) {
  TestCoursework coursework;
  coursework.setFile("part5_path.cpp", "this is no C++");
  EXPECT_EQ(answerTo(coursework)->failure, "The paths can be seen when the coursework compiles.");
}

TEST_F(PathEngineTest, RemarksOnARenderPixelThatReturnsAnotherMean) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler; return Colour(0.5f);");
  EXPECT_EQ(answerTo(coursework)->remark, "");
  coursework.setFile("part1_stratified.cpp", R"(
Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float, float) const { return {}; }
Colour LitScene::renderPixel(int, int, const SimpleCamera&, int n, Sampler& sampler) const {
  Colour sum(0.0f);
  for (int m = 0; m < n; ++m) sum += tracePath(Ray{}, sampler);
  return sum / 16.0f;
})");
  EXPECT_EQ(answerTo(coursework)->remark,
            "renderPixel returned 2, but the mean of its 64 paths is 0.5.");
}

TEST_F(PathEngineTest, RemarksOnCodeThatTracesOtherPathsEachTime) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; (void)sampler; static int calls = 0; return "
      "Colour(static_cast<float>(++calls));");
  const std::string remark = answerTo(coursework)->remark;
  EXPECT_NE(remark.find("The same rays gave 32.5, and 96.5 when"), std::string::npos) << remark;
}

TEST_F(PathEngineTest, ForgetsWhenAsked) {
  TestCoursework coursework;
  EXPECT_NE(answerTo(coursework), nullptr);
  engine_.forget();
  EXPECT_EQ(engine_.answer(), nullptr);
  EXPECT_NE(answerToRequest(), nullptr);
}

TEST_F(PathEngineTest, WakesForAnswersOnly) {
  TestCoursework coursework;
  request_.coursework = build(coursework);
  std::atomic<int> woken = 0;
  engine_.ask(request_, [&] { ++woken; });
  EXPECT_TRUE(test::waitFor([&] { return woken == 1; }));
  engine_.forget();
  EXPECT_TRUE(test::waitFor([&] { return !engine_.working(); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // what comes after the work
  EXPECT_EQ(woken, 1);
}

}  // namespace
}  // namespace pathmark::preview
