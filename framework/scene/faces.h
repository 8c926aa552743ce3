// makeFaces: the flat faces of a shape, each with the triangles that cover it.
#pragma once

#include "scene/description.h"
#include "scene/place.h"
#include "scene/triangulate.h"

#include <glm/glm.hpp>

#include <vector>

namespace pathmark {

// How far a rectangle may be from a parallelogram, and a polygon from its plane, relative to the
// longest side of its bounding box: coordinates written with six digits pass.
inline constexpr double kShapeTolerance = 1e-5;

// A planar polygon that is seen, and as part of a light sampled, as one.
struct Face {
  std::vector<glm::dvec3> vertices;
  std::vector<TriangleIndices> triangles;
  glm::dvec3 normal{0.0};  // unit, of the front; zero for a triangle of zero area
};

// Of any shape but a sphere, in normalised coordinates. A quad that is no parallelogram is two
// triangles, (0,1,2) and (0,2,3), and need not be planar; a box has six faces, its vertex k having
// the high x, y and z where bit 0, 1 and 2 of k is set (or, inside out, the low x and the high x
// exchanged); of a mesh every triangle is a face; every other shape is one face. Throws
// SceneError if a rectangle is no parallelogram, a polygon is not planar or not simple, or either
// has no area.
std::vector<Face> makeFaces(const ShapeDescription& shape, const Place& place);

}  // namespace pathmark
