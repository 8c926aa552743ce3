// From what a worker has recorded to paths.
#include "preview/paths/path_record.h"

#include <gtest/gtest.h>

#include <limits>

namespace pathmark::preview {
namespace {

PathEvent event(PathEventKind kind, const vec3& a = vec3(0.0f), const vec3& b = vec3(0.0f),
                const vec3& c = vec3(0.0f), float x = 0.0f) {
  PathEvent e;
  e.kind = kind;
  for (int k = 0; k < 3; ++k) {
    e.a[k] = a[k];
    e.b[k] = b[k];
    e.c[k] = c[k];
  }
  e.x = x;
  return e;
}

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

// The host has seen to whole paths only: within them anything may come.
TEST(PathRecord, TakesAnyOrderOfEventsWithinAPath) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::uint32_t first = 2; first < 12; ++first)
    for (std::uint32_t second = 2; second < 12; ++second) {
      const auto paths = readPaths(std::vector{
          event(PathEventKind::kPath, vec3(nan)),
          event(static_cast<PathEventKind>(first), vec3(nan), vec3(nan), vec3(nan), nan),
          event(static_cast<PathEventKind>(second)), event(PathEventKind::kRadiance)});
      EXPECT_EQ(paths.size(), 1u) << first << " " << second;
    }
}

}  // namespace
}  // namespace pathmark::preview
