// The framework's own camera rays: for what does not begin with the coursework's renderPixel.
#pragma once

#include <pathmark/camera.h>

#include <cmath>

namespace pathmark {

// The m-th of so many rays through pixel (i, j), where `st` is its place within a stratum: in
// strata like those of part 1, without calling it.
inline Ray cameraRay(const SimpleCamera& camera, int i, int j, int m, int rays, vec2 st) {
  const int n = static_cast<int>(std::sqrt(static_cast<float>(rays)));
  if (m < n * n) st = (vec2(m % n, m / n) + st) / static_cast<float>(n);
  const vec2 film = vec2(i, j) + st;
  return {camera.eye(),
          normalize(camera.topLeft() + film.x * camera.pixelRight() + film.y * camera.pixelDown())};
}

}  // namespace pathmark
