// Which primitives can lie between two points of a scene's surfaces.
//
//   occludersOf     those that can, as far as is easily shown
//   allPrimitives   all
//
// A triangle with the whole scene on one side of its plane cannot: the segment between two points
// of the other side's closed half-space does not cross it. The same holds for a sphere around the
// whole scene. A box's walls are such, and most shadow rays of a coursework scene start in a box.
#pragma once

#include "scene/flat_scene.h"

#include <cstdint>
#include <vector>

namespace pathmark {

struct Occluders {
  std::vector<std::uint32_t> triangles, spheres;  // indices of the scene, ascending
};

Occluders occludersOf(const FlatSceneView& scene);
Occluders allPrimitives(const FlatSceneView& scene);

}  // namespace pathmark
