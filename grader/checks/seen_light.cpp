#include "checks/seen_light.h"

#include "checks/exact.h"

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pathmark::checks {

namespace {

using L = long double;

constexpr double kRoundoff = 0x1p-24;

L lengthOf(const LongVector& a) { return std::sqrt(glm::dot(a, a)); }

// Van Oosterom & Strackee 1983, by the edges, so that nothing cancels.
L solidAngle(const LongVector& a, const LongVector& b, const LongVector& c) {
  const L la = lengthOf(a), lb = lengthOf(b), lc = lengthOf(c);
  const L volume = std::abs(glm::dot(a, glm::cross(b - a, c - a)));
  return 2.0L * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                       glm::dot(a, c) * lb);
}

// 1 - cos of the angle between two vectors.
L oneMinusCos(const LongVector& a, const LongVector& b) {
  const LongVector chord = a / lengthOf(a) - b / lengthOf(b);
  return 0.5L * glm::dot(chord, chord);
}

LongVector between(const Point& p, const Point& from) { return LongVector(p) - LongVector(from); }

double within(L x) { return static_cast<double>(std::clamp(x, 0.0L, 1.0L)); }

}  // namespace

SeenLight::SeenLight(std::string what, std::vector<Point> vertices, const Point& from)
    : what_(std::move(what)), outline_(std::move(vertices)), from_(from) {
  for (const Point& p : outline_.vertices()) v_.push_back(between(p, from));
  omega_ = solidAngle(v_[0], v_[1], v_[2]);
  if (v_.size() == 4) omega_ += solidAngle(v_[0], v_[2], v_[3]);
  const LongVector n = glm::cross(v_[1] - v_[0], v_.back() - v_[0]);
  height_ = -glm::dot(v_[0], n) / lengthOf(n);
}

std::string SeenLight::text() const {
  return fmt::format("{}, from = {}, {} (solid angle {:.3g})", outline_.text(), checks::text(from_),
                     what_, omega());
}

double SeenLight::density(const Point& p) const {
  const L r = lengthOf(between(p, from_));
  return static_cast<double>(height_ / (r * r * r * omega_));
}

double SeenLight::tolerance(const Point& p) const {
  const auto condition = static_cast<double>(lengthOf(between(p, from_)) / height_);
  return relativeTolerance(1.0 + condition) + angleTolerance() / omega();
}

// An angle as the arc cosine of a rounded cosine has an error of that rounding over its sine: it
// counts where a corner is narrow.
double SeenLight::angleTolerance() const {
  constexpr double kOfAngles = 4e-6;
  L sum = 0.0L;
  for (std::size_t k = 0; k < v_.size(); ++k) {
    const LongVector& corner = v_[k];
    const LongVector out = glm::cross(corner, v_[(k + 1) % v_.size()]),
                     in = glm::cross(corner, v_[(k + v_.size() - 1) % v_.size()]);
    sum += lengthOf(out) * lengthOf(in) / lengthOf(glm::cross(out, in));
  }
  return std::max(kOfAngles, 2.0 * kRoundoff * static_cast<double>(sum));
}

// From afar the direction is rounded too.
double SeenLight::planeTolerance() const {
  const double reach = glm::length(glm::dvec3(from_));
  return 64.0 * kRoundoff *
         (mustBeUniform() ? std::max(outline_.magnitude(), reach) : outline_.magnitude());
}

// A share of a sum of angles ends angleTolerance() too far at most: a wedge from a corner along an
// edge that fills the angle a has the solid angle 1 - cos(a) for each unit of its own angle, and
// its far end is sin(a) for each, so that it is moved by angleTolerance() / tan(a / 2). The plane
// stretches an angle by r^2 / height.
double SeenLight::edgeTolerance(const Point& p) const {
  if (!mustBeUniform()) return planeTolerance();
  L halfTangent2 = std::numeric_limits<L>::infinity();  // of the edge that looks shortest
  for (std::size_t k = 0; k < v_.size(); ++k) {
    const L h = oneMinusCos(v_[k], v_[(k + 1) % v_.size()]);
    halfTangent2 = std::min(halfTangent2, h / std::max(2.0L - h, 1e-12L));
  }
  const LongVector toPoint = between(p, from_);
  const L stretch = glm::dot(toPoint, toPoint) / height_;
  return planeTolerance() +
         angleTolerance() * static_cast<double>(stretch / std::sqrt(halfTangent2));
}

double SeenLight::offPlane(const Point& p) const {
  const LongVector n = glm::cross(v_[1] - v_[0], v_.back() - v_[0]);
  return static_cast<double>(std::abs(glm::dot(between(p, from_) - v_[0], n)) / lengthOf(n));
}

// The plane through v1 and p cuts the edge from v0 to v2 at c.
std::array<double, 2> SeenLight::triangleFractions(const LongVector& p) const {
  const LongVector e1 = v_[1] - v_[0], e2 = v_[2] - v_[0], d = p - v_[0], n = glm::cross(e1, e2);
  const L b1 = glm::dot(glm::cross(d, e2), n), b2 = glm::dot(glm::cross(e1, d), n);
  const L b0 = glm::dot(n, n) - b1 - b2;
  const LongVector c = v_[0] + (b0 + b2 != 0.0L ? b2 / (b0 + b2) : 0.0L) * e2;
  const L whole = oneMinusCos(v_[1], c);
  return {within(solidAngle(v_[0], v_[1], c) / omega_),
          within(whole > 0.0L ? oneMinusCos(v_[1], p) / whole : 0.0L)};
}

// The plane through p along v2 cuts off a rectangle; within it the sine of the angle to the plane
// across is uniform.
std::array<double, 2> SeenLight::rectangleFractions(const LongVector& p) const {
  const LongVector e1 = v_[1] - v_[0], e2 = v_[3] - v_[0], d = p - v_[0];
  const L l2 = lengthOf(e2);
  const LongVector foot = v_[0] + glm::dot(d, e1) / glm::dot(e1, e1) * e1, top = foot + e2;
  const auto sine = [&](const LongVector& q) { return glm::dot(q, e2) / (l2 * lengthOf(q)); };
  return {within((solidAngle(v_[0], foot, top) + solidAngle(v_[0], top, v_[3])) / omega_),
          within((sine(p) - sine(foot)) / (sine(top) - sine(foot)))};
}

std::array<double, 2> SeenLight::fractions(const Point& p) const {
  const LongVector inSight = between(p, from_);
  return v_.size() == 3 ? triangleFractions(inSight) : rectangleFractions(inSight);
}

std::vector<Mean> SeenLight::means() const {
  const double rounding = mustBeUniform() ? std::max(5e-4, angleTolerance() / omega()) : 1e-3;
  const auto moment = [&](const char* what, double expected) {
    return Mean{.what = what, .expected = expected, .tolerance = rounding, .scale = expected};
  };
  std::vector<Mean> all{
      moment("mean weight of the points", 1.0),
      moment("mean of a, the share of the solid angle on one side", 0.5),
      moment("mean of b, the place across", 0.5),
      moment("mean of a^2", 1.0 / 3.0),
      moment("mean of b^2", 1.0 / 3.0),
      moment("mean of a b", 0.25),
  };
  for (std::size_t row = 0; row < kSide; ++row)
    for (std::size_t column = 0; column < kSide; ++column)
      all.push_back({.what = fmt::format(
                         "share of the points in cell ({}, {}) of equal solid angles", column, row),
                     .expected = 1.0 / (kSide * kSide),
                     .tolerance = rounding,
                     .delta = 0.01});
  return all;
}

void SeenLight::add(const Point& p, double weight, std::span<double> sums) const {
  const auto [a, b] = fractions(p);
  const std::array<double, kMoments> moments{1.0, a, b, a * a, b * b, a * b};
  for (std::size_t k = 0; k < kMoments; ++k) sums[k] += weight * moments[k];
  const auto cell = [](double x) {
    return std::min(static_cast<std::size_t>(x * double{kSide}), kSide - 1);
  };
  sums[kMoments + cell(b) * kSide + cell(a)] += weight;
}

std::vector<std::pair<Point, double>> SeenLight::quadrature() const {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  constexpr int kPanels = 6;
  std::vector<std::pair<double, double>> nodes;  // in [0,1]
  for (int panel = 0; panel < kPanels; ++panel)
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
      for (const double side : {-1.0, 1.0})
        nodes.emplace_back((panel + 0.5 * (1.0 + side * Gauss::abscissa()[i])) / kPanels,
                           0.5 * Gauss::weights()[i] / kPanels);
  const auto& v = outline_.vertices();
  const glm::dvec3 p0(v[0]), e1 = glm::dvec3(v[1]) - p0, e2 = glm::dvec3(v.back()) - p0;
  const double whole = glm::length(glm::cross(e1, e2));
  std::vector<std::pair<Point, double>> all;
  for (const auto& [a, wa] : nodes)
    for (const auto& [b, wb] : nodes) {
      if (v.size() == 4)
        all.emplace_back(Point(p0 + a * e1 + b * e2), whole * wa * wb);
      else
        all.emplace_back(Point(p0 + a * (1.0 - b) * e1 + a * b * e2), whole * a * wa * wb);
    }
  return all;
}

std::vector<double> SeenLight::meansByArea() const {
  std::vector<double> sums(means().size(), 0.0);
  for (const auto& [p, share] : quadrature()) add(p, share / outline_.area(), sums);
  return sums;
}

namespace {

class Maker {
 public:
  Maker(bool triangles, std::uint64_t seed) : triangles_(triangles), random_(seed) {}

  // Of about this size, `height` above and `aside` beside it, in sizes.
  void add(std::string what, double height, double aside, double size = 1.0, double narrow = 1.0) {
    const DoubleFrame frame{glm::dvec3(random_.direction())};
    const double turn = random_.between(0.0, 6.28);
    const glm::dvec3 u = std::cos(turn) * frame.u + std::sin(turn) * frame.v,
                     v = glm::cross(frame.n, u);
    const double width = random_.between(0.8, 1.2), depth = narrow * random_.between(0.7, 1.1);
    const double azimuth = random_.between(0.0, 6.28);
    const glm::dvec3 from =
        random_.between(0.9, 1.1) *
        (height * frame.n + aside * (std::cos(azimuth) * u + std::sin(azimuth) * v));
    std::vector<glm::dvec2> corners{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    if (triangles_) corners = {{-0.5, -0.4}, {0.6, -0.3}, {random_.between(-0.3, 0.3), 0.6}};
    std::vector<Point> vertices;
    for (const glm::dvec2& c : corners)
      vertices.emplace_back(size * (c.x * width * u + c.y * depth * v));
    all_.emplace_back(std::move(what), std::move(vertices), Point(size * from));
  }

  // From so far that it fills this solid angle, and aside, so that it is not seen alike everywhere.
  void addOfSolidAngle(std::string what, double omega) {
    add(std::move(what), 20.0, 20.0);
    const SeenLight light = std::move(all_.back());
    all_.back() = SeenLight(light.what(), light.outline().vertices(),
                            static_cast<float>(std::sqrt(light.omega() / omega)) * light.from());
  }

  void add(SeenLight light) { all_.push_back(std::move(light)); }

  std::vector<SeenLight> take() { return std::move(all_); }

 private:
  bool triangles_;
  Random random_;
  std::vector<SeenLight> all_;
};

}  // namespace

std::vector<SeenLight> lightsInSight(bool triangles, std::uint64_t seed) {
  Maker maker(triangles, seed);
  std::vector<Point> plain{{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  if (triangles) plain.pop_back();
  std::reverse(plain.begin(), plain.end());
  if (dot(cross(plain[1] - plain[0], plain[2] - plain[0]), Vector(0, 1, 0)) > 0.0f)
    std::reverse(plain.begin(), plain.end());
  maker.add(SeenLight("a plain one above the origin", plain, Point(0.25f, 0.0f, 0.5f)));
  for (Point& p : plain) p.y += 1.0f;
  maker.add(SeenLight("a higher one, asked after it from the same point", plain,
                      Point(0.25f, 0.0f, 0.5f)));
  maker.add("in front of it", 1.0, 0.2);
  maker.add("close by", 0.15, 0.2);
  maker.add("from aside", 0.5, 1.5);
  maker.add("at a grazing angle", 0.05, 1.0);
  maker.add("a narrow one", 0.7, 0.3, 1.0, 0.02);
  maker.add("of the size 1e-4", 0.8, 0.5, 1e-4);
  maker.add("of the size 1e4", 0.8, 0.5, 1e4);
  maker.add("from afar", 12.0, 4.0);
  maker.add("from so far that it is small", 3e2, 1e2);
  maker.add("from so far that it is nearly a point", 3e4, 1e4);
  maker.add("very close", 0.06, 0.05);
  maker.addOfSolidAngle("just too small to be uniform over it", 0.9 * kSmallestSolidAngle);
  maker.addOfSolidAngle("just large enough to be uniform over it", 1.1 * kSmallestSolidAngle);
  return maker.take();
}

}  // namespace pathmark::checks
