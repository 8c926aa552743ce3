#include "checks/points.h"

#include "sampling/mix.h"

#include <cmath>
#include <numbers>

namespace pathmark::checks {

Random::Random(std::uint64_t seed) : state_(mix(seed + kGolden)) {}

std::uint32_t Random::bits() {
  state_ += kGolden;
  return static_cast<std::uint32_t>(mix(state_) >> 32);
}

double Random::number() {
  state_ += kGolden;
  return static_cast<double>(mix(state_) >> 11) * 0x1p-53;
}

float Random::uniform() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }

Vector Random::direction() {
  return Vector(DoubleFrame(glm::dvec3(0, 0, 1))
                    .direction(between(-1.0, 1.0), between(0.0, 2.0 * std::numbers::pi)));
}

std::vector<Vector> awkwardNormals(std::uint64_t seed) {
  const auto unit = [](double x, double y, double z) {
    return Vector(glm::normalize(glm::dvec3(x, y, z)));
  };
  std::vector<Vector> normals{
      {0, 1, 0},         {0, 0, -1},         {1, 0, 0},           {0, 0, 1},
      {-1, 0, 0},        {0, -1, 0},         unit(1, 1, 1),       unit(-3, 2, -1e-38),
      unit(1e-4, 0, -1), unit(0, -1e-7, -1), unit(1, 1e-4, 1e-9), unit(1e-6, 1, 1e-6),
  };
  Random random(seed);
  for (int k = 0; k < 4; ++k) normals.push_back(random.direction());
  return normals;
}

}  // namespace pathmark::checks
