// What is asked of 2.4 and 2.5: points of a sphere, and their density.
#include "checks/calls.h"
#include "checks/exact.h"
#include "checks/means.h"
#include "checks/part2_checks.h"
#include "checks/points.h"
#include "checks/sphere_views.h"

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;
using Kind = SphereReference::Kind;

constexpr double kPiD = std::numbers::pi;
constexpr double kRoundoff = 0x1p-24;

// Nearer than half a radius to the surface, samples by area have weights without a useful bound.
constexpr double kNear = 2.0 / 3.0;

constexpr std::uint32_t kMostPoints = 1u << 16;  // of one request

std::vector<SphereView> allViews(std::uint64_t seed) {
  std::vector<SphereView> views = viewsFromOutside(seed);
  for (const SphereView& v : viewsFromInside(seed)) views.push_back(v);
  return views;
}

Results sample(CheckRun& run, const SphereView& view, const std::vector<vec2>& points) {
  Calls calls(F::kSphereSample);
  for (const vec2& st : points) calls.add(view.centre, view.radius, view.from, st);
  return calls.run(run.worker);
}

std::vector<vec2> randomPairs(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<vec2> points{{0.5f, 0.5f}};
  while (static_cast<int>(points.size()) < count)
    points.emplace_back(random.uniform(), random.uniform());
  return points;
}

// Of what goes wrong with this view, and did not with the plain ones before it.
std::string causeOf(const SphereView& view) {
  if (view.oracle.d == view.oracle.r)
    return "exactly on the sphere (d = r) there is no cone either: there too the points are "
           "uniform over the whole area, with the density 1/(4 pi r^2)";
  if (!view.oracle.outside())
    return "inside the sphere (d < r) there is no cone: there the points are uniform over the "
           "whole area, with the density 1/(4 pi r^2)";
  return view.oracle.outside() && view.ratio() <= 1e-2
             ? "1 - cos(thetaMax) and what follows from it cancel for a small or far sphere, and "
               "the handout has forms that do not; or the point is found as from + t * direction, "
               "whose rounding is that of the distance and not of the sphere"
             : "";
}

// Along an axis or next to it, where nothing else is special.
constexpr const char* kFrameBreaksDown =
    "the frame around the direction to the centre breaks down along an axis: a cross product of "
    "parallel vectors, or a division by a component that is 0, gives no direction there";

Finding pointsAreOfTheSphere(CheckRun& run) {
  std::vector<vec2> points = randomPairs(run.seed, 48);
  for (const float s : kEdgeNumbers)
    for (const float t : kEdgeNumbers) points.emplace_back(s, t);
  std::vector<vec2> twice = points;
  twice.insert(twice.end(), points.rbegin(), points.rend());
  Exact exact;
  bool allInwards = true;
  std::vector<SphereView> views = viewsFromOutside(run.seed);
  const std::size_t firstAlongAxes = views.size();
  for (const SphereView& v : viewsAlongAxes()) views.push_back(v);
  const std::size_t endAlongAxes = views.size();
  for (const SphereView& v : viewsFromInside(run.seed)) views.push_back(v);
  std::string cause;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const SphereView& view = views[k];
    const bool alongAxis = k >= firstAlongAxes && k < endAlongAxes;
    const bool rightSoFar = !exact.failed();
    const Results results = sample(run, view, twice);
    exact.count(results.count());
    const double allowed = 16.0 * kRoundoff * (view.magnitude() + double{view.radius});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point p = results.vector(i, 0);
      const Vector n = results.vector(i, 3);
      const float pdf = results.number(i, 6);
      const auto where = [&] {
        return fmt::format("{}, s = {:.8g}, t = {:.8g}", view.text(), points[i].x, points[i].y);
      };
      const auto got = [&] {
        return fmt::format("p = {}, n = {}, pdf = {:.6g}", text(p), text(n), pdf);
      };
      if (!exact.holds(results.finite(i) && pdf >= 0.0f, "finite numbers, a density of at least 0",
                       got, where)) {
        Finding finding = exact.finding();
        finding.cause = alongAxis && rightSoFar ? kFrameBreaksDown : causeOf(view);
        return finding;
      }
      const std::size_t again = results.count() - 1 - i;
      exact.holds(
          results.same(i, again), "the same point again for the same s and t",
          [&] {
            return fmt::format("p = {} and then {}", text(p), text(results.vector(again, 0)));
          },
          where);
      if (pdf == 0.0f) continue;
      exact.unit("n", n, where);
      const glm::dvec3 offset = glm::dvec3(p) - glm::dvec3(view.centre);
      const double r = view.radius;
      exact.holds(
          std::abs(glm::length(offset) - r) <= allowed, "a point at the distance r from the centre",
          [&] {
            return fmt::format("p = {}, at the distance {:.8g}", text(p), glm::length(offset));
          },
          where);
      exact.holds(glm::length(offset - r * glm::dvec3(n)) <= allowed,
                  "n the outward normal at p: p = c + r n", got, where);
      if (view.oracle.outside())
        allInwards = allInwards && glm::length(offset + r * glm::dvec3(n)) <= allowed;
    }
    if (alongAxis && rightSoFar && exact.failed()) cause = kFrameBreaksDown;
  }
  Finding finding = exact.finding();
  if (exact.failed()) finding.cause = cause;
  if (exact.failed() && allInwards) finding.cause = "n points inwards";
  return finding;
}

// The share of the samples in the fraction and the azimuth of the reference.
constexpr int kRings = 4, kSectors = 4;
constexpr std::size_t kMoments = 6, kMeans = kMoments + kRings * kSectors;

std::size_t ringOf(double fraction) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(fraction * kRings), 0, kRings - 1));
}

void addMeans(std::span<double> sums, double weight, double fraction, double azimuth) {
  const std::array<double, kMoments> g{1.0,
                                       fraction,
                                       fraction * fraction,
                                       std::cos(azimuth),
                                       std::sin(azimuth),
                                       std::sin(2.0 * azimuth)};
  for (std::size_t k = 0; k < kMoments; ++k) sums[k] += weight * g[k];
  const double turn = azimuth / (2.0 * kPiD) + 0.5;
  const auto sector =
      static_cast<std::size_t>(std::clamp(static_cast<int>(turn * kSectors), 0, kSectors - 1));
  sums[kMoments + ringOf(fraction) * kSectors + sector] += weight;
}

std::vector<Mean> expectedMeans(Kind kind) {
  const std::string h = kind == Kind::kCone  ? "h = (1 - cos(theta)) / (1 - cos(thetaMax))"
                        : kind == Kind::kCap ? "h, the height on the cap that can be seen"
                                             : "h, the height on the sphere, from 0 to 1";
  std::vector<Mean> means{
      {"mean weight: the contract's density over the one that was returned", 1.0},
      {fmt::format("mean of {}", h), 0.5},
      {fmt::format("mean square of {}", h), 1.0 / 3.0},
      {"mean cosine of the azimuth", 0.0},
      {"mean sine of the azimuth", 0.0},
      {"mean sine of twice the azimuth", 0.0}};
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector)
      means.push_back({fmt::format("share of the samples in quarter {} of {}, quarter turn {}",
                                   ring + 1, h, sector + 1),
                       1.0 / (kRings * kSectors)});
  return means;
}

// The means of samples with the contract's density that are spread evenly along a fraction.
std::vector<double> meansAlong(const std::function<std::pair<double, double>(double)>& weightAndH) {
  constexpr int kSteps = 1024;
  std::vector<double> means(kMeans, 0.0);
  for (int k = 0; k < kSteps; ++k) {
    const auto [weight, h] = weightAndH((k + 0.5) / kSteps);
    const double w = weight / kSteps;
    means[0] += w;
    means[1] += w * h;
    means[2] += w * h * h;
    for (int sector = 0; sector < kSectors; ++sector)
      means[kMoments + ringOf(h) * kSectors + static_cast<std::size_t>(sector)] += w / kSectors;
  }
  return means;
}

std::vector<Suspicion> suspicionsAbout(const SphereView& view) {
  const double sinMax = view.ratio(), cone = static_cast<double>(view.oracle.oneMinusCosMax);
  const double thetaMax = std::asin(sinMax);
  const auto angleUniform = [&](double s) {
    const double half = std::sin(0.5 * s * thetaMax);
    return std::pair{1.0, 2.0 * half * half / cone};
  };
  const auto byArea = [&](double s) {
    const double cosAlpha = 1.0 - 2.0 * s;
    if (cosAlpha <= sinMax) return std::pair{0.0, 0.0};
    const double across = sinMax * std::sqrt(1.0 - cosAlpha * cosAlpha),
                 along = 1.0 - sinMax * cosAlpha;
    return std::pair{1.0, (1.0 - along / std::hypot(along, across)) / cone};
  };
  return {
      {"theta itself is uniform in the cone, and not its cosine", meansAlong(angleUniform)},
      {"the points are uniform by area, and the density is that of the cone", meansAlong(byArea)}};
}

struct Probe {
  bool asTheContract = true;  // the returned densities
  bool unseen = false;        // there are samples on the far side
  bool allUnseen = true;      // and none on the near one, nor all in one point
  double variance = 0.0;      // of the weights of the cone's density
};

Probe probe(CheckRun& run, const SphereView& view, DensitySuspects& suspects) {
  const Results results = sample(run, view, randomPairs(run.seed, 256));
  Probe probe;
  double sum = 0.0, sum2 = 0.0;
  bool onePoint = true;
  for (std::size_t i = 0; i < results.count(); ++i) {
    const Vector n = results.vector(i, 3);
    onePoint = onePoint && n == results.vector(0, 3);
    probe.allUnseen = probe.allUnseen && view.oracle.cosAtPoint(n) < -1e-3L;
    const double pdf = results.number(i, 6), q = static_cast<double>(view.oracle.pdf(n));
    suspects.see(view, n, pdf);
    const double weight = pdf > 0.0 ? q / pdf : 0.0;
    sum += weight;
    sum2 += weight * weight;
    if (std::abs(pdf - q) <= view.tolerance(n) * q) continue;
    probe.asTheContract = false;
    probe.unseen = probe.unseen || (pdf > 0.0 && view.oracle.cosAtPoint(n) < -1e-3L);
  }
  const double count = static_cast<double>(results.count()), mean = sum / count;
  probe.variance = sum2 / count - mean * mean;
  probe.allUnseen = probe.allUnseen && view.oracle.outside() && !onePoint;
  return probe;
}

Finding judgeView(CheckRun& run, const SphereView& view, std::uint64_t seed, const Probe& probed) {
  SphereReference reference{view, view.oracle.outside() ? Kind::kCone : Kind::kWhole};
  if (view.oracle.outside() && !probed.asTheContract && view.ratio() > kNear)
    reference.kind = probed.unseen ? Kind::kWhole : Kind::kCap;
  // Weights of the contract's sampler are 1, others vary from sample to sample.
  const std::uint32_t perReplicate = probed.asTheContract ? 128 : 1024;
  const glm::dvec3 axis(view.oracle.from - view.oracle.centre);
  const DoubleFrame frame(glm::dot(axis, axis) > 0.0 ? axis : glm::dvec3(0, 1, 0));
  Points points(seed, perReplicate);
  std::uint64_t made = 0;
  const auto addSample = [&](std::span<double> sums, const Results& results, std::size_t i) {
    const double pdf = results.number(i, 6);
    const Vector n = results.vector(i, 3);
    if (!results.finite(i)) sums[0] = std::numeric_limits<double>::quiet_NaN();
    if (!results.finite(i) || pdf == 0.0) return;
    const double q = reference.density(n);
    // Next to the limb the cosine is a small difference, and its rounding is no error.
    const bool same = std::abs(pdf - q) <= view.tolerance(n) * q;
    const glm::dvec3 local = frame.local(glm::dvec3(n));
    addMeans(sums, (same ? 1.0 : q / pdf) / perReplicate, reference.fraction(n),
             std::atan2(local.z, local.x));
  };
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::fill(values.begin(), values.end(), 0.0);
    const std::uint32_t atOnce = std::max(kMostPoints / perReplicate, 1u);
    for (std::uint32_t done = 0; done < count; done += atOnce) {
      std::vector<vec2> pairs;
      for (std::uint32_t r = done; r < std::min(done + atOnce, count); ++r) {
        points.start(first + r);
        for (std::uint32_t m = 0; m < perReplicate; ++m) {
          points.point(m);
          pairs.push_back(points.pair());
        }
      }
      const Results results = sample(run, view, pairs);
      made += results.count();
      for (std::size_t i = 0; i < results.count(); ++i)
        addSample(values.subspan((done + i / perReplicate) * kMeans, kMeans), results, i);
    }
  };
  Finding finding =
      judgeMeans(run, expectedMeans(reference.kind), measure, view.text(),
                 reference.kind == Kind::kCone ? suspicionsAbout(view) : std::vector<Suspicion>{},
                 probed.asTheContract ? 2 : 3);
  finding.calls = made;
  return finding;
}

Finding samplesFollowTheirDensity(CheckRun& run) {
  Finding worst;
  DensitySuspects suspects;
  std::string remark;
  std::uint64_t calls = 0, seed = run.seed;
  for (const SphereView& view : allViews(run.seed)) {
    const Probe probed = probe(run, view, suspects);
    Finding finding = judgeView(run, view, ++seed, probed);
    calls += finding.calls;
    if (finding.status == Status::kFail && probed.allUnseen)
      finding.cause =
          "all points are on the far side: the cone is turned away from `from`, or the farther of "
          "the two points where the direction meets the sphere is taken";
    if (finding.status == Status::kFail && finding.cause.empty()) finding.cause = suspects.cause();
    if (finding.status == Status::kFail && finding.cause.empty()) finding.cause = causeOf(view);
    if (worst.passed()) worst = finding;
    if (!finding.passed()) break;
    if (remark.empty() && view.oracle.outside() && !probed.asTheContract)
      remark = fmt::format(
          "correct, but noisier than points that are uniform over the solid angle: the variance of "
          "the weights is {:.2g} instead of 0 ({})",
          probed.variance, view.text());
  }
  worst.calls = calls;
  if (worst.passed()) worst.remark = remark;
  return worst;
}

// Normals over the whole sphere with their share of the integral, in the angle alpha at the centre:
// over the cap that can be seen with alpha as a cube, since from next to the surface the density is
// a narrow peak at 0, and over the rest.
std::vector<std::pair<Vector, double>> quadratureOf(const SphereView& view) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  constexpr int kPanels = 12, kAzimuths = 8;
  const double edge = view.oracle.outside() ? std::acos(view.ratio()) : 0.5 * kPiD;
  const glm::dvec3 axis(view.oracle.from - view.oracle.centre);
  const DoubleFrame frame(glm::dot(axis, axis) > 0.0 ? axis : glm::dvec3(0, 1, 0));
  const double r2 = double{view.radius} * double{view.radius};
  std::vector<std::pair<Vector, double>> nodes;
  const auto ring = [&](double alpha, double width) {
    for (int k = 0; k < kAzimuths; ++k)
      nodes.emplace_back(
          Vector(frame.direction(std::cos(alpha), 2.0 * kPiD * (k + 0.5) / kAzimuths)),
          width * std::sin(alpha) * r2 * 2.0 * kPiD / kAzimuths);
  };
  const auto forNodes = [](double low, double high, const auto& visit) {
    const double half = 0.5 * (high - low);
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
      for (const double side : {-1.0, 1.0})
        visit(low + half * (1.0 + side * Gauss::abscissa()[i]), half * Gauss::weights()[i]);
  };
  for (int panel = 0; panel < kPanels; ++panel)
    forNodes(static_cast<double>(panel) / kPanels, static_cast<double>(panel + 1) / kPanels,
             [&](double x, double w) { ring(edge * x * x * x, w * 3.0 * edge * x * x); });
  forNodes(edge, kPiD, [&](double alpha, double w) { ring(alpha, w); });
  return nodes;
}

Finding pdfIsADensity(CheckRun& run) {
  Exact exact;
  bool onlyUnseen = true;     // what is too much comes from points that cannot be seen
  bool wrongOutside = false;  // where there is a cone
  std::string causeOfFirst;   // of the views without one
  DensitySuspects suspects;
  for (const SphereView& view : allViews(run.seed)) {
    const auto nodes = quadratureOf(view);
    Calls calls(F::kSpherePdf);
    for (const auto& [n, weight] : nodes)
      calls.add(view.centre, view.radius, view.from, view.centre + view.radius * n, n);
    const Results results = calls.run(run.worker);
    exact.count(results.count());
    double integral = 0.0, unseen = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double pdf = results.number(i, 0);
      if (!exact.holds(
              std::isfinite(pdf) && pdf >= 0.0, "a density, at least 0",
              [&] { return fmt::format("pdf = {:.6g}", pdf); },
              [&] { return fmt::format("{}, n = {}", view.text(), text(nodes[i].first)); }))
        return exact.finding();
      suspects.see(view, nodes[i].first, pdf);
      integral += nodes[i].second * pdf;
      if (view.oracle.cosAtPoint(nodes[i].first) < 0.0L) unseen += nodes[i].second * pdf;
    }
    const double allowed = std::max(
        5e-4, view.tolerance(Vector(glm::normalize(view.oracle.outside()
                                                       ? view.oracle.from - view.oracle.centre
                                                       : SphereOracle::LongVector(0, 1, 0)))));
    const bool right = exact.value("integral of pdf over the sphere's area", integral, 1.0, allowed,
                                   [&] { return view.text(); });
    if (!right && causeOfFirst.empty() && !view.oracle.outside()) causeOfFirst = causeOf(view);
    if (!right && view.oracle.outside()) wrongOutside = true;
    onlyUnseen = onlyUnseen && (right || std::abs(integral - unseen - 1.0) <= allowed);
  }
  Finding finding = exact.finding();
  if (exact.failed()) finding.cause = wrongOutside ? suspects.cause() : causeOfFirst;
  if (exact.failed() && onlyUnseen)
    finding.cause = "points on the far side, which `from` cannot see, have a density too";
  return finding;
}

Finding pdfIsThatOfSample(CheckRun& run) {
  Exact exact;
  DensitySuspects suspects;
  for (const SphereView& view : allViews(run.seed)) {
    const Results drawn = sample(run, view, randomPairs(run.seed, 128));
    Calls calls(F::kSpherePdf);
    for (std::size_t i = 0; i < drawn.count(); ++i)
      calls.add(view.centre, view.radius, view.from, drawn.vector(i, 0), drawn.vector(i, 3));
    const Results pdf = calls.run(run.worker);
    exact.count(2 * drawn.count());
    for (std::size_t i = 0; i < drawn.count(); ++i) {
      const Vector n = drawn.vector(i, 3);
      const double claimed = drawn.number(i, 6), got = pdf.number(i, 0);
      if (claimed == 0.0) continue;
      suspects.see(view, n, got);
      exact.value("pdf(from, p, n) for the p, n and pdf of sample", got, claimed,
                  view.tolerance(n) * claimed,
                  [&] { return fmt::format("{}, n = {}", view.text(), text(n)); });
    }
  }
  Finding finding = exact.finding();
  if (exact.failed()) finding.cause = suspects.cause();
  return finding;
}

}  // namespace

std::vector<Check> sphereLightChecks() {
  return {
      {"points", F::kSphereSample,
       "for all s and t, also at the ends, p is a point of the sphere and n the outward normal "
       "there, from outside, inside and on the sphere, and the same again for the same numbers",
       0.0, pointsAreOfTheSphere},
      {"samples", F::kSphereSample,
       "the points follow the density per unit area that they are returned with", 0.01,
       samplesFollowTheirDensity},
      {"integral", F::kSpherePdf,
       "pdf is a density per unit area: at least 0, and its integral over the sphere is 1", 0.0,
       pdfIsADensity},
      {"own-density",
       F::kSpherePdf,
       "pdf says of a point the density with which sample returns it",
       0.0,
       pdfIsThatOfSample,
       {F::kSphereSample}},
  };
}

}  // namespace pathmark::checks
