// Which functions sample a polygon: faceKind() says which of part 2, isRectangle() which of part 9.
#pragma once

#include <pathmark/shapes.h>

namespace pathmark {

enum class FaceKind {
  kTriangle,       // TriangularSampling
  kParallelogram,  // RectangularSampling
  kPolygon,        // PolygonSampling
};

FaceKind faceKind(const Polygon& polygon);

// A parallelogram with right angles.
bool isRectangle(const Polygon& polygon);

}  // namespace pathmark
