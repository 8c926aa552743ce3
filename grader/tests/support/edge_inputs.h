// Inputs at which sampling functions go wrong first.
//
//   kEdgeNumbers     numbers in [0,1) at and next to the ends
//   forEdgePairs, forEdgeTriples   every combination of them
//   FlushDenormals   how render threads treat denormal numbers
//   awkwardNormals   unit vectors on, next to and between the axes
#pragma once

#include "checks/double_frame.h"
#include "tests/support/uniforms.h"

#include <pathmark/types.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace pathmark::testing {

inline constexpr std::array kEdgeNumbers{
    0.0f, std::numeric_limits<float>::denorm_min(), 0x1p-24f, 0.5f, 1.0f - 0x1p-24f,
};

// Render threads flush denormal numbers to zero, programs on their own do not: sampling functions
// must do well either way.
class FlushDenormals {
 public:
#if defined(__SSE__)
  explicit FlushDenormals(bool flush) : before_(_mm_getcsr()) {
    constexpr unsigned kFlushToZero = 0x8000u, kDenormalsAreZero = 0x0040u;
    if (flush) _mm_setcsr(before_ | kFlushToZero | kDenormalsAreZero);
  }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  explicit FlushDenormals(bool) {}
  ~FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  [[maybe_unused]] unsigned before_ = 0;
};

template <typename Function>
void forEdgePairs(Function&& function) {
  for (const bool flush : {false, true}) {
    const FlushDenormals mode(flush);
    for (const float s : kEdgeNumbers)
      for (const float t : kEdgeNumbers) function(s, t);
  }
}

template <typename Function>
void forEdgeTriples(Function&& function) {
  forEdgePairs([&](float s, float t) {
    for (const float u : kEdgeNumbers) function(s, t, u);
  });
}

inline Vector unit(double x, double y, double z) {
  return Vector(glm::normalize(glm::dvec3(x, y, z)));
}

inline Vector randomUnit(Uniforms& random) {
  const double x = random.nextNormal(), y = random.nextNormal();
  return unit(x, y, random.nextNormal());
}

inline std::vector<Vector> awkwardNormals() {
  std::vector<Vector> normals{
      {1, 0, 0},           {0, 1, 0},           {0, 0, 1},           {-1, 0, 0},
      {0, -1, 0},          {0, 0, -1},          unit(1, 1, 1),       unit(-1, 1, -1),
      unit(1e-4, 0, 1),    unit(1e-4, 0, -1),   unit(0, -1e-7, -1),  unit(1e-20, 1e-20, -1),
      unit(1, 1e-4, 1e-9), unit(1e-6, 1, 1e-6), unit(-3, 2, -1e-38), unit(0.6, 0.8, -0.0),
  };
  Uniforms random(0x6e6f726d616c73);
  for (int i = 0; i < 8; ++i) normals.push_back(randomUnit(random));
  return normals;
}

using checks::atCosine;

}  // namespace pathmark::testing
