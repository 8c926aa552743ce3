#include "geometry/face_kind.h"

#include "math/rounding.h"

#include <cmath>

namespace pathmark {

namespace {

bool isParallelogram(const Polygon& polygon) {
  if (polygon.vertexCount() != 4) return false;
  // As far from a parallelogram as a scene's rectangles may be, and the rounding of corners.
  constexpr float kTolerance = 2e-5f;
  const Vector gap = (polygon.p(0) - polygon.p(1)) + (polygon.p(2) - polygon.p(3));
  const float extent =
      largestComponent(polygon.p(2) - polygon.p(0)) + largestComponent(polygon.p(3) - polygon.p(1));
  const float rounding = 8.0f * kUnitRoundoff * largestComponent(polygon.p(0));
  return largestComponent(gap) <= kTolerance * extent + rounding;
}

}  // namespace

FaceKind faceKind(const Polygon& polygon) {
  if (polygon.vertexCount() == 3) return FaceKind::kTriangle;
  return isParallelogram(polygon) ? FaceKind::kParallelogram : FaceKind::kPolygon;
}

bool isRectangle(const Polygon& polygon) {
  if (!isParallelogram(polygon)) return false;
  constexpr float kTolerance = 2e-5f;  // of the angle
  const Vector v1 = polygon.p(1) - polygon.p(0), v2 = polygon.p(3) - polygon.p(0);
  return std::abs(dot(v1, v2)) <= kTolerance * length(v1) * length(v2);
}

}  // namespace pathmark
