// What the first surfaces of a block see of another point, against one pixel at a time in double.
#include "render/receivers.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace pathmark::test {
namespace {

// A box in a larger one, so that walls see each other past it or do not.
ShapeScene boxInBox() {
  ShapeScene scene;
  scene.addBox(vec3(0.0f), {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, true);
  scene.addBox(vec3(0.1f), {vec3(0.4f, 0, 0), vec3(0, 0.4f, 0), vec3(0, 0, 0.4f)});
  return scene;
}

class ReceiversOfABox : public testing::Test {
 protected:
  std::optional<Hit> randomSurface() {
    Hit hit;
    const vec3 origin = random_.inCube(0.95f);
    if (!core_.intersect({origin, random_.direction()}, hit)) return std::nullopt;
    return hit;
  }

  bool hides(const Hit& y, const Hit& x) const {
    const Point start = y.spawnRay(y.n).origin;
    return intersector_.occluded(start, x.spawnRay(x.n).origin - start);
  }

  ShapeScene scene_ = boxInBox();
  SceneCore core_{scene_.view(), ShadowOrigins::kAnywhere};
  Intersector intersector_{scene_.view(), planFor(scene_.view(), ShadowOrigins::kAnywhere)};
  RandomNumbers random_{41};
};

TEST_F(ReceiversOfABox, SeeWhatASegmentOfTheirOwnWouldTell) {
  int seen = 0, hidden = 0, behind = 0;
  for (const std::size_t pixels : {std::size_t{2}, kLanes, 2 * kLanes, std::size_t{64}}) {
    Receivers receivers(pixels);
    std::vector<std::optional<Hit>> surfaces(pixels);
    for (int k = 0; k < 300; ++k) {
      for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        surfaces[pixel] = random_.below(8) == 0 ? std::nullopt : randomSurface();
        if (surfaces[pixel])
          receivers.put(pixel, *surfaces[pixel]);
        else
          receivers.takeAway(pixel);
      }
      const std::optional<Hit> y = randomSurface();
      if (!y) continue;
      const std::size_t except = random_.below(pixels);
      const std::uint64_t shadowRays = receivers.look(core_, *y, except);
      std::uint64_t inFront = 0;
      for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        if (pixel == except || !surfaces[pixel]) {
          ASSERT_FALSE(receivers.sees(pixel));
          continue;
        }
        const Hit& x = *surfaces[pixel];
        const glm::dvec3 way = glm::dvec3(y->p) - glm::dvec3(x.p);
        const double squared = glm::dot(way, way);
        const glm::dvec3 wi = way / std::sqrt(squared);
        const double cosX = glm::dot(glm::dvec3(x.n), wi), cosY = -glm::dot(glm::dvec3(y->n), wi);
        if (std::min(std::abs(cosX), std::abs(cosY)) < 1e-5) continue;  // may round either way
        if (std::min(cosX, cosY) < 0.0) {
          ASSERT_FALSE(receivers.sees(pixel));
          ++behind;
          continue;
        }
        ++inFront;
        ASSERT_EQ(receivers.sees(pixel), !hides(*y, x));
        ++(receivers.sees(pixel) ? seen : hidden);
        if (!receivers.sees(pixel)) continue;
        EXPECT_LT(length(receivers.wi(pixel) - Vector(wi)), 1e-6f);
        EXPECT_NEAR(receivers.cosX(pixel), cosX, 1e-5);
        EXPECT_NEAR(receivers.perArea(pixel) * squared, cosY, 1e-5);
      }
      EXPECT_GE(shadowRays, inFront);
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(hidden, 1000);
  EXPECT_GT(behind, 1000);
}

// A ray that comes from above meets the slat, and one from below passes through.
ShapeScene slatInABox() {
  ShapeScene scene;
  scene.addBox(vec3(0.0f), {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, true);
  const vec3 a(-0.7f, 0, -0.7f), b(-0.7f, 0, 0.7f), c(0.7f, 0, 0.7f), d(0.7f, 0, -0.7f);
  scene.addTriangle(a, b, c, ShapeScene::kFrontOnly);
  scene.addTriangle(a, c, d, ShapeScene::kFrontOnly);
  return scene;
}

TEST(ReceiversBesideASlat, SeeWhatTheirOwnRaysWouldMeet) {
  const ShapeScene scene = slatInABox();
  for (const bool hierarchy : {false, true}) {
    const Skips skips = hierarchy ? Skips{}.without(Skip::kHierarchyOfFew) : Skips{};
    const SceneCore core(scene.view(), ShadowOrigins::kAnywhere, skips);
    ASSERT_TRUE(core.hidesOneWay());
    RandomNumbers random(42);
    Receivers receivers(2);
    int asymmetric = 0;
    for (int k = 0; k < 20000; ++k) {
      Hit x, y;
      if (!core.intersect({random.inCube(0.95f), random.direction()}, x) ||
          !core.intersect({random.inCube(0.95f), random.direction()}, y))
        continue;
      receivers.put(1, x);
      if (receivers.look(core, y, 0) == 0) continue;
      const Point from = x.spawnRay(x.n).origin, to = y.spawnRay(y.n).origin;
      const bool hidden = core.occluded(from, to - from);
      ASSERT_EQ(receivers.sees(1), !hidden);
      asymmetric += hidden != core.occluded(to, from - to) ? 1 : 0;
    }
    EXPECT_GT(asymmetric, 100);
  }
}

TEST_F(ReceiversOfABox, TraceNoRayWhereNoneIsInFront) {
  Receivers receivers(4);
  Hit floor;
  ASSERT_TRUE(core_.intersect({{0.9f, 0.9f, 0.9f}, {0, -1, 0}}, floor));
  EXPECT_EQ(receivers.look(core_, floor, 0), 0u);
  for (std::size_t pixel = 0; pixel < 4; ++pixel) receivers.put(pixel, floor);
  EXPECT_EQ(receivers.look(core_, floor, 0), 0u);
  Hit wall;
  ASSERT_TRUE(core_.intersect({{0.9f, 0.0f, 0.9f}, {1, 0, 0}}, wall));
  EXPECT_EQ(receivers.look(core_, wall, 0), 3u);
  receivers.takeAway(2);
  EXPECT_EQ(receivers.look(core_, wall, 0), 2u);
  EXPECT_FALSE(receivers.sees(2));
}

}  // namespace
}  // namespace pathmark::test
