// Which triangles of a scene share an edge, two by two.
//
//   TrianglePair    two triangles, or one
//   pairTriangles   finds them
//   inNoPairs       leaves every triangle by itself
#pragma once

#include "scene/flat_scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pathmark {

// Triangles a b c and a c d, both with the orientation that they have in the scene.
struct TrianglePair {
  std::array<Float3, 4> corner{};
  std::array<std::uint32_t, 2> triangle{};  // the same twice where there is one triangle only
  bool single = true;                       // and then d = c
  bool flat = true;  // one triangle, or both are a convex quad a b c d in one plane, of one shape
};

// Each of these triangles is in one pair. Partners have the same orientation along their edge, and
// both have backs or neither has. Greedy, in the order of the scene, so that its quads stay
// together.
std::vector<TrianglePair> pairTriangles(const FlatSceneView& scene,
                                        std::span<const std::uint32_t> triangles);

std::vector<TrianglePair> inNoPairs(const FlatSceneView& scene,
                                    std::span<const std::uint32_t> triangles);

}  // namespace pathmark
