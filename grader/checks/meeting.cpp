#include "checks/meeting.h"

#include "checks/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

// Roundings of a textbook solution in float add up to this many, relative to the largest term.
constexpr double kRoundings = 16.0 * 0x1p-24;

constexpr double kEdge = 1e-5;  // the contract's leave

constexpr double kShortest = 1e-6;  // length that coursework gets in a direct call

double largest(const Point& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

}  // namespace

// Cramer's rule, as in Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
Meeting meet(const Ray& ray, const Corners& corners) {
  const glm::dvec3 a(corners[0]), e1 = glm::dvec3(corners[1]) - a, e2 = glm::dvec3(corners[2]) - a;
  const glm::dvec3 d(ray.direction), s = glm::dvec3(ray.origin) - a;
  const glm::dvec3 q = glm::cross(d, e2), r = glm::cross(s, e1);
  Meeting m;
  m.determinant = glm::dot(e1, q);
  m.b1 = glm::dot(s, q) / m.determinant;
  m.b2 = glm::dot(d, r) / m.determinant;
  m.t = glm::dot(e2, r) / m.determinant;

  // The point of the plane is known to about `magnitude` roundoffs over the cosine of incidence,
  // for a solution that forms it; barycentric coordinates from scalar products of the edges
  // (a Gram determinant) lose the squared ratio of edge and height besides.
  const double twiceArea = glm::length(glm::cross(e1, e2));
  const double longest = std::max({glm::length(e1), glm::length(e2), glm::length(e2 - e1)});
  const double height = twiceArea / longest, cosine = std::abs(m.determinant) / twiceArea;
  double magnitude = largest(ray.origin);
  for (const Point& p : corners) magnitude = std::max(magnitude, largest(p));
  const double shape = longest / height;
  m.slack = std::max(kEdge, kRoundings * (magnitude / (height * cosine) + shape * shape));
  m.tError = relativeTolerance(magnitude / std::abs(m.t) * shape / cosine) * std::abs(m.t);
  return m;
}

// A border of the parallelogram b1, b2 in [0,1] is unclear too, so that suspects are never in
// doubt.
bool Meeting::clear() const {
  const double nearest = std::min({std::abs(b1), std::abs(b2), std::abs(1.0 - b1 - b2),
                                   std::abs(1.0 - b1), std::abs(1.0 - b2)});
  return nearest > slack && tError < 0.01 * std::abs(t);
}

RayAndTriangle randomMeeting(Random& random, double size, double shift, double shape) {
  const DoubleFrame frame{glm::dvec3(random.direction())};
  const auto inPlane = [&](double x, double y) { return size * (x * frame.u + y * frame.v); };
  const glm::dvec3 centre = size * shift * glm::dvec3(random.direction());
  const glm::dvec3 p[3] = {
      centre, centre + inPlane(random.between(0.5, 1.5), 0.0),
      centre + inPlane(random.between(-0.2, 1.2), shape * random.between(0.6, 1.4))};
  RayAndTriangle result;
  const auto first = static_cast<std::size_t>(random.below(3));
  const bool turned = random.below(2) == 0;
  for (std::size_t i = 0; i < 3; ++i)
    result.corners[i] = Point(p[(first + (turned ? 3 - i : i)) % 3]);

  const double b1 = random.between(-0.4, 1.4), b2 = random.between(-0.4, 1.4);
  const glm::dvec3 target = p[0] + b1 * (p[1] - p[0]) + b2 * (p[2] - p[0]);
  const double cosine = random.between(0.1, 1.0) * (random.below(2) == 0 ? 1.0 : -1.0);
  const glm::dvec3 d = frame.direction(cosine, random.between(0.0, 2.0 * std::numbers::pi));
  // From near to far, so that a small t and a small determinant do not come together.
  const double distance = std::max(size * std::exp2(random.between(-5.0, 4.0)), kShortest) *
                          (random.below(4) == 0 ? -1.0 : 1.0);
  result.ray = {Point(target - distance * d), Vector(d)};
  return result;
}

std::string text(const Ray& ray) {
  return fmt::format("ray from {} along {}", text(ray.origin), text(ray.direction));
}

std::string text(const Corners& corners) {
  return fmt::format("triangle {}, {}, {}", text(corners[0]), text(corners[1]), text(corners[2]));
}

}  // namespace pathmark::checks
