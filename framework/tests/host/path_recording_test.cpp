// Workers that record paths: they make the same picture, and say what happened on the way.
#include "host/coursework_builder.h"
#include "host/recorded_paths.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>

namespace pathmark::test {
namespace {

constexpr int kSide = 4;

RenderJob onePixel(std::uint64_t rays = 16) {
  RenderJob job;
  job.rays = rays;
  job.raysPerPass = static_cast<std::uint32_t>(rays);
  job.region = {1, 2, 1, 1};
  return job;
}

bool goOn(const RenderProgress&) { return true; }

std::unique_ptr<WorkerProcess> startRecording(const TestCoursework& coursework,
                                              double secondsWithoutAnswer = 10.0) {
  const LinkedWorker linked = linkForRecording(buildCoursework(coursework.folder()));
  EXPECT_EQ(linked.failure, "");
  WorkerProcess::Options options;
  options.program = linked.worker;
  options.courseworkFolder = coursework.folder();
  options.limits.secondsWithoutAnswer = secondsWithoutAnswer;
  auto worker = std::make_unique<WorkerProcess>(std::move(options));
  worker->loadScene(emptyScene(kSide, kSide));
  return worker;
}

std::string failureOf(const TestCoursework& coursework, WorkerFault expected) {
  const auto worker = startRecording(coursework, 1.0);
  SharedFilm film(kSide, kSide);
  try {
    worker->recordPaths(onePixel(), film, goOn);
  } catch (const WorkerError& e) {
    EXPECT_EQ(e.fault(), expected);
    return e.what();
  }
  return {};
}

TEST(PathRecording, TellsOfEachPathAndWhatItReturned) {
  TestCoursework coursework;
  const auto worker = startRecording(coursework);
  SharedFilm film(kSide, kSide);
  const RecordedPaths recorded = worker->recordPaths(onePixel(), film, goOn);
  EXPECT_EQ(recorded.counts.paths, 16u);
  ASSERT_EQ(recorded.events.size(), 32u);
  for (std::size_t m = 0; m < 32; m += 2) {
    EXPECT_EQ(recorded.events[m].kind, PathEventKind::kPath);
    EXPECT_EQ(recorded.events[m + 1].kind, PathEventKind::kRadiance);
    EXPECT_EQ(recorded.events[m + 1].a[2], 1.0f);
  }
}

TEST(PathRecording, IsNotInAWorkerThatDoesNotRecord) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(kSide, kSide));
  SharedFilm film(kSide, kSide);
  EXPECT_THROW(worker->recordPaths(onePixel(), film, goOn), WorkerError);

  const auto mentionsRecorder = [](const std::filesystem::path& program) {
    std::ifstream in(program, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {}).find("PathRecorder") !=
           std::string::npos;
  };
  const CourseworkBuild build = buildCoursework(coursework.folder());
  EXPECT_FALSE(mentionsRecorder(build.worker));
  EXPECT_TRUE(mentionsRecorder(linkForRecording(build).worker));
}

TEST(PathRecording, OfCourseworkThatDoesNotCompileSaysSo) {
  TestCoursework coursework;
  coursework.setFile("part5_path.cpp", "this is no C++");
  const LinkedWorker linked = linkForRecording(buildCoursework(coursework.folder()));
  EXPECT_TRUE(linked.worker.empty());
  EXPECT_NE(linked.failure.find("part5_path.cpp"), std::string::npos) << linked.failure;
}

TEST(PathRecording, KeepsToItsLimitsOnAPathWithoutEnd) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)sampler; Hit hit; for (int k = 0; k < 100000; ++k) intersect(ray, hit);\n"
      "return Colour(0.5f);");
  const auto worker = startRecording(coursework);
  SharedFilm film(kSide, kSide);
  const RecordedPaths recorded = worker->recordPaths(onePixel(100), film, goOn);
  EXPECT_EQ(recorded.counts.paths, 100u);
  EXPECT_LE(recorded.events.size(), kMostPathEvents);
  std::size_t whole = 0;
  for (const PathEvent& event : recorded.events)
    if (event.kind == PathEventKind::kRadiance) {
      EXPECT_GT(event.integer, 0);
      EXPECT_EQ(event.a[0], 0.5f);
      ++whole;
    }
  EXPECT_EQ(whole, kMostPathEvents / kMostEventsOfAPath);
  EXPECT_EQ(film.pixels()[2 * kSide + 1].sum[0], 50.0);
}

TEST(PathRecording, NamesTheLineOfACrash) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; (void)sampler;\nvolatile int k = 0;\n*(volatile int*)16 = k;\nreturn {};");
  const std::string failure = failureOf(coursework, WorkerFault::kCrashed);
  EXPECT_NE(failure.find("part5_path.cpp:6, in LitScene::tracePath"), std::string::npos) << failure;
}

TEST(PathRecording, NamesTheLineOfAnEndlessLoop) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; (void)sampler;\nvolatile unsigned k = 0;\nfor (;;) k = k + 1;\nreturn {};");
  const std::string failure = failureOf(coursework, WorkerFault::kTimeLimit);
  EXPECT_NE(failure.find("part5_path.cpp:6, in LitScene::tracePath"), std::string::npos) << failure;
}

// NaN is what somebody looks for who records a path.
TEST(PathRecording, LetsNumbersThatAreNoneThrough) {
  TestCoursework coursework;
  coursework.setTracePath("(void)ray; (void)sampler; return Colour(std::nanf(\"\"));");
  const auto worker = startRecording(coursework);
  SharedFilm film(kSide, kSide);
  const RecordedPaths recorded = worker->recordPaths(onePixel(4), film, goOn);
  EXPECT_EQ(recorded.counts.result.invalid.nan, 1u);
  EXPECT_TRUE(std::isnan(recorded.events.back().a[0]));
}

class RecordedPathsReply : public testing::Test {
 protected:
  static PathEvent event(PathEventKind kind) {
    PathEvent e;
    e.kind = kind;
    return e;
  }

  static std::vector<std::byte> reply(std::uint64_t paths, const std::vector<PathEvent>& events) {
    pathmark::RecordPathsReply head;
    head.paths = paths;
    std::vector<std::byte> bytes(sizeof head + events.size() * sizeof(PathEvent));
    std::memcpy(bytes.data(), &head, sizeof head);
    if (!events.empty())
      std::memcpy(bytes.data() + sizeof head, events.data(), events.size() * sizeof(PathEvent));
    return bytes;
  }

  static bool believed(std::uint64_t paths, const std::vector<PathEvent>& events) {
    return readRecordedPaths(reply(paths, events)).has_value();
  }

  const PathEvent begin_ = event(PathEventKind::kPath), end_ = event(PathEventKind::kRadiance),
                  hit_ = event(PathEventKind::kHit);
};

TEST_F(RecordedPathsReply, IsBelievedIfItHasWholePathsOnly) {
  EXPECT_TRUE(believed(0, {}));
  EXPECT_TRUE(believed(2, {begin_, end_, begin_, hit_, end_}));
  EXPECT_TRUE(believed(3, {begin_, end_})) << "there was no room for the others";
  EXPECT_FALSE(believed(1, {begin_, hit_})) << "without an end";
  EXPECT_FALSE(believed(1, {hit_, end_})) << "without a beginning";
  EXPECT_FALSE(believed(2, {begin_, begin_, end_, end_})) << "one within another";
  EXPECT_FALSE(believed(1, {begin_, end_, hit_})) << "something behind the last";
  EXPECT_FALSE(believed(1, {begin_, end_, begin_, end_})) << "more than have begun";
}

TEST_F(RecordedPathsReply, IsRefusedIfItIsCutOff) {
  std::vector<std::byte> bytes = reply(1, {begin_, end_});
  EXPECT_TRUE(readRecordedPaths(bytes));
  bytes.pop_back();
  EXPECT_FALSE(readRecordedPaths(bytes));
  bytes.resize(sizeof(pathmark::RecordPathsReply) - 1);
  EXPECT_FALSE(readRecordedPaths(bytes));
  EXPECT_FALSE(readRecordedPaths({}));
}

TEST_F(RecordedPathsReply, IsRefusedWithWhatCannotHaveHappened) {
  const auto with = [&](auto change) {
    PathEvent changed = hit_;
    change(changed);
    return believed(1, {begin_, changed, end_});
  };
  EXPECT_FALSE(with([](PathEvent& e) { e.kind = static_cast<PathEventKind>(0); }));
  EXPECT_FALSE(with([](PathEvent& e) { e.kind = static_cast<PathEventKind>(14); }));
  EXPECT_FALSE(with([](PathEvent& e) { e.kind = static_cast<PathEventKind>(0xffffffffu); }));
  EXPECT_FALSE(with([](PathEvent& e) { e.flag = 2; }));
  EXPECT_FALSE(with([](PathEvent& e) { e.integer = -2; }));
  EXPECT_TRUE(with([](PathEvent& e) { e.integer = -1; }));
  PathEvent end = end_;
  end.integer = -1;
  EXPECT_FALSE(believed(1, {begin_, end}));
}

TEST_F(RecordedPathsReply, IsRefusedWithAPathThatIsTooLong) {
  std::vector<PathEvent> events(kMostEventsOfAPath, hit_);
  events.front() = begin_;
  events.back() = end_;
  EXPECT_TRUE(believed(1, events));
  events.insert(events.begin() + 1, hit_);
  EXPECT_FALSE(believed(1, events));
}

}  // namespace
}  // namespace pathmark::test
