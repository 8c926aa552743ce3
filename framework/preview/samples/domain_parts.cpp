#include "preview/samples/domain_parts.h"

namespace pathmark::preview {

vec3 normalOf(const SampleSettings& settings, const glm::dvec3& up) {
  return vec3(glm::normalize(DirectionFrame(up).direction(std::cos(settings.normalTilt * kDegree),
                                                          settings.normalTurn * kDegree)));
}

vec3 outgoingOf(const SampleSettings& settings, const glm::dvec3& normal) {
  return vec3(glm::normalize(DirectionFrame(normal).direction(std::cos(settings.woAngle * kDegree),
                                                              0.25 * std::numbers::pi)));
}

Marginal azimuthMarginal(const std::string& name, const DirectionFrame& frame,
                         std::function<double(double from, double to)> turnMass) {
  constexpr double kTurn = 360.0;
  Marginal marginal;
  marginal.name = name;
  marginal.high = kTurn;
  marginal.coordinate = [frame](const glm::dvec3& d) { return frame.turn(d) * kTurn; };
  marginal.mass = [turnMass = std::move(turnMass)](double from, double to) {
    return turnMass(from / kTurn, to / kTurn);
  };
  return marginal;
}

bool isDirection(const glm::dvec3& d) {
  constexpr double kRounding = 1e-4;
  return std::abs(glm::length(d) - 1.0) < kRounding;
}

Grid gridOf(std::size_t cells) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(cells)));
  return {std::max<std::size_t>(side, 1), std::max<std::size_t>(side, 1)};
}

std::size_t intervalOf(double x, std::size_t intervals) {
  const double place = x * static_cast<double>(intervals);
  return place > 0.0 ? std::min(static_cast<std::size_t>(place), intervals - 1) : 0;
}

}  // namespace pathmark::preview
