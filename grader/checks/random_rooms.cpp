#include "checks/random_rooms.h"

#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

constexpr double kPiD = std::numbers::pi;

// In units of the light's size, counter-clockwise.
std::vector<glm::dvec2> flatShape(Random& random, LightShape shape) {
  switch (shape) {
    case LightShape::kTriangle:
      return {{-0.6, -0.5}, {0.8, -0.4}, {random.between(-0.5, 0.4), 0.9}};
    case LightShape::kParallelogram: {
      const glm::dvec2 a(-0.8, -0.6), v1(1.3, random.between(-0.2, 0.2)),
          v2(random.between(-0.2, 0.4), 0.9);
      return {a, a + v1, a + v1 + v2, a + v2};
    }
    default:
      break;
  }
  std::vector<glm::dvec2> corners;
  const int count = 4 + random.below(4);
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * kPiD * (k + random.between(0.1, 0.9)) / count;
    corners.emplace_back(0.9 * std::cos(angle), 0.6 * std::sin(angle));
  }
  return corners;
}

RoomLight lightAt(Random& random, LightShape shape, double size, const glm::dvec3& centre,
                  const glm::dvec3& normal) {
  RoomLight light;
  light.emission = randomEmission(random);
  if (shape == LightShape::kSphere) {
    light.centre = Point(centre);
    light.radius = static_cast<float>(0.5 * size);
    return light;
  }
  const DoubleFrame frame(normal);
  for (const glm::dvec2& corner : flatShape(random, shape))
    light.vertices.emplace_back(centre + size * (corner.x * frame.u + corner.y * frame.v));
  return light;
}

struct Facing {
  glm::dvec3 centre, normal;
  double size;
};

Facing facing(const RoomLight& light) {
  Facing result{glm::dvec3(0.0), glm::dvec3(0.0), 0.0};
  for (const Point& v : light.vertices)
    result.centre += glm::dvec3(v) / static_cast<double>(light.vertices.size());
  const glm::dvec3 a(light.vertices[0]);
  result.normal = glm::normalize(
      glm::cross(glm::dvec3(light.vertices[1]) - a, glm::dvec3(light.vertices[2]) - a));
  result.size = std::sqrt(light.area());
  return result;
}

Vector unit(const glm::dvec3& v) { return Vector(glm::normalize(v)); }

}  // namespace

Colour randomEmission(Random& random) {
  const auto channel = [&] { return static_cast<float>(random.between(0.3, 4.0)); };
  const float red = channel(), green = channel();
  return {red, green, channel()};
}

RoomLight makeLight(Random& random, LightShape shape, double size) {
  const glm::dvec3 centre = size * random.between(0.0, 3.0) * glm::dvec3(random.direction());
  const glm::dvec3 normal(random.direction());
  return lightAt(random, shape, size, centre, normal);
}

Receiver place(Random& random, const RoomLight& light, Placement placement, double sine) {
  LitRoom room{{light}, {}, {}};
  Receiver& x = room.receiver;
  for (;;) {
    glm::dvec3 toLight;
    if (light.vertices.empty()) {
      const glm::dvec3 centre(light.centre);
      x.p = Point(centre + double{light.radius} / sine * glm::dvec3(random.direction()));
      toLight = glm::normalize(centre - glm::dvec3(x.p));
    } else {
      const Facing f = facing(light);
      const DoubleFrame frame(f.normal);
      x.p = Point(f.centre + f.size * (random.between(0.7, 2.0) * f.normal +
                                       random.between(-0.8, 0.8) * frame.u +
                                       random.between(-0.8, 0.8) * frame.v));
      toLight = glm::normalize(f.centre - glm::dvec3(x.p));
    }
    if (placement == Placement::kCut) {
      const double low = light.vertices.empty() ? 0.0 : 0.1;
      const double high = light.vertices.empty() ? 0.6 * sine : 0.3;
      x.n = atCosine(Vector(toLight), random.between(low, high), random.between(0.0, 6.28));
    } else {
      x.n = unit(toLight + random.between(0.1, 0.8) * glm::dvec3(random.direction()));
    }
    x.wo = atCosine(x.n, random.between(0.3, 0.95), random.between(0.0, 6.28));
    x.lopsided = placement == Placement::kWhollyLit;
    if (whollyLit(room, placement == Placement::kCut ? 0.0 : 0.1) ==
        (placement == Placement::kWhollyLit))
      return x;
  }
}

RoomLight lightAround(Random& random, const Receiver& receiver, LightShape shape, int k, int n) {
  const DoubleFrame frame{glm::dvec3(receiver.n)};
  const double azimuth = 2.0 * kPiD * (k + random.between(0.45, 0.55)) / n;
  const glm::dvec3 towards =
      frame.direction(std::sin(random.between(25.0, 55.0) * kPiD / 180.0), azimuth);
  const double distance = random.between(1.5, 4.0);
  const glm::dvec3 normal =
      glm::normalize(-towards + random.between(0.0, 0.5) * glm::dvec3(random.direction()));
  RoomLight light =
      lightAt(random, shape, 0.25 * distance, glm::dvec3(receiver.p) + distance * towards, normal);
  const glm::dvec3 radiance = radianceBy(rightKernel, {{light}, {}, receiver});
  const double wanted = random.between(0.5, 1.5);
  light.emission *= static_cast<float>(wanted / (radiance.x + radiance.y + radiance.z));
  return light;
}

}  // namespace pathmark::checks
