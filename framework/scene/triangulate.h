// triangulate: triangles that cover a simple polygon exactly once.
#pragma once

#include "scene/polygon.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pathmark {

using TriangleIndices = std::array<std::uint32_t, 3>;

// Ear clipping (Meisters 1975) of a simple counter-clockwise polygon, convex or not, straight
// angles allowed: n - 2 counter-clockwise triangles of positive area whose corners are vertices of
// the polygon. Nothing if rounding leaves no ear, or if the triangles' areas do not sum to the
// polygon's, as for a polygon that is not simple.
std::optional<std::vector<TriangleIndices>> triangulate(const Outline& outline);

}  // namespace pathmark
