#include "scene/faces.h"

#include "scene/polygon.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace pathmark {
namespace {

Face makeFace(std::vector<glm::dvec3> vertices, std::vector<TriangleIndices> triangles) {
  const glm::dvec3 normal = newellVector(vertices);
  const double length = glm::length(normal);
  return {std::move(vertices), std::move(triangles),
          length > 0.0 ? normal / length : glm::dvec3(0.0)};
}

// Whether the area is that of a point or a line.
bool isFlat(const ShapeDescription& shape, const glm::dvec3& vector) {
  const double size = diameter(shape.vertices);
  return glm::length(vector) <= kFlatArea * size * size;
}

void requireArea(const ShapeDescription& shape, const glm::dvec3& vector, const Place& place) {
  if (isFlat(shape, vector)) {
    place.refuse("vertices that enclose no area",
                 "a rectangle or polygon must not be a point or a line");
  }
}

Face makeRectangle(const ShapeDescription& shape, const Place& place) {
  if (!isParallelogram(shape.vertices, kShapeTolerance)) {
    place.refuse("four vertices that are no parallelogram",
                 "the fourth vertex of a rectangle must be v0 + v2 - v1; a \"quad\" may have any");
  }
  requireArea(shape, newellVector(shape.vertices), place);
  return makeFace(shape.vertices, {{0, 1, 2}, {0, 2, 3}});
}

Face makePolygon(const ShapeDescription& shape, const Place& place) {
  const glm::dvec3 area = newellVector(shape.vertices);
  // The areas of a polygon that crosses itself may cancel.
  const glm::dvec3 vector = isFlat(shape, area) ? acrossVector(shape.vertices) : area;
  requireArea(shape, vector, place);
  const glm::dvec3 normal = glm::normalize(vector);
  const double distance = distanceFromPlane(shape.vertices, normal);
  if (distance > kShapeTolerance * diameter(shape.vertices)) {
    place.refuse("vertices that do not lie in one plane",
                 "a polygon must be planar; build it from triangles instead");
  }
  const Outline outline = project(shape.vertices, normal);
  if (const auto crossing = findCrossing(outline)) {
    const auto [i, j] = *crossing;
    const std::size_t n = outline.size();
    place.refuse(fmt::format("that edge {}-{} meets edge {}-{}", i, (i + 1) % n, j, (j + 1) % n),
                 "a polygon must not touch or cross itself");
  }
  requireArea(shape, area, place);
  auto triangles = triangulate(outline);
  if (!triangles) {
    place.refuse("a polygon that almost touches itself",
                 "it must be simple enough to be cut into triangles");
  }
  return makeFace(shape.vertices, std::move(*triangles));
}

// Seen from outside, these run counter-clockwise.
constexpr std::array<std::array<std::size_t, 4>, 6> kBoxFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

std::vector<Face> makeBox(const ShapeDescription& box) {
  std::vector<Face> faces;
  for (const auto& f : kBoxFaces) {
    const auto& p = box.vertices;
    faces.push_back(makeFace({p[f[0]], p[f[1]], p[f[2]], p[f[3]]}, {{0, 1, 2}, {0, 2, 3}}));
  }
  return faces;
}

std::vector<Face> makeMesh(const ShapeDescription& mesh) {
  std::vector<Face> faces;
  for (const TriangleIndices& t : mesh.triangles) {
    const auto& p = mesh.vertices;
    faces.push_back(makeFace({p[t[0]], p[t[1]], p[t[2]]}, {{0, 1, 2}}));
  }
  return faces;
}

}  // namespace

std::vector<Face> makeFaces(const ShapeDescription& shape, const Place& place) {
  const Place vertices(place, "vertices");
  const auto& p = shape.vertices;
  std::vector<Face> faces;
  switch (shape.kind) {
    case ShapeKind::kTriangle:
      faces.push_back(makeFace(p, {{0, 1, 2}}));
      break;
    case ShapeKind::kQuad:
      if (isParallelogram(p, kShapeTolerance)) {
        faces.push_back(makeFace(p, {{0, 1, 2}, {0, 2, 3}}));
      } else {
        faces.push_back(makeFace({p[0], p[1], p[2]}, {{0, 1, 2}}));
        faces.push_back(makeFace({p[0], p[2], p[3]}, {{0, 1, 2}}));
      }
      break;
    case ShapeKind::kRectangle:
      faces.push_back(makeRectangle(shape, vertices));
      break;
    case ShapeKind::kPolygon:
      faces.push_back(makePolygon(shape, vertices));
      break;
    case ShapeKind::kBox:
      return makeBox(shape);
    case ShapeKind::kMesh:
      return makeMesh(shape);
    case ShapeKind::kSphere:
      break;
  }
  return faces;
}

}  // namespace pathmark
