// A ray that leaves a surface does not meet it again, and a light is not hidden by itself: at all
// scales, far from the origin, and at grazing angles.
#include "math/rounding.h"
#include "render/scene_core.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pathmark::test {
namespace {

struct Placement {
  float scale;
  float shift;  // in sizes of the scene
};

// A square floor of two triangles, and a light above it, at a place of the world.
class SmallScene {
 public:
  SmallScene(const Placement& at, bool sphereLight) {
    scene_.materials.push_back({FlatMaterialKind::kLambertian, {0.5f, 0.5f, 0.5f}, {}, 0.0f});
    scene_.shapes = {FlatShape{}, FlatShape{0, 0, {1, 1, 1}}};
    const vec3 o = at.scale * at.shift * vec3(0.61f, -0.77f, 0.43f);
    const float s = at.scale;
    floor_ = {o + s * vec3(-1, 0, 1), o + s * vec3(1, 0.1f, 1), o + s * vec3(1, 0.2f, -1),
              o + s * vec3(-1, 0.1f, -1)};
    addTriangle({floor_[0], floor_[1], floor_[2]}, 0);
    addTriangle({floor_[0], floor_[2], floor_[3]}, 0);
    centre_ = o + s * vec3(0.1f, 1.5f, 0.2f);
    if (sphereLight) {
      scene_.spheres.push_back({{centre_.x, centre_.y, centre_.z}, 0.1f * s, 1, 0});
      scene_.lights.push_back({0, 0, 0, {1, 1, 1}});
    } else {
      const std::array<vec3, 3> p{centre_, centre_ + s * vec3(0.3f, 0.05f, 0.1f),
                                  centre_ + s * vec3(-0.1f, 0, 0.4f)};
      normal_ = addTriangle(p, 1);
      for (const vec3& v : p) scene_.lightVertices.push_back({v.x, v.y, v.z});
      scene_.lightTriangles = {{0, 1, 2}};
      scene_.faces.push_back({0, 3, 0, 1, {normal_.x, normal_.y, normal_.z}, 1.0f});
      scene_.lights.push_back({FlatLight::kNoSphere, 0, 1, {1, 1, 1}});
    }
  }

  FlatSceneView view() const { return viewOf(scene_); }
  const std::array<vec3, 4>& floor() const { return floor_; }
  const vec3& lightPoint() const { return centre_; }
  const vec3& lightNormal() const { return normal_; }

 private:
  vec3 addTriangle(const std::array<vec3, 3>& p, std::uint32_t shape) {
    const vec3 n = normalize(cross(p[1] - p[0], p[2] - p[0]));
    std::array<Float3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {p[k].x, p[k].y, p[k].z};
    scene_.addTriangle(corners, {n.x, n.y, n.z}, shape);
    return n;
  }

  FlatScene scene_;
  std::array<vec3, 4> floor_{};
  vec3 centre_{0.0f}, normal_{0, -1, 0};
};

constexpr Placement kPlacements[] = {{1e-3f, 0}, {1, 0},    {1e4f, 0},
                                     {1, 10},    {1, 1e3f}, {1e-2f, 1e3f}};

class Offsets : public testing::TestWithParam<Placement> {
 protected:
  float uniform() { return std::uniform_real_distribution<float>(0, 1)(engine_); }
  vec3 direction() {
    const float z = 2 * uniform() - 1, a = 2 * kPi * uniform(), r = std::sqrt(1 - z * z);
    return {r * std::cos(a), r * std::sin(a), z};
  }
  std::mt19937 engine_{7};
};

// The floor is seen from above; a ray towards any direction above it may meet the light only.
TEST_P(Offsets, RaysThatLeaveAFloorDoNotMeetItAgain) {
  const SmallScene small(GetParam(), false);
  const SceneCore core(small.view());
  const auto& f = small.floor();
  int left = 0;
  for (int k = 0; k < 200000; ++k) {
    const vec3 target = f[0] + uniform() * (f[1] - f[0]) + uniform() * (f[3] - f[0]);
    const vec3 from = target + GetParam().scale * (vec3(0, 0.7f, 0) + 0.5f * direction());
    Hit hit, again;
    if (!core.intersect({from, normalize(target - from)}, hit)) continue;
    if (hit.emission.r > 0.0f) continue;
    vec3 wi = direction();
    // Every third direction grazes the surface, one in a thousand above the horizon.
    if (k % 3 == 0) wi = normalize(wi - 0.999f * dot(wi, hit.n) * hit.n);
    if (dot(wi, hit.n) <= 1e-5f) continue;
    ++left;
    if (core.intersect(hit.spawnRay(wi), again)) {
      EXPECT_GT(again.emission.r, 0.0f) << k << ": the floor met itself";
    }
  }
  EXPECT_GT(left, 50000);
}

TEST_P(Offsets, ALightIsNotHiddenByItselfNorByItsReceiver) {
  const SmallScene small(GetParam(), false);
  const SceneCore core(small.view());
  const auto& f = small.floor();
  int seen = 0;
  for (int k = 0; k < 200000; ++k) {
    const vec3 target = f[0] + uniform() * (f[1] - f[0]) + uniform() * (f[3] - f[0]);
    Hit hit;
    if (!core.intersect({target + GetParam().scale * vec3(0.01f, 0.7f, 0.02f),
                         normalize(vec3(-0.01f, -0.7f, -0.02f))},
                        hit))
      continue;
    float u = uniform(), v = uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const vec3 p = small.lightPoint() +
                   GetParam().scale * (u * vec3(0.3f, 0.05f, 0.1f) + v * vec3(-0.1f, 0, 0.4f));
    const LightSample sample{p, small.lightNormal(), 1.0f};
    const vec3 toLight = normalize(p - hit.p);
    if (dot(toLight, hit.n) < 1e-3f || dot(-toLight, sample.n) < 1e-3f) continue;
    ++seen;
    EXPECT_TRUE(core.visible(hit, sample)) << k;
  }
  EXPECT_GT(seen, 50000);
}

TEST_P(Offsets, ASphereLightIsNotHiddenByItself) {
  const SmallScene small(GetParam(), true);
  const SceneCore core(small.view());
  const auto& f = small.floor();
  const float radius = 0.1f * GetParam().scale;
  for (int k = 0; k < 200000; ++k) {
    const vec3 target = f[0] + uniform() * (f[1] - f[0]) + uniform() * (f[3] - f[0]);
    Hit hit;
    if (!core.intersect({target + GetParam().scale * vec3(0.01f, 0.7f, 0.02f),
                         normalize(vec3(-0.01f, -0.7f, -0.02f))},
                        hit))
      continue;
    const vec3 n = direction();
    const LightSample sample{small.lightPoint() + radius * n, n, 1.0f};
    if (dot(normalize(hit.p - sample.p), n) < 0.01f) continue;
    EXPECT_TRUE(core.visible(hit, sample)) << k;
  }
}

// What is hidden stays hidden: the offsets are far smaller than the scene.
TEST_P(Offsets, AnOccluderIsNotSkipped) {
  const SmallScene small(GetParam(), false);
  const SceneCore core(small.view());
  Hit below;
  below.n = vec3(0, 1, 0);
  below.p = small.floor()[0] +
            0.5f * ((small.floor()[1] - small.floor()[0]) + (small.floor()[3] - small.floor()[0])) -
            GetParam().scale * vec3(0, 0.01f, 0);
  below.error = 1e-6f * largestComponent(below.p);
  EXPECT_FALSE(core.visible(below, {small.lightPoint(), small.lightNormal(), 1.0f}));
}

INSTANTIATE_TEST_SUITE_P(Placements, Offsets, testing::ValuesIn(kPlacements));

}  // namespace
}  // namespace pathmark::test
