#include "checks/part1_checks.h"

#include "checks/all_checks.h"
#include "checks/exact.h"

#include <fmt/format.h>

namespace pathmark::checks {

std::vector<SimpleCamera> filmCameras() {
  return {
      {{0, 0, 0}, {-1, 0.75f, -1}, {0.25f, 0, 0}, {0, -0.25f, 0}, 8, 6},
      {{1, 2, 3}, {-0.3f, 0.9f, -1.2f}, {0.02f, 0.001f, 0.004f}, {0.003f, -0.03f, 0}, 40, 30},
      {{500, -20, 1e4f}, {30, 20, 80}, {-0.9f, 0.1f, 0}, {0.05f, -0.6f, -0.2f}, 48, 64},
  };
}

std::string text(const SimpleCamera& camera) {
  return fmt::format("camera with eye = {}, topLeft = {}, pixelRight = {}, pixelDown = {}",
                     text(camera.eye()), text(camera.topLeft()), text(camera.pixelRight()),
                     text(camera.pixelDown()));
}

std::span<const Check> part1Checks() {
  static const std::vector<Check> kChecks = [] {
    std::vector<Check> all = part1RayChecks();
    for (const Check& check : part1PixelChecks()) all.push_back(check);
    return all;
  }();
  return kChecks;
}

}  // namespace pathmark::checks
