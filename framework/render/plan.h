// Plan: how rays are answered in a scene, decided once when it is loaded.
//
//   planFor   from a scene to its plan; explain_plan.h puts it into words
//
// What a scene does not need is left out here, so that the inner loop need not ask.
#pragma once

#include "render/skips.h"
#include "scene/flat_scene.h"

#include <cstdint>
#include <vector>

namespace pathmark {

// From this many pairs and single triangles on Embree's hierarchy makes a render faster than the
// flat loop does: `pathmark bench skip --rooms` measures it.
inline constexpr std::size_t kFewestForHierarchy = 112;

enum class TriangleTest { kNone, kFlatLoop, kHierarchy };

// From where shadow rays start.
enum class ShadowOrigins {
  kSurfaces,  // points of the scene's surfaces, as in a render
  kAnywhere,  // points that somebody has made up, as in tests of single functions
};

// How the flat loop asks for its primitives.
struct FlatTests {
  bool pairs = true;            // two triangles that make a quad as one
  bool backsOfAll = false;      // backs, even if no triangle has a front only
  bool kindsOfNothing = false;  // for spheres and triangles, even if there are none
};

struct Plan {
  TriangleTest triangles = TriangleTest::kNone;

  // Primitives that shadow rays are tested against beside the hierarchy, which has all triangles.
  std::vector<std::uint32_t> occludingTriangles, occludingSpheres;

  FlatTests flatTests;

  bool cameraRaysTogether = false;  // those of a pixel are traced before their paths ask for them
};

Plan planFor(const FlatSceneView& scene, ShadowOrigins origins = ShadowOrigins::kSurfaces,
             Skips skips = {});

}  // namespace pathmark
