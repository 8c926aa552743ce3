// Frame: an orthonormal frame around a unit vector, and directions that live in it.
//
// The frame's axes are U, N, V with N = y, as in the coursework notes: a LocalDirection's y is
// the cosine of its angle to N. A LocalDirection is a type of its own, so that a local direction
// cannot be used as one of the world by accident.
#pragma once

#include <pathmark/types.h>

#include <cmath>

namespace pathmark {

struct LocalDirection {
  float x = 0.0f;  // along U
  float y = 1.0f;  // along N
  float z = 0.0f;  // along V
};

class Frame {
 public:
  // n: unit length. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017:
  // no branch and no loss of accuracy for any n, also next to an axis.
  explicit Frame(const Vector& n) : n_(n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    u_ = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    v_ = {b, sign + n.y * n.y * a, -n.y};
  }

  Vector toWorld(const LocalDirection& d) const { return d.x * u_ + d.y * n_ + d.z * v_; }
  LocalDirection toLocal(const Vector& d) const { return {dot(d, u_), dot(d, n_), dot(d, v_)}; }

 private:
  Vector u_, n_, v_;
};

}  // namespace pathmark
