#include "checks/phong_quadrature.h"

#include <array>

namespace pathmark::checks {

namespace {

constexpr double kPiD = std::numbers::pi;

// Nodes and weights of the 8-point rule on [-1,1] (Abramowitz & Stegun, table 25.4).
constexpr std::array<std::array<double, 2>, 4> kGauss8{{
    {0.183434642495649804939, 0.362683783378361982965},
    {0.525532409916328985818, 0.313706645877887287338},
    {0.796666477413626739592, 0.222381034453374470544},
    {0.960289856497536231684, 0.101228536290376259153},
}};

template <typename Visit>
void gauss(double a, double b, Visit&& visit) {
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  for (const auto& [node, weight] : kGauss8) {
    visit(middle - half * node, half * weight);
    visit(middle + half * node, half * weight);
  }
}

// With the nodes crowded at both ends, by x = a + (b - a) y^2 (3 - 2 y): square roots at the ends
// of the interval become smooth in y.
template <typename Visit>
void gaussBetweenRoots(double a, double b, Visit&& visit) {
  gauss(0.0, 1.0, [&](double y, double weight) {
    visit(a + (b - a) * y * y * (3.0 - 2.0 * y), weight * (b - a) * 6.0 * y * (1.0 - y));
  });
}

double angleOfQuantile(double v, double m) {
  const double logCos = std::log(v) / (m + 1.0);
  return std::asin(std::sqrt(-std::expm1(2.0 * logCos)));
}

// Where the integrand has an edge, or the lobe falls by orders of magnitude.
std::vector<double> alphaEdges(const PhongFrame& frame) {
  const double thetaR = std::atan2(frame.sinR, frame.cosR);
  std::vector<double> edges{0.0, 0.5 * kPiD, kPiD, 0.5 * kPiD - thetaR, 0.5 * kPiD + thetaR};
  for (const double v : {0.75, 0.5, 0.25, 0.03, 1e-4, 1e-9})
    edges.push_back(angleOfQuantile(v, frame.m));
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

PhongFrame::PhongFrame(const PhongLobes& lobes)
    : mirror(lobes.mirror), cosR(glm::dot(lobes.mirror, lobes.n)), m(lobes.m) {
  across = glm::cross(lobes.n, lobes.mirror);
  sinR = glm::length(across);
  constexpr double kNoPlane = 1e-9;
  if (sinR < kNoPlane) {
    const glm::dvec3 other = std::abs(mirror.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    across = glm::cross(mirror, other);
  }
  across = glm::normalize(across);
  inPlane = glm::cross(mirror, across);
  tangent = glm::cross(across, lobes.n);
}

glm::dvec3 PhongFrame::direction(double alpha, double azimuth) const {
  return std::cos(alpha) * mirror +
         std::sin(alpha) * (std::cos(azimuth) * inPlane + std::sin(azimuth) * across);
}

double PhongFrame::azimuth(const glm::dvec3& wi) const {
  return std::atan2(glm::dot(wi, across), glm::dot(wi, inPlane));
}

double PhongFrame::lobeQuantile(const glm::dvec3& wi) const {
  const double c = glm::dot(wi, mirror);
  return c > 0.0 ? std::min(std::pow(c, m + 1.0), 1.0) : 0.0;
}

std::size_t PhongFrame::cellOf(const glm::dvec3& wi) const {
  const int ring = glm::dot(wi, mirror) > 0.0
                       ? std::min(static_cast<int>(4.0 * (1.0 - lobeQuantile(wi))), 3)
                       : 4;
  const double turn = azimuth(wi) / (2.0 * kPiD) + 0.5;
  const int sector = std::clamp(static_cast<int>(turn * kSectors), 0, kSectors - 1);
  return static_cast<std::size_t>(ring * kSectors + sector);
}

std::vector<PhongNode> phongNodes(const PhongLobes& lobes) {
  const PhongFrame frame(lobes);
  const std::vector<double> edges = alphaEdges(frame);
  std::vector<PhongNode> nodes;
  const auto sector = [&](double alpha, double weight, double from, double to, bool above) {
    if (!(from < to)) return;
    gauss(from, to, [&](double azimuth, double width) {
      const glm::dvec3 wi = frame.direction(alpha, azimuth);
      nodes.push_back({wi, weight * width, above, frame.cellOf(wi)});
    });
  };
  const auto ring = [&](double alpha, double width) {
    // Above the surface: cos(alpha) cosR + sin(alpha) sinR cos(azimuth) > 0.
    const double rise = std::sin(alpha) * frame.sinR, level = std::cos(alpha) * frame.cosR;
    const double horizon =
        std::acos(std::clamp(rise > 0.0 ? -level / rise : (level > 0.0 ? -1.0 : 1.0), -1.0, 1.0));
    const double weight = width * std::sin(alpha);
    for (int k = 0; k < PhongFrame::kSectors; ++k) {
      const double from = 0.5 * kPiD * k - kPiD, to = from + 0.5 * kPiD;
      sector(alpha, weight, std::max(from, -horizon), std::min(to, horizon), true);
      sector(alpha, weight, from, std::min(to, -horizon), false);
      sector(alpha, weight, std::max(from, horizon), to, false);
    }
  };
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    if (edges[i + 1] - edges[i] > 1e-12) gaussBetweenRoots(edges[i], edges[i + 1], ring);
  return nodes;
}

}  // namespace pathmark::checks
