// PixelQuestion: a pixel whose rays are asked for, and recorded.
#pragma once

#include "checks/film_point.h"
#include "host/worker_process.h"

#include <cstdint>
#include <string>

namespace pathmark::checks {

// The n of the n x n strata that a pixel with so many rays has.
int strataPerSide(int rays);

// A pixel of a camera, and with which random numbers it is asked for.
struct PixelQuestion {
  SimpleCamera camera;
  int i, j, rays;
  RecordedNumbers numbers = RecordedNumbers::kRandom;
  float constant = 0.0f;
  std::uint64_t seed = 0;

  RecordedPixel ask(WorkerProcess& worker) const;
  std::string text() const;

  // In pixels, from the pixel's top left corner.
  glm::dvec2 placeOf(const RecordedRay& ray) const;
  double tolerance() const { return filmTolerance(camera, i + 1, j + 1); }
};

}  // namespace pathmark::checks
