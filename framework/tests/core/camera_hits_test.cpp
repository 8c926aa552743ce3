// Camera rays in packets: against the same rays one by one, and as LitScene hands them out.
#include "render/camera_hits.h"
#include "render/ray_count.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pathmark::test {
namespace {

ShapeScene manyShapes(RandomNumbers& random, std::size_t spheres) {
  ShapeScene scene;
  for (std::size_t k = 0; k < kFewestForHierarchy; ++k) {
    const vec3 a = random.inCube(1.0f), u = random.inCube(0.4f), v = random.inCube(0.4f);
    const auto sides = static_cast<std::uint32_t>(k % 2);
    if (k % 3 == 0)
      scene.addTriangle(a, a + u, a + v, sides);
    else
      scene.addQuad(a, a + u, a + u + v, a + v, sides);
  }
  for (std::size_t k = 0; k < spheres; ++k)
    scene.addSphere(random.inCube(1.0f), random.uniform(0.05f, 0.2f), k % 2 == 0, k % 2 == 0);
  return scene;
}

// As through one pixel, or anywhere.
std::vector<Ray> raysFrom(const Point& eye, std::size_t count, float spread,
                          RandomNumbers& random) {
  std::vector<Ray> rays;
  const Vector middle = random.direction();
  for (std::size_t k = 0; k < count; ++k)
    rays.push_back({eye, normalize(middle + spread * random.direction())});
  return rays;
}

// Rays that graze an edge may go either way: at most one in 10,000.
void expectTheSame(const ShapeScene& scene, RandomNumbers& random) {
  const Intersector intersector(scene.view(), planFor(scene.view()));
  ASSERT_GE(kMostInPacket, intersector.packetSize());
  int met = 0, missed = 0, different = 0;
  for (int k = 0; met + missed < 160000; ++k) {
    const std::size_t count = 1 + random.below(intersector.packetSize());
    const std::vector<Ray> rays =
        raysFrom(random.inCube(1.5f), count, k % 2 == 0 ? 0.01f : 1.0f, random);
    std::array<PrimitiveHit, kMostInPacket> hits;
    const std::uint32_t mask = intersector.closest(rays, hits);
    ASSERT_EQ(mask >> count, 0u);
    for (std::size_t i = 0; i < count; ++i) {
      PrimitiveHit expected;
      const bool hit = intersector.closest(rays[i], expected);
      ++(hit ? met : missed);
      const bool same =
          ((mask >> i & 1u) != 0) == hit &&
          (!hit || (hits[i].index == expected.index && hits[i].isSphere == expected.isSphere &&
                    std::abs(hits[i].t - expected.t) <= 1e-5f * (1 + expected.t)));
      different += same ? 0 : 1;
    }
  }
  EXPECT_GT(met, 10000);
  EXPECT_GT(missed, 10000);
  EXPECT_LE(different, (met + missed) / 10000);
}

TEST(RayPacket, MeetsWhatItsRaysMeetOneByOne) {
  RandomNumbers random(51);
  for (int scenes = 0; scenes < 3; ++scenes) expectTheSame(manyShapes(random, 0), random);
}

TEST(RayPacket, MeetsSpheresBesideAHierarchy) {
  RandomNumbers random(52);
  for (int scenes = 0; scenes < 3; ++scenes) expectTheSame(manyShapes(random, 12), random);
}

// Embree may find a triangle again that a ray starts from, by rounding.
TEST(RayPacket, MeetsNothingBehindItsOrigin) {
  RandomNumbers random(53);
  const ShapeScene scene = manyShapes(random, 0);
  const Intersector intersector(scene.view(), planFor(scene.view()));
  const auto toVec3 = [](const Float3& a) { return vec3(a[0], a[1], a[2]); };
  int metAgain = 0;
  for (int k = 0; k < 20000; ++k) {
    const Ray first{random.inCube(1.5f), random.direction()};
    PrimitiveHit from;
    if (!intersector.closest(first, from)) continue;
    const Point start = first.origin + from.t * first.direction;
    const std::vector<Ray> rays = raysFrom(start, intersector.packetSize(), 1.0f, random);
    std::array<PrimitiveHit, kMostInPacket> hits;
    const std::uint32_t mask = intersector.closest(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if ((mask >> i & 1u) == 0 || hits[i].index != from.index) continue;
      ++metAgain;
      const FlatTriangle& triangle = scene.triangles[from.index];
      const vec3 n = toVec3(triangle.normal), corner = toVec3(scene.vertices[triangle.vertex[0]]);
      EXPECT_GT(dot(corner - start, n) / dot(rays[i].direction, n), 0.0f);
    }
  }
  EXPECT_GT(metAgain, 100);
}

TEST(RayPacket, RaysThatAreNoneMeetNothing) {
  RandomNumbers random(54);
  const ShapeScene scene = manyShapes(random, 2);
  const Intersector intersector(scene.view(), planFor(scene.view()));
  std::vector<Ray> rays = raysFrom({0, 0, 0}, intersector.packetSize(), 0.01f, random);
  std::array<PrimitiveHit, kMostInPacket> hits;
  const std::uint32_t all = intersector.closest(rays, hits);
  rays[0].direction.y = std::numeric_limits<float>::quiet_NaN();
  rays.back().origin.x = kInfinity;
  const std::uint32_t others = all & ~(1u | 1u << (rays.size() - 1));
  EXPECT_EQ(intersector.closest(rays, hits), others);
}

class CameraHitsOfAScene : public testing::Test {
 protected:
  void SetUp() override { restartRayCount(); }
  void TearDown() override { cameraHitsOfThisThread(nullptr); }

  RandomNumbers random_{55};
  ShapeScene scene_ = manyShapes(random_, 2);
  SceneCore core_{scene_.view()};
  CameraHits hits_{core_};
  LitScene lit_{core_, core_.maxBounces()};
};

TEST_F(CameraHitsOfAScene, AnswerWhatTheSceneAnswers) {
  cameraHitsOfThisThread(&hits_);
  int met = 0;
  for (int pixel = 0; pixel < 200; ++pixel) {
    const std::vector<Ray> rays =
        raysFrom(random_.inCube(1.5f), 1 + random_.below(70), 0.01f, random_);
    hits_.trace(rays);
    for (const Ray& ray : rays) {
      ASSERT_TRUE(hits_.isNext(ray));
      Hit expected, found;
      const bool hit = core_.intersect(ray, expected);
      ASSERT_EQ(lit_.intersect(ray, found), hit);
      if (!hit) continue;
      ++met;
      EXPECT_EQ(found.n, expected.n);
      EXPECT_EQ(found.brdf, expected.brdf);
      EXPECT_NEAR(length(found.p - expected.p), 0.0f, 1e-5f);
    }
    EXPECT_FALSE(hits_.isNext(rays.back()));
  }
  EXPECT_GT(met, 1000);
}

// The answers here are of another scene, so that it shows whose they are.
TEST_F(CameraHitsOfAScene, AreTakenByTheNextRayOnly) {
  ShapeScene elsewhere = manyShapes(random_, 0);
  for (Float3& v : elsewhere.vertices) v[2] += 100.0f;
  const SceneCore far(elsewhere.view());
  CameraHits nothing(far);
  std::vector<Ray> rays;
  while (rays.size() < 3) {
    const Ray ray{random_.inCube(1.5f), random_.direction()};
    Hit hit;
    if (core_.intersect(ray, hit) && !far.intersect(ray, hit)) rays.push_back(ray);
  }
  nothing.trace(rays);
  cameraHitsOfThisThread(&nothing);
  Hit hit;
  EXPECT_TRUE(lit_.intersect(rays[1], hit));
  EXPECT_FALSE(lit_.intersect(rays[0], hit));
  EXPECT_TRUE(lit_.intersect(rays[0], hit));
  Ray fromTheSamePoint = rays[1];
  do fromTheSamePoint.direction = random_.direction();
  while (!core_.intersect(fromTheSamePoint, hit));
  EXPECT_TRUE(lit_.intersect(fromTheSamePoint, hit));
  EXPECT_FALSE(lit_.intersect(rays[1], hit));
  EXPECT_EQ(raysOfThisThread(), 5u);
  nothing.trace(rays);
  EXPECT_FALSE(lit_.intersect(rays[0], hit));
  cameraHitsOfThisThread(nullptr);
  EXPECT_TRUE(lit_.intersect(rays[1], hit));
}

}  // namespace
}  // namespace pathmark::test
