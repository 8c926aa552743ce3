#include "checks/plates.h"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace pathmark::checks {

namespace {

struct Node {
  glm::dvec3 p;
  double area;
};

// Gauss-Legendre in both directions: kernels of plates that are not near each other are smooth.
template <unsigned kOrder>
std::vector<Node> nodesOf(const Plate& plate) {
  using Gauss = boost::math::quadrature::gauss<double, kOrder>;
  std::vector<std::pair<double, double>> line;  // place in [0,1] and weight
  for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
    const double x = Gauss::abscissa()[k], weight = 0.5 * Gauss::weights()[k];
    line.emplace_back(0.5 + 0.5 * x, weight);
    if (x != 0.0) line.emplace_back(0.5 - 0.5 * x, weight);
  }
  const double area = glm::length(glm::cross(plate.v1, plate.v2));
  std::vector<Node> nodes;
  for (const auto& [s, ws] : line)
    for (const auto& [t, wt] : line)
      nodes.push_back({plate.corner + s * plate.v1 + t * plate.v2, ws * wt * area});
  return nodes;
}

// Density of a uniform direction from x, per area at y, times the factor.
double kernel(const glm::dvec3& x, const glm::dvec3& nx, const glm::dvec3& y, const glm::dvec3& ny,
              const BounceFactor& factor) {
  const glm::dvec3 d = y - x;
  const double r2 = glm::dot(d, d), r = std::sqrt(r2);
  return factor(glm::dot(nx, d) / r) * std::abs(glm::dot(ny, d)) / (r * r2) /
         (2.0 * std::numbers::pi);
}

}  // namespace

double bounce(const glm::dvec3& x, const glm::dvec3& n, const Plate& plate,
              const BounceFactor& factor) {
  double sum = 0.0;
  for (const Node& node : nodesOf<30>(plate))
    sum += node.area * kernel(x, n, node.p, plate.normal, factor);
  return sum;
}

// Nystroem's method: the radiance at the nodes, one hit after the other from the end of the path.
glm::dvec3 betweenPlates(const glm::dvec3& x, const Plate& from, const Plate& to, int hits,
                         const BounceFactor& factor) {
  struct Side {
    const Plate& plate;
    std::vector<Node> nodes;
    std::vector<glm::dvec3> radiance;
  };
  Side here{from, nodesOf<15>(from), {}}, there{to, nodesOf<15>(to), {}};
  for (Side* side : {&here, &there}) side->radiance.assign(side->nodes.size(), glm::dvec3(0.0));
  const auto at = [&](const glm::dvec3& p, const Plate& plate, const Side& other) {
    glm::dvec3 received(0.0);
    for (std::size_t k = 0; k < other.nodes.size(); ++k)
      received += other.nodes[k].area *
                  kernel(p, plate.normal, other.nodes[k].p, other.plate.normal, factor) *
                  other.radiance[k];
    return plate.emission + plate.colour * received;
  };
  const auto after = [&](const Side& side, const Side& other) {
    std::vector<glm::dvec3> radiance;
    for (const Node& node : side.nodes) radiance.push_back(at(node.p, side.plate, other));
    return radiance;
  };
  for (int hit = 1; hit < hits; ++hit) {
    const std::vector<glm::dvec3> a = after(here, there), b = after(there, here);
    here.radiance = a;
    there.radiance = b;
  }
  return at(x, from, there);
}

}  // namespace pathmark::checks
