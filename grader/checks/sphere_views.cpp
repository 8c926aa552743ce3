#include "checks/sphere_views.h"

#include "checks/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

constexpr double kPiD = std::numbers::pi;

glm::dvec3 axisOf(const SphereView& view) {
  const glm::dvec3 axis(view.oracle.from - view.oracle.centre);
  return glm::dot(axis, axis) > 0.0 ? glm::normalize(axis) : glm::dvec3(0, 1, 0);
}

// 1 - cos(alpha), alpha at the centre between the viewer and the point with normal n.
double heightFrom(const SphereView& view, const Vector& n) {
  const glm::dvec3 across = glm::normalize(glm::dvec3(n)) - axisOf(view);
  return 0.5 * glm::dot(across, across);
}

struct Formula {
  const char* mistake;
  double (*density)(const SphereView& view, const Vector& n);
};

double coneOf(const SphereView& v) {
  return 2.0 * kPiD * static_cast<double>(v.oracle.oneMinusCosMax);
}

double distance2Of(const SphereView& v, const Vector& n) {
  const auto w = v.oracle.toViewer(n);
  return static_cast<double>(glm::dot(w, w));
}

constexpr Formula kFormulas[] = {
    {"the density is that per unit solid angle: the factor cos(theta') / |x' - x|^2 makes it one "
     "per unit area",
     [](const SphereView& v, const Vector&) { return 1.0 / coneOf(v); }},
    {"the distance to the centre stands where that to the sampled point belongs",
     [](const SphereView& v, const Vector& n) {
       return static_cast<double>(v.oracle.cosAtPoint(n) / (v.oracle.d * v.oracle.d)) / coneOf(v);
     }},
    {"cos(theta') is missing from the density",
     [](const SphereView& v, const Vector& n) { return 1.0 / (distance2Of(v, n) * coneOf(v)); }},
    {"the distance is not squared",
     [](const SphereView& v, const Vector& n) {
       return static_cast<double>(v.oracle.cosAtPoint(n)) /
              (std::sqrt(distance2Of(v, n)) * coneOf(v));
     }},
    {"the points do not have the density 1/(4 pi r^2) that is returned: it is that of points "
     "uniform over the whole area",
     [](const SphereView& v, const Vector&) {
       return static_cast<double>(1.0L / (v.oracle.r * v.oracle.r)) / (4.0 * kPiD);
     }},
    {"the solid angle of the cone is 2 pi (1 - cos(thetaMax)): the factor 2 or pi is wrong",
     [](const SphereView& v, const Vector& n) {
       return 0.5 * static_cast<double>(v.oracle.pdf(n));
     }},
    {"the solid angle of the cone is 2 pi (1 - cos(thetaMax)): the factor 2 is missing",
     [](const SphereView& v, const Vector& n) {
       return 2.0 * static_cast<double>(v.oracle.pdf(n));
     }},
    {"r / |x - c| is the sine of thetaMax, and not its tangent",
     [](const SphereView& v, const Vector& n) {
       const double tangent = v.ratio(), inverse = 1.0 / std::sqrt(1.0 + tangent * tangent);
       const double oneMinusCos = tangent * tangent * inverse * inverse / (1.0 + inverse);
       return static_cast<double>(v.oracle.pdf(n) * v.oracle.oneMinusCosMax) / oneMinusCos;
     }},
};

}  // namespace

std::string SphereView::text() const {
  const char* place = oracle.d > oracle.r   ? ""
                      : oracle.d < oracle.r ? " (inside the sphere)"
                                            : " (exactly on the sphere)";
  return fmt::format("centre = {}, r = {:.6g}, from = {}{}", checks::text(centre), radius,
                     checks::text(from), place);
}

double SphereView::magnitude() const {
  double largest = double{radius};
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, std::abs(double{centre[axis]}), std::abs(double{from[axis]})});
  return largest;
}

double SphereView::tolerance(const Vector& n) const {
  if (!oracle.outside()) return relativeTolerance();
  const double coordinates = std::max(magnitude() / static_cast<double>(oracle.d), 1.0);
  return relativeTolerance(oracle.condition(n) * coordinates);
}

std::vector<SphereView> viewsFromOutside(std::uint64_t seed) {
  std::vector<SphereView> views{{{0, 0, 0}, 2.0f, {0, 5, 0}}, {{1, 2, 3}, 2.0f, {4, 2, 3}}};
  Random random(seed);
  for (const double ratio :
       {0.5, 0.1, 0.9, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 0.99, 1 - 1e-3, 1 - 1e-4}) {
    views.emplace_back(Point(0), 1.0f, Point(glm::dvec3(random.direction()) / ratio));
    // The smallest and the largest lengths in turn.
    const double radius = views.size() % 4 == 0 ? 1e-6 : 1e6 * ratio;
    const Point centre(std::min(radius, 1e5) * random.between(0.0, 4.0) *
                       glm::dvec3(random.direction()));
    views.emplace_back(centre, static_cast<float>(radius),
                       Point(glm::dvec3(centre) + radius / ratio * glm::dvec3(random.direction())));
  }
  return views;
}

std::vector<SphereView> viewsAlongAxes() {
  const Point centre(1, 2, 3);
  std::vector<SphereView> views;
  for (const float side : {2.0f, -2.0f})
    for (int axis = 0; axis < 3; ++axis) {
      Vector off(0.0f);
      off[axis] = side;
      views.emplace_back(centre, 1.0f, centre + off);
    }
  for (const float side : {2.0f, -2.0f})
    for (const float tilt : {2e-4f, 2e-7f})
      for (int axis = 0; axis < 3; ++axis) {
        Vector off(0.6f * tilt, 0.8f * tilt, side);
        std::swap(off[axis], off[2]);
        views.emplace_back(Point(0), 1.0f, off);
      }
  return views;
}

std::vector<SphereView> viewsFromInside(std::uint64_t seed) {
  std::vector<SphereView> views{{{0, 0, 0}, 2.0f, {0, 1, 0}},
                                {{1, 2, 3}, 2.0f, {1, 2, 3}},
                                {{0, 0, 0}, 2.0f, {0, 2, 0}},
                                {{1, 2, 3}, 2.0f, {3, 2, 3}},
                                {{0, 0, 0}, 1e-6f, {0, 0, -1e-6f}}};
  Random random(seed + 1);
  for (const double radius : {1e-6, 30.0, 1e6}) {
    const Point centre(radius * random.between(0.0, 4.0) * glm::dvec3(random.direction()));
    views.emplace_back(centre, static_cast<float>(radius),
                       Point(glm::dvec3(centre) +
                             radius * random.between(0.0, 0.9) * glm::dvec3(random.direction())));
  }
  return views;
}

double SphereReference::density(const Vector& n) const {
  if (kind == Kind::kCone) return static_cast<double>(view.oracle.pdf(n));
  const double whole = 4.0 * kPiD * double{view.radius} * double{view.radius};
  if (kind == Kind::kWhole) return 1.0 / whole;
  const double height = static_cast<double>((view.oracle.d - view.oracle.r) / view.oracle.d);
  return heightFrom(view, n) < height ? 2.0 / (whole * height) : 0.0;
}

double SphereReference::fraction(const Vector& n) const {
  if (kind == Kind::kCone) return view.oracle.coneFraction(n);
  if (kind == Kind::kWhole) return 0.5 * heightFrom(view, n);
  return heightFrom(view, n) / static_cast<double>((view.oracle.d - view.oracle.r) / view.oracle.d);
}

void DensitySuspects::see(const SphereView& view, const Vector& n, double density) {
  static_assert(std::size(kFormulas) == kCount);
  constexpr double kSame = 1e-3, kOther = 1e-2;
  const double right = static_cast<double>(view.oracle.pdf(n));
  if (!view.oracle.outside() || view.tolerance(n) > kSame || !(right > 0.0)) return;
  for (std::size_t k = 0; k < kCount; ++k) {
    const double suspected = kFormulas[k].density(view, n);
    if (!(std::abs(density - suspected) <= kSame * suspected)) excluded_[k] = true;
    if (std::abs(suspected - right) > kOther * right) differs_[k] = true;
  }
}

std::string DensitySuspects::cause() const {
  std::string found;
  for (std::size_t k = 0; k < kCount; ++k) {
    if (excluded_[k] || !differs_[k]) continue;
    if (!found.empty()) return {};
    found = kFormulas[k].mistake;
  }
  return found;
}

}  // namespace pathmark::checks
