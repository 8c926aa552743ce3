#include "checks/pixel_question.h"

#include <fmt/format.h>

namespace pathmark::checks {

int strataPerSide(int rays) {
  int n = 0;
  while ((n + 1) * (n + 1) <= rays) ++n;
  return n;
}

RecordedPixel PixelQuestion::ask(WorkerProcess& worker) const {
  RecordPixelRequest request;
  float* to = request.camera;
  for (const vec3& v : {camera.eye(), camera.topLeft(), camera.pixelRight(), camera.pixelDown()})
    for (int c = 0; c < 3; ++c) *to++ = v[c];
  request.width = camera.width();
  request.height = camera.height();
  request.i = i;
  request.j = j;
  request.rays = rays;
  request.numbers = numbers;
  request.constant = constant;
  request.seed = seed;
  return worker.recordPixel(request);
}

std::string PixelQuestion::text() const {
  const std::string source = numbers == RecordedNumbers::kRandom
                                 ? std::string("random numbers")
                                 : fmt::format("all random numbers {:.8g}", constant);
  return fmt::format("column i = {}, row j = {}, {} {}, {}", i, j, rays, rays == 1 ? "ray" : "rays",
                     source);
}

glm::dvec2 PixelQuestion::placeOf(const RecordedRay& ray) const {
  const Vector d(ray.direction[0], ray.direction[1], ray.direction[2]);
  return filmPoint(camera, d) - glm::dvec2(i, j);
}

}  // namespace pathmark::checks
