// What shadow rays are not tested against can lie on none of them.
#include "render/occluders.h"
#include "intersect/flat_intersector.h"
#include "math/rounding.h"
#include "render/plan.h"
#include "scene/load_scene.h"
#include "support/random_scene.h"

#include <pathmark/lit_scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace pathmark::test {
namespace {

using Indices = std::vector<std::uint32_t>;

Indices indices(std::uint32_t begin, std::uint32_t end) {
  Indices all(end - begin);
  std::iota(all.begin(), all.end(), begin);
  return all;
}

vec3 toVec3(const Float3& a) { return {a[0], a[1], a[2]}; }

// How near segments come to a plane before rounding and offsets decide on which side they are.
constexpr float kGrazingOffsets = 4.0f;

struct SurfacePoint {
  Hit hit;  // as SceneCore makes it
  bool atEdge = false;
};

// The distance from an edge is a barycentric coordinate times the doubled area by the edge's
// length.
bool isAtEdge(const std::array<vec3, 3>& p, const vec3& barycentric, float error) {
  const float doubledArea = length(cross(p[1] - p[0], p[2] - p[0]));
  for (int k = 0; k < 3; ++k) {
    const auto next = static_cast<std::size_t>((k + 1) % 3);
    const auto last = static_cast<std::size_t>((k + 2) % 3);
    if (barycentric[k] * doubledArea < kGrazingOffsets * error * length(p[last] - p[next]))
      return true;
  }
  return false;
}

SurfacePoint pointOfTriangle(const ShapeScene& scene, const FlatTriangle& triangle,
                             RandomNumbers& random) {
  const auto corners = scene.view().corners(triangle);
  const std::array<vec3, 3> p{toVec3(corners[0]), toVec3(corners[1]), toVec3(corners[2])};
  const float r = std::sqrt(random.uniform(0, 1)), v = r * random.uniform(0, 1);
  SurfacePoint point;
  point.hit.p = p[0] + (r - v) * (p[1] - p[0]) + v * (p[2] - p[0]);
  point.hit.n = toVec3(triangle.normal);
  point.hit.error =
      offsetForMagnitude(std::max(largestComponent(point.hit.p), largestComponent(p[0])));
  point.atEdge = isAtEdge(p, {1 - r, r - v, v}, point.hit.error);
  return point;
}

SurfacePoint pointOfSphere(const FlatSphere& sphere, RandomNumbers& random) {
  const vec3 outward = random.direction(), centre = toVec3(sphere.centre);
  SurfacePoint point;
  point.hit.p = centre + sphere.radius * outward;
  point.hit.n = sphere.inward != 0 ? -outward : outward;
  point.hit.error = offsetForMagnitude(largestComponent(centre) + sphere.radius);
  return point;
}

SurfacePoint randomPoint(const ShapeScene& scene, RandomNumbers& random) {
  const std::size_t k = random.below(scene.triangles.size() + scene.spheres.size());
  return k < scene.triangles.size()
             ? pointOfTriangle(scene, scene.triangles[k], random)
             : pointOfSphere(scene.spheres[k - scene.triangles.size()], random);
}

// Whether one end is as near to the tangent plane of the other as offsets are, as within a wall, or
// as near to an edge. Light along such segments has a cosine of 0 up to rounding, or a share of the
// surface as small.
bool grazes(const SurfacePoint& from, const SurfacePoint& to) {
  const glm::dvec3 between = glm::dvec3(to.hit.p) - glm::dvec3(from.hit.p);
  const double nearest = std::min(std::abs(glm::dot(between, glm::dvec3(from.hit.n))),
                                  std::abs(glm::dot(between, glm::dvec3(to.hit.n))));
  const float error = std::max(from.hit.error, to.hit.error);
  return from.atEdge || to.atEdge || nearest < static_cast<double>(kGrazingOffsets * error);
}

struct Tally {
  int segments = 0, occluded = 0, grazing = 0;
  std::size_t droppedTriangles = 0, droppedSpheres = 0;
};

void expectSame(const ShapeScene& scene, RandomNumbers& random, int segments, Tally& tally) {
  const Occluders occluders = occludersOf(scene.view());
  const FlatIntersector all(scene.view());
  const FlatIntersector few(scene.view(), occluders.triangles, occluders.spheres);
  tally.droppedTriangles += scene.triangles.size() - occluders.triangles.size();
  tally.droppedSpheres += scene.spheres.size() - occluders.spheres.size();
  for (int k = 0; k < segments; ++k) {
    const SurfacePoint from = randomPoint(scene, random), to = randomPoint(scene, random);
    ++tally.segments;
    if (grazes(from, to)) {
      ++tally.grazing;
      continue;
    }
    const Vector between = to.hit.p - from.hit.p;
    const Point start = from.hit.spawnRay(between).origin, end = to.hit.spawnRay(-between).origin;
    const bool expected = all.occluded(start, end - start);
    tally.occluded += expected ? 1 : 0;
    ASSERT_EQ(few.occluded(start, end - start), expected);
  }
}

std::array<vec3, 3> randomHalfAxes(RandomNumbers& random, float least, float most) {
  std::array<vec3, 3> axes = random.axes();
  for (vec3& axis : axes) axis *= random.uniform(least, most);
  return axes;
}

// Boxes, spheres and triangles by themselves, of both sides or of fronts only.
void furnish(ShapeScene& scene, RandomNumbers& random) {
  const auto shape = [&] { return static_cast<std::uint32_t>(random.below(2)); };
  const vec3 middle(3, -2, 1);
  for (std::size_t k = random.below(3); k < 3; ++k)
    scene.addBox(middle + random.inCube(0.5f), randomHalfAxes(random, 0.05f, 0.25f), false,
                 shape());
  for (std::size_t k = random.below(3); k < 3; ++k)
    scene.addSphere(middle + random.inCube(0.5f), random.uniform(0.05f, 0.3f), false, shape());
  for (std::size_t k = random.below(4); k < 4; ++k) {
    const vec3 at = middle + random.inCube(0.5f);
    scene.addTriangle(at, at + random.inCube(0.5f), at + random.inCube(0.5f), shape());
  }
}

TEST(Occluders, AnswerAsAllPrimitivesDoInARoom) {
  RandomNumbers random(11);
  Tally tally;
  for (int k = 0; k < 100; ++k) {
    ShapeScene scene;
    scene.addBox({3, -2, 1}, randomHalfAxes(random, 1.8f, 2.5f), true,
                 static_cast<std::uint32_t>(k % 2));
    furnish(scene, random);
    expectSame(scene, random, 5000, tally);
  }
  EXPECT_EQ(tally.droppedTriangles, 1200u);
  EXPECT_GT(tally.occluded, tally.segments / 20);
  EXPECT_LT(tally.grazing, tally.segments / 5);
}

TEST(Occluders, AnswerAsAllPrimitivesDoInASphere) {
  RandomNumbers random(12);
  Tally tally;
  for (int k = 0; k < 100; ++k) {
    ShapeScene scene;
    scene.addSphere({3, -2, 1}, 2.0f, true, static_cast<std::uint32_t>(k % 2));
    furnish(scene, random);
    expectSame(scene, random, 5000, tally);
  }
  EXPECT_EQ(tally.droppedSpheres, 100u);
  EXPECT_GT(tally.occluded, tally.segments / 20);
  EXPECT_LT(tally.grazing, tally.segments / 5);
}

TEST(Occluders, AnswerAsAllPrimitivesDoInTheOpen) {
  RandomNumbers random(13);
  Tally tally;
  for (int k = 0; k < 300; ++k) {
    ShapeScene scene;
    furnish(scene, random);
    expectSame(scene, random, 2000, tally);
  }
  EXPECT_GT(tally.droppedTriangles, 100u);
  EXPECT_GT(tally.occluded, tally.segments / 20);
  EXPECT_LT(tally.grazing, tally.segments / 5);
}

TEST(Occluders, OfTheCornellBoxAreItsBlocksAndItsLight) {
  const LoadedScene scene =
      loadScene(std::filesystem::path(PATHMARK_ROOT) / "scenes/cornell_box.json");
  const FlatSceneView view = viewOf(scene.flat);
  const std::array<float, 3> size{556.0f, 548.8f, 559.2f};
  Indices expected;
  for (std::uint32_t t = 0; t < view.triangles.size(); ++t) {
    const auto corners = view.corners(view.triangles[t]);
    const auto inPlane = [&](std::size_t axis, float low, float high) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Float3& p) { return p[axis] >= low && p[axis] <= high; });
    };
    // The left wall leans by 6.4, and the blocks stand on the floor by their edges only.
    const bool wall = inPlane(0, 0, 0) || inPlane(0, 549.6f, size[0]) || inPlane(1, 0, 0) ||
                      inPlane(1, size[1], size[1]) || inPlane(2, size[2], size[2]);
    if (!wall) expected.push_back(t);
  }
  EXPECT_EQ(expected.size(), 22u);
  EXPECT_EQ(occludersOf(view).triangles, expected);
}

TEST(Occluders, LeaveOutWhatSurroundsTheSceneOnly) {
  ShapeScene scene;
  scene.addSphere({0, 0, 0}, 4, true);
  scene.addSphere({0, 0, 0}, 1);
  EXPECT_EQ(occludersOf(scene.view()).spheres, (Indices{1}));
  scene.addTriangle({-1, 2, -1}, {1, 2, -1}, {0, 2, 1});
  EXPECT_EQ(occludersOf(scene.view()).spheres, (Indices{1}));
  EXPECT_EQ(occludersOf(scene.view()).triangles, (Indices{0}));
  scene.addSphere({3.5f, 0, 0}, 0.6f);  // reaches out
  EXPECT_EQ(occludersOf(scene.view()).spheres, (Indices{0, 1, 2}));
}

TEST(Occluders, AWallStaysIfAnythingIsBehindIt) {
  const auto wallAnd = [](auto&& add) {
    ShapeScene scene;
    scene.addTriangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1});
    add(scene);
    return std::size_t(occludersOf(scene.view()).triangles.size());
  };
  EXPECT_EQ(wallAnd([](ShapeScene&) {}), 0u);
  EXPECT_EQ(wallAnd([](ShapeScene& s) { s.addSphere({0, 1, 0}, 1); }), 0u);
  EXPECT_EQ(wallAnd([](ShapeScene& s) { s.addSphere({0, -1, 0}, 1); }), 0u);
  EXPECT_EQ(wallAnd([](ShapeScene& s) { s.addSphere({0, 0.99f, 0}, 1); }), 1u);
  EXPECT_EQ(wallAnd([](ShapeScene& s) {
              s.addSphere({0, 2, 0}, 1), s.addSphere({9, -2, 9}, 1);
            }),
            1u);
}

TEST(Occluders, AGroundStaysIfSomethingSmallIsCloseBelowIt) {
  ShapeScene scene;
  scene.addTriangle({-1000, 0, -1000}, {1000, 0, -1000}, {0, 0, 1000});
  scene.addSphere({0, 1, 0}, 1);
  scene.addSphere({0, -5e-4f, 0}, 5e-4f);
  EXPECT_EQ(occludersOf(scene.view()).triangles, (Indices{0}));
}

TEST(Occluders, ATiltedWallOfTwoTrianglesIsLeftOutWhicheverWayItsCornersAreRounded) {
  for (int k = 0; k < 100; ++k) {
    const float angle = 0.0618f * static_cast<float>(k);
    const vec3 right(std::cos(angle), 0.3f, std::sin(angle)),
        n = normalize(cross(right, {1, 2, 3}));
    const vec3 up = cross(n, right), corner(0.3f, 0.1f * static_cast<float>(k), -0.7f);
    ShapeScene scene;
    scene.addTriangle(corner, corner + right, corner + right + up);
    scene.addTriangle(corner, corner + right + up, corner + up);
    scene.addSphere(corner + 3.0f * n, 1);
    EXPECT_TRUE(occludersOf(scene.view()).triangles.empty()) << k;
  }
}

TEST(Occluders, AreAllWhereSegmentsMayStartAnywhere) {
  ShapeScene scene;
  scene.addBox({0, 0, 0}, {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, true);
  scene.addSphere({0, 0, 0}, 4, true);
  const Plan anywhere = planFor(scene.view(), ShadowOrigins::kAnywhere);
  EXPECT_EQ(anywhere.occludingTriangles, indices(0, 12));
  EXPECT_EQ(anywhere.occludingSpheres, indices(0, 1));
  const Plan surfaces = planFor(scene.view(), ShadowOrigins::kSurfaces);
  EXPECT_EQ(surfaces.occludingTriangles, indices(0, 12));  // the sphere's points lie behind walls
  EXPECT_TRUE(surfaces.occludingSpheres.empty());
}

}  // namespace
}  // namespace pathmark::test
