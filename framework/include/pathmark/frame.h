// Frame: an orthonormal frame around a unit vector, and directions that live in it.
//
//   Frame             between the world and a frame around a normal
//   LocalDirection    a direction in it
//   onUnitCircle      the cosine and sine of an azimuth
//
// The frame's axes are U, N, V with N = y, as in the coursework notes: a LocalDirection's y is
// the cosine of its angle to N. A LocalDirection is a type of its own, so that a local direction
// cannot be used as one of the world by accident.
#pragma once

#include <pathmark/types.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace pathmark {

struct LocalDirection {
  float x = 0.0f;  // along U
  float y = 1.0f;  // along N
  float z = 0.0f;  // along V
};

class Frame {
 public:
  // n: unit length; U x V = N. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1),
  // 2017: no branch and no loss of accuracy for any n, also next to an axis.
  explicit Frame(const Vector& n) : n_(n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    u_ = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    v_ = {b, sign + n.y * n.y * a, -n.y};
  }

  // Both are linear and keep lengths and angles; the argument may have any length.
  Vector toWorld(const LocalDirection& d) const { return d.x * u_ + d.y * n_ + d.z * v_; }
  LocalDirection toLocal(const Vector& d) const { return {dot(d, u_), dot(d, n_), dot(d, v_)}; }

 private:
  Vector u_, n_, v_;
};

// (cos(2 pi turn), sin(2 pi turn)) for turn in [0,1], each within 1.5 units in the last place of 1;
// exact at quarter turns. Without branches, which no processor can predict for a random azimuth:
// polynomials for the eighth of a turn around each axis, with the smallest largest error, whose
// values are exchanged and whose signs are set bit by bit.
inline vec2 onUnitCircle(float turn) {
  const int quarter = static_cast<int>(4.0f * turn + 0.5f);
  const float x = 2.0f * kPi * (turn - 0.25f * static_cast<float>(quarter)), x2 = x * x;
  const float sine =
      x + x * x2 * (-1.666665494e-1f + x2 * (8.332178098e-3f + x2 * -1.951729231e-4f));
  const float cosine = 1.0f - 0.5f * x2 +
                       x2 * x2 * (4.166664687e-2f + x2 * (-1.388736746e-3f + x2 * 2.443844460e-5f));
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  const auto turns = static_cast<std::uint32_t>(quarter);
  const std::uint32_t exchange = (bits(cosine) ^ bits(sine)) & (0u - (turns & 1u));
  return {std::bit_cast<float>(bits(cosine) ^ exchange ^ (((turns + 1u) & 2u) << 30)),
          std::bit_cast<float>(bits(sine) ^ exchange ^ ((turns & 2u) << 30))};
}

}  // namespace pathmark
