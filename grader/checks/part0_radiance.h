// What the checks of 0.6 and 0.7 share, and those of means, which have a file of their own.
#pragma once

#include "checks/check.h"
#include "checks/double_frame.h"
#include "checks/plates.h"
#include "checks/points.h"

namespace pathmark::checks {

inline constexpr const char* kOneSided =
    "light is emitted only on the side of the normal; in this part emission is two-sided";

// Places by the axes of a frame, so that no axis of the world is special.
class Setting {
 public:
  Setting(Random& random, double size) : frame_(glm::dvec3(random.direction())), size_(size) {}

  glm::dvec3 at(double x, double y, double z) const {
    return size_ * (x * frame_.u + y * frame_.n + z * frame_.v);
  }
  const glm::dvec3& up() const { return frame_.n; }

  // Its normal is up, or down.
  Plate plate(const glm::dvec3& corner, const glm::dvec3& v1, const glm::dvec3& v2, bool up) const {
    const glm::dvec3 n = glm::normalize(glm::cross(v1, v2));
    return {corner, v1, v2, (glm::dot(n, frame_.n) > 0.0) == up ? n : -n};
  }

 private:
  DoubleFrame frame_;
  double size_;
};

Finding oneBounceInEvenRoom(CheckRun& run);
Finding oneBounceFromLight(CheckRun& run);
Finding pathInEvenRooms(CheckRun& run);
Finding pathBetweenPlates(CheckRun& run);

}  // namespace pathmark::checks
