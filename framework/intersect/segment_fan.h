// SegmentFan: segments from one point to as many others as a vector has lanes.
//
// Against few primitives it is faster to ask of one primitive at a time about all segments than the
// other way round: no lane is empty, and each segment is prepared in its own lane.
#pragma once

#include "intersect/simd.h"

#include <pathmark/types.h>

#include <array>

namespace pathmark {

struct SegmentFan {
  using Mask = FloatV::mask_type;

  Point origin;
  std::array<FloatV, 3> way;  // of each segment, from its start to its end: x, y, z
  Mask lanes;                 // those that have a segment
};

}  // namespace pathmark
