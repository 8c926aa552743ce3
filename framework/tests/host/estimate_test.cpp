// Means of estimators and the record of a pixel, as the host asks a worker for them; and workers in
// which stand-ins take the place of parts.
#include "host/coursework_builder.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pathmark::test {
namespace {

EstimateRequest pathRequest(std::uint32_t replicates, std::uint64_t rays) {
  EstimateRequest request;
  request.function = static_cast<std::uint32_t>(CourseworkFunction::kTracePath);
  request.replicates = replicates;
  request.calls = 1;
  request.rays = rays;
  request.seed = 7;
  return request;
}

// A ray and the largest number of bounces.
const std::vector<std::uint32_t> kCall(7, 0);

std::unique_ptr<WorkerProcess> startWithScene(TestCoursework& coursework) {
  auto worker = coursework.start();
  worker->loadScene(emptyScene(4, 4));
  return worker;
}

TEST(Estimate, IsTheMeanOverTheRaysOfEachReplicate) {
  TestCoursework coursework;
  const auto estimates = startWithScene(coursework)->estimate(pathRequest(3, 4096), kCall);
  ASSERT_EQ(estimates.size(), 3u);
  for (const Estimate& e : estimates) {
    // 4096 points of a (0,2)-sequence are balanced to 1/4096 in each coordinate.
    EXPECT_NEAR(e.mean[0], 0.5, 1.0 / 4096);
    EXPECT_NEAR(e.mean[1], 0.5, 1.0 / 4096);
    EXPECT_EQ(e.mean[2], 1.0);
    EXPECT_EQ(e.invalid, 0u);
  }
  EXPECT_NE(estimates[0].mean[0], estimates[1].mean[0]) << "replicates are independent";
}

TEST(Estimate, IsTheSameForTheSameSeedOnly) {
  TestCoursework coursework;
  const auto worker = startWithScene(coursework);
  EstimateRequest request = pathRequest(1, 64);
  const double first = worker->estimate(request, kCall).at(0).mean[0];
  EXPECT_EQ(worker->estimate(request, kCall).at(0).mean[0], first);
  request.seed = 8;
  EXPECT_NE(worker->estimate(request, kCall).at(0).mean[0], first);
}

TEST(Estimate, CountsWhatIsNoRadianceAndLeavesItOut) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; const float u = sampler.next1D();\n"
      "if (u < 0.25f) return Colour(std::nanf(\"\"));\n"
      "return u < 0.5f ? Colour(-1.0f) : Colour(2.0f);");
  const auto estimates = startWithScene(coursework)->estimate(pathRequest(1, 1024), kCall);
  EXPECT_EQ(estimates.at(0).invalid, 512u);
  EXPECT_EQ(estimates.at(0).mean[0], 2.0);
}

TEST(Estimate, OfAFunctionThatIsNoEstimatorIsRefused) {
  TestCoursework coursework;
  EstimateRequest request = pathRequest(1, 1);
  request.function = static_cast<std::uint32_t>(CourseworkFunction::kSampleSphere);
  EXPECT_THROW(startWithScene(coursework)->estimate(request, kCall), WorkerError);
}

std::unique_ptr<WorkerProcess> startPart(const TestCoursework& coursework, int part) {
  const CourseworkBuild build = buildCoursework(coursework.folder(), Incomplete::kCompileOnly);
  const LinkedWorker linked = linkWithStandIns(build, std::array{part});
  EXPECT_EQ(linked.failure, "");
  WorkerProcess::Options options;
  options.program = linked.worker;
  options.courseworkFolder = coursework.folder();
  auto worker = std::make_unique<WorkerProcess>(std::move(options));
  worker->loadScene(emptyScene(4, 4));
  return worker;
}

TEST(StandIns, TakeThePlaceOfAllOtherParts) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler; std::abort();");
  const auto worker = startPart(coursework, 1);
  RecordPixelRequest request;
  request.camera[5] = request.camera[6] = request.camera[10] = 1.0f;
  request.rays = 5;
  const RecordedPixel pixel = worker->recordPixel(request);
  EXPECT_EQ(pixel.counts.traced, 5u);
  EXPECT_EQ(pixel.counts.started, 5u);
  EXPECT_EQ(pixel.counts.strayNumbers, 0u);
  ASSERT_EQ(pixel.rays.size(), 5u);
  for (std::size_t m = 0; m < 5; ++m) {
    EXPECT_EQ(pixel.rays[m].startRay, static_cast<int>(m));
    EXPECT_EQ(pixel.rays[m].numbers, 2u);
  }
}

TEST(StandIns, LetAPartBeTriedThoughAnotherDoesNotCompile) {
  TestCoursework coursework;
  coursework.setFile("part4_phong.cpp", "this is no C++");
  EXPECT_TRUE(buildCoursework(coursework.folder()).worker.empty());
  const auto estimates = startPart(coursework, 5)->estimate(pathRequest(1, 16), kCall);
  EXPECT_EQ(estimates.at(0).mean[2], 1.0);
}

TEST(StandIns, LeaveAFunctionThatIsMissingToBeNamed) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp", "");
  const CourseworkBuild build = buildCoursework(coursework.folder(), Incomplete::kCompileOnly);
  const LinkedWorker linked = linkWithStandIns(build, std::array{6});
  EXPECT_TRUE(linked.worker.empty());
  EXPECT_NE(linked.failure.find("LitScene::RussianRoulette"), std::string::npos) << linked.failure;
}

TEST(StandIns, RecordNoMoreRaysThanAFewTooMany) {
  TestCoursework coursework;
  coursework.setFile("part1_stratified.cpp", R"(
Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float, float) const { return {}; }
Colour LitScene::renderPixel(int, int, const SimpleCamera&, int, Sampler& sampler) const {
  for (int m = 0; m < 100000; ++m) tracePath(Ray{}, sampler);
  return Colour(1.0f);
}
)");
  const auto worker = startPart(coursework, 1);
  RecordPixelRequest request;
  request.rays = 4;
  const RecordedPixel pixel = worker->recordPixel(request);
  EXPECT_EQ(pixel.counts.traced, 100000u);
  EXPECT_EQ(pixel.rays.size(), 4u + kExtraRecordedRays);
  EXPECT_EQ(pixel.rays[0].startRay, -1);
}

}  // namespace
}  // namespace pathmark::test
