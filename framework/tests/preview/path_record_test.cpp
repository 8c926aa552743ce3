// From what a worker has recorded to paths.
#include "preview/paths/path_record.h"

#include "preview/paths/path_account.h"
#include "preview/paths/path_text.h"
#include "support/path_event.h"

#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace pathmark::preview {
namespace {

using test::event;

const Point kFloor(0.0f), kLamp(0.0f, 2.0f, 0.0f);
const Vector kUp(0.0f, 1.0f, 0.0f), kDown(0.0f, -1.0f, 0.0f);

TEST(PathRecord, HasAVertexForEachHitAndTheRayThatLeaves) {
  const auto paths = readPaths(std::vector{
      event(PathEventKind::kPath, {0.0f, 5.0f, 0.0f}, kDown),
      event(PathEventKind::kHit, kFloor, kUp),
      event(PathEventKind::kReflection, kUp, kUp, kUp, 0.5f),
      event(PathEventKind::kMiss, kFloor, kUp),
      event(PathEventKind::kRadiance, Colour(3.0f)),
      event(PathEventKind::kPath, {1.0f, 5.0f, 0.0f}, kDown),
      event(PathEventKind::kRadiance, Colour(4.0f)),
  });
  ASSERT_EQ(paths.size(), 2u);
  ASSERT_EQ(paths[0].vertices.size(), 1u);
  EXPECT_EQ(paths[0].vertices[0].p, kFloor);
  ASSERT_TRUE(paths[0].vertices[0].next);
  EXPECT_EQ(paths[0].vertices[0].next->cosine, 1.0f);
  EXPECT_EQ(paths[0].vertices[0].next->pdf, 0.5f);
  ASSERT_TRUE(paths[0].escape);
  EXPECT_EQ(paths[0].radiance, Colour(3.0f));
  EXPECT_EQ(paths[1].number, 1);
  EXPECT_EQ(paths[1].camera.origin.x, 1.0f);
  EXPECT_TRUE(paths[1].vertices.empty());
  EXPECT_FALSE(paths[1].escape);
}

// A question about the BRDF belongs to the light in whose direction it is asked, and one that is
// asked while light is sought is not about the path's own direction.
TEST(PathRecord, TellsQuestionsOfShadowRaysFromThoseOfThePath) {
  PathEvent blocked =
      event(PathEventKind::kShadowRay, kFloor, {2.0f, 2.0f, 0.0f}, {1.0f, 1.0f, 0.0f});
  PathEvent visible = event(PathEventKind::kShadowRay, kFloor, kLamp);
  visible.flag = 1;
  const auto paths = readPaths(std::vector{
      event(PathEventKind::kPath),
      event(PathEventKind::kHit, kFloor, kUp),
      event(PathEventKind::kDirectBegin, kFloor, kUp),
      event(PathEventKind::kLightSample, kLamp, kDown, Colour(7.0f), 0.25f),
      event(PathEventKind::kLightSample, {2.0f, 2.0f, 0.0f}, kDown, Colour(8.0f), 0.5f),
      event(PathEventKind::kHit, {9.0f, 9.0f, 9.0f}, kUp),
      blocked,
      visible,
      event(PathEventKind::kBrdf, kUp, kUp, Colour(0.125f)),
      event(PathEventKind::kDirectEnd, Colour(0.75f)),
      event(PathEventKind::kReflection, kUp, kUp, kUp, 0.5f),
      event(PathEventKind::kBrdf, kUp, {1.0f, 0.0f, 0.0f}, Colour(9.0f)),
      event(PathEventKind::kBrdf, kUp, kUp, Colour(0.25f)),
      event(PathEventKind::kRadiance),
  });
  ASSERT_EQ(paths.size(), 1u);
  ASSERT_EQ(paths[0].vertices.size(), 1u) << "a ray within directLighting is none of the path's";
  const PathVertex& vertex = paths[0].vertices[0];
  EXPECT_EQ(vertex.direct, Colour(0.75f));
  ASSERT_EQ(vertex.shadowRays.size(), 2u);
  EXPECT_EQ(vertex.shadowRays[0].visibility, Visibility::kVisible);
  EXPECT_EQ(vertex.shadowRays[0].f, Colour(0.125f));
  EXPECT_EQ(vertex.shadowRays[0].pdf, 0.25f);
  EXPECT_EQ(vertex.shadowRays[0].emission, Colour(7.0f));
  EXPECT_EQ(vertex.shadowRays[1].visibility, Visibility::kBlocked);
  EXPECT_EQ(vertex.shadowRays[1].blocker, Point(1.0f, 1.0f, 0.0f));
  EXPECT_FALSE(vertex.shadowRays[1].f);
  EXPECT_EQ(vertex.next->f, Colour(0.25f));
}

// In part 8 the path itself looks for light, with two kinds of densities for the same direction.
TEST(PathRecord, HasTheLightThatAPathSamplesAndMeetsByItself) {
  PathEvent visible = event(PathEventKind::kShadowRay, kFloor, kLamp);
  visible.flag = 1;
  const Vector sidewards(1.0f, 0.0f, 0.0f);
  const Point onWall(1.0f, 0.0f, 0.0f);
  const auto paths = readPaths(std::vector{
      event(PathEventKind::kPath),
      event(PathEventKind::kHit, kFloor, kUp),
      event(PathEventKind::kLightSample, kLamp, kDown, Colour(7.0f), 0.25f),
      visible,
      event(PathEventKind::kPdf, kUp, kUp, kUp, 0.75f),
      event(PathEventKind::kBrdf, kUp, kUp, Colour(0.125f)),
      event(PathEventKind::kReflection, kUp, sidewards, kUp, 0.5f),
      event(PathEventKind::kBrdf, kUp, sidewards, Colour(0.25f)),
      event(PathEventKind::kHit, onWall, -sidewards, Colour(7.0f)),
      event(PathEventKind::kLightPdf, kFloor, onWall, kUp, 0.375f),
      event(PathEventKind::kRadiance),
  });
  ASSERT_EQ(paths.size(), 1u);
  ASSERT_EQ(paths[0].vertices.size(), 2u);
  const PathVertex &floor = paths[0].vertices[0], &wall = paths[0].vertices[1];
  ASSERT_EQ(floor.shadowRays.size(), 1u);
  EXPECT_EQ(floor.shadowRays[0].visibility, Visibility::kVisible);
  EXPECT_EQ(floor.shadowRays[0].brdfPdf, 0.75f);
  EXPECT_EQ(floor.shadowRays[0].f, Colour(0.125f));
  EXPECT_EQ(floor.next->f, Colour(0.25f));
  EXPECT_FALSE(floor.lightPdf);
  EXPECT_EQ(wall.lightPdf, 0.375f);
}

// The host has seen to whole paths only: within them anything may come.
TEST(PathRecord, TakesAnyEventsWithinAPath) {
  constexpr float kNumbers[] = {0.0f,
                                1.0f,
                                -1.0f,
                                1e30f,
                                std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::quiet_NaN()};
  std::mt19937 random(1);
  const auto number = [&] { return kNumbers[random() % std::size(kNumbers)]; };
  const auto vector = [&] { return vec3(number(), number(), number()); };
  const LoadedScene scene;
  std::size_t vertices = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<PathEvent> events{event(PathEventKind::kPath, vector(), vector())};
    for (int i = 0; i < 12; ++i) {
      constexpr unsigned kLightPdf = static_cast<unsigned>(PathEventKind::kLightPdf);
      const auto which = static_cast<unsigned>(2 + random() % 11);  // no end among them
      const auto kind = static_cast<PathEventKind>(which == 12 ? kLightPdf : which);
      events.push_back(event(kind, vector(), vector(), vector(), number()));
      events.back().integer = static_cast<int>(random() % 3) - 1;
      events.back().flag = random() % 2;
      events.back().y = number();
    }
    events.push_back(event(PathEventKind::kRadiance, vector()));
    const auto paths = readPaths(events);
    ASSERT_EQ(paths.size(), 1u);
    const PathAccount account =
        accountFor(paths[0], {random() % 2 == 0, random() % 3, random() % 2 == 0});
    ASSERT_EQ(account.vertices.size(), paths[0].vertices.size());
    for (std::size_t v = 0; v < paths[0].vertices.size(); ++v) {
      ASSERT_EQ(account.vertices[v].shadowRays.size(), paths[0].vertices[v].shadowRays.size());
      EXPECT_FALSE(describeVertex(paths[0], account, v, scene).empty());
    }
    EXPECT_FALSE(endOf(paths[0]).empty());
    vertices += paths[0].vertices.size();
  }
  EXPECT_GT(vertices, 1000u);
}

}  // namespace
}  // namespace pathmark::preview
