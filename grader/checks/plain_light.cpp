#include "checks/plain_light.h"

namespace pathmark::checks {

RoomLight plainLight(LightShape shape) {
  RoomLight light{.emission = kPlainEmission};
  switch (shape) {
    case LightShape::kTriangle:
      light.vertices = {{0, 2, 0}, {2, 2, 0}, {0, 2, 3}};
      break;
    case LightShape::kParallelogram:
      light.vertices = {{-1, 2, -1}, {1, 2, -1}, {1, 2, 0.5f}, {-1, 2, 0.5f}};
      break;
    case LightShape::kPolygon:
      light.vertices = {{-1, 2, -1}, {2, 2, -1}, {1, 2, 1}, {-1, 2, 0.5f}};
      break;
    case LightShape::kSphere:
      light.centre = {0, 2, 0};
      light.radius = 0.8f;
  }
  return light;
}

}  // namespace pathmark::checks
