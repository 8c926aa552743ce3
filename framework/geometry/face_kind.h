// FaceKind: which function of part 2 samples a polygon.
#pragma once

#include <pathmark/shapes.h>

namespace pathmark {

enum class FaceKind {
  kTriangle,       // TriangularSampling
  kParallelogram,  // RectangularSampling
  kPolygon,        // PolygonSampling
};

FaceKind faceKind(const Polygon& polygon);

}  // namespace pathmark
