// What is decided when a scene is loaded, and that rays are answered alike whatever it is.
#include "intersect/intersector.h"
#include "render/explain_plan.h"
#include "render/occluders.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pathmark::test {
namespace {

ShapeScene randomScene(std::size_t triangles, std::size_t spheres) {
  RandomNumbers random(21);
  ShapeScene scene;
  for (std::size_t k = 0; k < triangles; ++k) {
    const vec3 at = random.inCube(1.0f);
    scene.addTriangle(at, at + random.inCube(0.4f), at + random.inCube(0.4f),
                      static_cast<std::uint32_t>(k % 2));
  }
  for (std::size_t k = 0; k < spheres; ++k)
    scene.addSphere(random.inCube(1.0f), random.uniform(0.05f, 0.2f), k % 2 == 0,
                    static_cast<std::uint32_t>(k % 2));
  return scene;
}

TEST(Plan, ChoosesByTheNumberOfTriangles) {
  const auto chosen = [](std::size_t triangles, std::size_t spheres) {
    return planFor(randomScene(triangles, spheres).view()).triangles;
  };
  EXPECT_EQ(chosen(0, 0), TriangleTest::kNone);
  EXPECT_EQ(chosen(0, 300), TriangleTest::kNone);
  EXPECT_EQ(chosen(1, 0), TriangleTest::kFlatLoop);
  EXPECT_EQ(chosen(kFewestForHierarchy - 1, 300), TriangleTest::kFlatLoop);
  EXPECT_EQ(chosen(kFewestForHierarchy, 0), TriangleTest::kHierarchy);
}

// The loop meets two triangles that make a quad as one.
TEST(Plan, CountsPairsOfTrianglesOnce) {
  const auto chosen = [](std::size_t pairs, Skips skips = {}) {
    RandomNumbers random(22);
    ShapeScene scene;
    for (std::size_t k = 0; k < pairs; ++k) {
      const vec3 a = random.inCube(1.0f), v1 = random.inCube(0.4f), v2 = random.inCube(0.4f);
      scene.addTriangle(a, a + v1, a + v1 + v2);
      scene.addTriangle(a, a + v1 + v2, a + v2);
    }
    return planFor(scene.view(), ShadowOrigins::kSurfaces, skips).triangles;
  };
  EXPECT_EQ(chosen(kFewestForHierarchy - 1), TriangleTest::kFlatLoop);
  EXPECT_EQ(chosen(kFewestForHierarchy), TriangleTest::kHierarchy);
  EXPECT_EQ(chosen(kFewestForHierarchy - 1, Skips().without(Skip::kSecondTriangles)),
            TriangleTest::kHierarchy);
}

TEST(Plan, LeavesOutNothingThatASwitchKeeps) {
  const ShapeScene few = randomScene(20, 3), many = randomScene(kFewestForHierarchy, 3);
  const auto without = [](const ShapeScene& scene, Skip skip) {
    return planFor(scene.view(), ShadowOrigins::kSurfaces, Skips().without(skip));
  };
  EXPECT_EQ(without(few, Skip::kHierarchyOfFew).triangles, TriangleTest::kHierarchy);
  EXPECT_EQ(without(many, Skip::kLoopOverMany).triangles, TriangleTest::kFlatLoop);
  EXPECT_EQ(without(few, Skip::kLoopOverMany).triangles, TriangleTest::kFlatLoop);
  EXPECT_EQ(without(few, Skip::kBoundingSurfaces).occludingTriangles.size(), 20u);
  EXPECT_FALSE(without(few, Skip::kSecondTriangles).flatTests.pairs);
  EXPECT_TRUE(without(few, Skip::kBackTests).flatTests.backsOfAll);
  EXPECT_TRUE(without(few, Skip::kEmptyKinds).flatTests.kindsOfNothing);
  EXPECT_FALSE(without(many, Skip::kSingleCameraRays).cameraRaysTogether);
}

TEST(Plan, TracesCameraRaysTogetherThroughAHierarchyOnly) {
  EXPECT_TRUE(planFor(randomScene(kFewestForHierarchy, 3).view()).cameraRaysTogether);
  EXPECT_FALSE(planFor(randomScene(20, 3).view()).cameraRaysTogether);
  EXPECT_FALSE(planFor(randomScene(0, 3).view()).cameraRaysTogether);
}

// Whatever is left out, rays meet the same.
TEST(Plan, SkipsChangeNoAnswer) {
  for (const auto& [triangles, spheres] :
       {std::pair<std::size_t, std::size_t>{0, 20}, {40, 0}, {40, 20}}) {
    const ShapeScene scene = randomScene(triangles, spheres);
    const Intersector all(scene.view(), planFor(scene.view(), ShadowOrigins::kAnywhere));
    for (const Skip skip : {Skip::kSecondTriangles, Skip::kBackTests, Skip::kEmptyKinds}) {
      const Intersector one(scene.view(),
                            planFor(scene.view(), ShadowOrigins::kAnywhere, Skips().without(skip)));
      RandomNumbers random(22);
      for (int k = 0; k < 20000; ++k) {
        const Ray ray{random.inCube(1.5f), random.direction()};
        PrimitiveHit a, b;
        const bool hit = all.closest(ray, a);
        ASSERT_EQ(one.closest(ray, b), hit);
        if (hit) {
          ASSERT_EQ(a.index, b.index);
          ASSERT_EQ(a.t, b.t);
        }
        const vec3 segment = random.inCube(2.0f);
        ASSERT_EQ(one.occluded(ray.origin, segment), all.occluded(ray.origin, segment));
      }
    }
  }
}

// Rays that graze an edge or meet two primitives at almost one place may go either way, one in ten
// thousand of them.
TEST(Plan, EitherKindOfIntersectorMeetsTheSame) {
  for (const auto& [triangles, spheres] :
       {std::pair<std::size_t, std::size_t>{0, 20}, {100, 0}, {100, 20}, {300, 0}, {300, 20}}) {
    const ShapeScene scene = randomScene(triangles, spheres);
    Plan planned = planFor(scene.view(), ShadowOrigins::kAnywhere), other = planned;
    other.triangles = planned.triangles == TriangleTest::kHierarchy ? TriangleTest::kFlatLoop
                                                                    : TriangleTest::kHierarchy;
    other.occludingTriangles = allPrimitives(scene.view()).triangles;
    const Intersector one(scene.view(), planned), two(scene.view(), other);
    RandomNumbers random(22);
    constexpr int kRays = 50000;
    int met = 0, different = 0;
    for (int k = 0; k < kRays; ++k) {
      const Ray ray{random.inCube(1.5f), random.direction()};
      PrimitiveHit a, b;
      const bool hit = one.closest(ray, a);
      met += hit ? 1 : 0;
      const bool same =
          two.closest(ray, b) == hit && (!hit || (a.index == b.index && a.isSphere == b.isSphere &&
                                                  std::abs(a.t - b.t) <= 1e-5f * (1.0f + a.t)));
      const vec3 segment = random.inCube(2.0f);
      different += same ? 0 : 1;
      different += one.occluded(ray.origin, segment) == two.occluded(ray.origin, segment) ? 0 : 1;
    }
    EXPECT_GT(met, kRays / 20);
    EXPECT_LE(different, kRays / 10000) << triangles << " " << spheres;
  }
}

std::string decisionOf(const std::vector<PlanLine>& lines, const std::string& what) {
  const auto line =
      std::find_if(lines.begin(), lines.end(), [&](const PlanLine& l) { return l.what == what; });
  return line == lines.end() ? "no such line" : line->decision;
}

std::vector<PlanLine> explained(const ShapeScene& scene) {
  return explainPlan(planFor(scene.view()), scene.view());
}

TEST(ExplainPlan, TellsWhichTestsARayGoesThrough) {
  const auto pairs = explained(randomScene(3, 0));
  EXPECT_EQ(decisionOf(pairs, "triangles"), "3 as 3 singles, a flat loop of 1 step");
  EXPECT_EQ(decisionOf(pairs, "spheres"), "none: no sphere test");
  EXPECT_EQ(decisionOf(pairs, "backs"), "culled");
  const auto spheres = explained(randomScene(0, kLanes + 1));
  EXPECT_EQ(decisionOf(spheres, "triangles"), "none: no triangle test");
  EXPECT_EQ(decisionOf(spheres, "spheres"),
            std::to_string(kLanes + 1).append(", a flat loop of 2 steps"));
  EXPECT_EQ(decisionOf(spheres, "backs"), "not asked for");
  EXPECT_EQ(decisionOf(explained(randomScene(1000, 0)), "triangles"), "1000 in Embree's hierarchy");
  EXPECT_EQ(decisionOf(explained(randomScene(1000, 0)), "camera rays"),
            "those of a pixel in packets");
}

TEST(ExplainPlan, NamesTheFunctionThatSamplesALight) {
  const auto lightOf = [](const std::vector<Float3>& vertices) {
    ShapeScene scene;
    scene.lightVertices = vertices;
    scene.faces.push_back({0, static_cast<std::uint32_t>(vertices.size()), 0, 0, {}, 1.0f});
    scene.lights.resize(1);
    scene.lights[0].faceCount = 1;
    return decisionOf(explained(scene), "lights");
  };
  EXPECT_EQ(lightOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "1 x triangle by TriangularSampling");
  EXPECT_EQ(lightOf({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 1, 0}}),
            "1 x parallelogram by RectangularSampling");
  EXPECT_EQ(lightOf({{0, 0, 0}, {1, 0, 0}, {3, 1, 0}, {1, 1, 0}}),
            "1 x polygon by PolygonSampling");
}

TEST(ExplainPlan, TellsWhyAPictureIsBlack) {
  EXPECT_EQ(decisionOf(explained(ShapeScene{}), "picture"), "black");
  EXPECT_EQ(decisionOf(explained(randomScene(5, 1)), "picture"), "black");
  EXPECT_EQ(decisionOf(explained(randomScene(5, 1)), "shadow rays"), "none");
}

TEST(ExplainPlan, TellsOfShadowRaysAndBouncesThatNobodyAsksFor) {
  ShapeScene scene = randomScene(5, 1);
  scene.lights.resize(1);
  scene.lights[0].sphere = 0;
  EXPECT_EQ(decisionOf(explained(scene), "picture"), "no such line");
  scene.maxBounces = 0;
  EXPECT_EQ(decisionOf(explained(scene), "shadow rays"), "none");
  EXPECT_EQ(decisionOf(explained(scene), "paths"), "no bounce");
  scene.maxBounces = 1;
  EXPECT_NE(decisionOf(explained(scene), "shadow rays"), "none");
  EXPECT_EQ(decisionOf(explained(scene), "paths"), "no bounce rays");
  scene.maxBounces = 3;
  EXPECT_EQ(decisionOf(explained(scene), "paths"), "direct light and at most 2 bounces");
}

}  // namespace
}  // namespace pathmark::test
