// Random numbers, and shapes to build scenes of for tests of intersection.
//
//   RandomNumbers   repeatable
//   ShapeScene      a scene with a shape of both sides (0) and one of fronts only (1)
#pragma once

#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace pathmark::test {

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}

  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_);
  }
  vec3 inCube(float half) {
    return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
  }
  vec3 direction() {
    for (;;) {
      const vec3 v = inCube(1.0f);
      if (length(v) > 0.1f && length(v) < 1.0f) return normalize(v);
    }
  }
  std::array<vec3, 3> axes() {
    const vec3 x = direction(), y = normalize(cross(x, direction()));
    return {x, y, cross(x, y)};
  }

 private:
  std::mt19937 engine_;
};

struct ShapeScene : FlatScene {
  static constexpr std::uint32_t kTwoSided = 0, kFrontOnly = 1;

  ShapeScene() {
    materials.resize(1);
    shapes.resize(2);
    shapes[kFrontOnly].frontOnly = 1;
  }

  FlatSceneView view() const { return viewOf(*this); }

  std::vector<std::uint32_t> allTriangles() const {
    std::vector<std::uint32_t> all(triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  void addTriangle(const vec3& a, const vec3& b, const vec3& c, std::uint32_t shape = kTwoSided) {
    const auto toFloat3 = [](const vec3& v) { return Float3{v.x, v.y, v.z}; };
    FlatScene::addTriangle({toFloat3(a), toFloat3(b), toFloat3(c)},
                           toFloat3(normalize(cross(b - a, c - a))), shape);
  }
  void addQuad(const vec3& a, const vec3& b, const vec3& c, const vec3& d,
               std::uint32_t shape = kTwoSided) {
    addTriangle(a, b, c, shape);
    addTriangle(a, c, d, shape);
  }
  // With fronts on the outside, or on the inside.
  void addBox(const vec3& centre, const std::array<vec3, 3>& halfAxes, bool inward = false,
              std::uint32_t shape = kTwoSided) {
    for (std::size_t k = 0; k < 3; ++k)
      for (const float side : {-1.0f, 1.0f}) {
        const vec3 middle = centre + side * halfAxes[k];
        vec3 u = halfAxes[(k + 1) % 3], v = halfAxes[(k + 2) % 3];
        if ((side < 0.0f) != inward) std::swap(u, v);
        addQuad(middle - u - v, middle + u - v, middle + u + v, middle - u + v, shape);
      }
  }
  void addSphere(const vec3& centre, float radius, bool inward = false,
                 std::uint32_t shape = kTwoSided) {
    spheres.push_back({{centre.x, centre.y, centre.z}, radius, shape, inward ? 1u : 0u});
  }
};

}  // namespace pathmark::test
