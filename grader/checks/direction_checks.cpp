#include "checks/direction_checks.h"

#include <boost/math/quadrature/gauss.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

constexpr double kPiD = std::numbers::pi;
constexpr int kRings = 4, kSectors = 4;
constexpr std::size_t kMoments = 8, kMeans = kMoments + kRings * kSectors;

// Bounded functions of a direction in the frame of the axis: 1, y, x, z, y^2, x^2 - z^2, x y, and
// cos(3 azimuth) sin(theta).
std::array<double, kMoments> moments(const glm::dvec3& d) {
  const double sine2 = d.x * d.x + d.z * d.z;
  const double third = sine2 > 0.0 ? (d.x * d.x * d.x - 3.0 * d.x * d.z * d.z) / sine2 : 0.0;
  return {1.0, d.y, d.x, d.z, d.y * d.y, d.x * d.x - d.z * d.z, d.x * d.y, third};
}

constexpr std::array kNames{"mean weight q/pdf",
                            "mean of cos(theta)",
                            "mean of the first tangential component",
                            "mean of the second tangential component",
                            "mean of cos(theta)^2",
                            "difference of the squared tangential components",
                            "mean of tangential times normal component",
                            "third harmonic of the azimuth"};

// Next to the horizon the density is a small difference, and its rounding is no error.
double weightOf(double density, double pdf) {
  constexpr double kRounding = 16.0 * 0x1p-24;
  return std::abs(density - pdf) <= kRounding ? 1.0 : density / pdf;
}

double ringEdge(const AxialDensity& q, int ring) {
  return q.lowest + (1.0 - q.lowest) * ring / kRings;
}

std::size_t cellOf(const AxialDensity& q, const glm::dvec3& d) {
  const double ring = (d.y - q.lowest) / (1.0 - q.lowest) * kRings;
  const double turn = std::atan2(d.z, d.x) / (2.0 * kPiD) + 0.5;
  const auto clamp = [](double x, int n) {  // what is not a number goes into the first
    return x > 0.0 ? static_cast<std::size_t>(std::min(x, n - 0.5)) : std::size_t{0};
  };
  return clamp(ring, kRings) * kSectors + clamp(turn * kSectors, kSectors);
}

void addSample(const AxialDensity& q, const DoubleFrame& frame, const DrawnDirection& sample,
               double share, std::span<double> sums) {
  if (sample.pdf == 0.0) return;
  const glm::dvec3 d = frame.local(glm::dvec3(sample.wi));
  const double weight = weightOf(q.density(d.y), sample.pdf) * share;
  const auto g = moments(d);
  for (std::size_t k = 0; k < kMoments; ++k) sums[k] += weight * g[k];
  sums[kMoments + cellOf(q, d)] += weight;
}

std::vector<Mean> expectedMeans(const AxialDensity& q) {
  const std::array<double, kMoments> expected{1.0,           q.meanCosine, 0.0, 0.0,
                                              q.meanCosine2, 0.0,          0.0, 0.0};
  std::vector<Mean> means;
  for (std::size_t k = 0; k < kMoments; ++k) means.push_back({kNames[k], expected[k]});
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      Mean mean;
      mean.what = "share of the samples with cosines from " +
                  std::to_string(ringEdge(q, ring)).substr(0, 4) + " to " +
                  std::to_string(ringEdge(q, ring + 1)).substr(0, 4) + ", quarter turn " +
                  std::to_string(sector + 1);
      mean.expected = q.mass(ringEdge(q, ring), ringEdge(q, ring + 1)) / kSectors;
      means.push_back(mean);
    }
  return means;
}

}  // namespace

std::vector<DirectionDraw> drawsOf(Points& points, std::uint32_t pointsPerReplicate,
                                   std::uint32_t first, std::uint32_t count) {
  std::vector<DirectionDraw> draws;
  draws.reserve(std::size_t{count} * pointsPerReplicate);
  for (std::uint32_t r = first; r < first + count; ++r) {
    points.start(r);
    for (std::uint32_t m = 0; m < pointsPerReplicate; ++m) {
      points.point(m);
      const vec2 st = points.pair();
      draws.push_back({st, points.single()});
    }
  }
  return draws;
}

std::vector<DrawnDirection> drawReflections(CheckRun& run, CourseworkFunction reflection,
                                            const Words& material, const Vector& wo,
                                            const Vector& n,
                                            const std::vector<DirectionDraw>& points) {
  Calls calls(reflection, material);
  for (const DirectionDraw& p : points) calls.add(wo, n, p.st, p.u);
  const Results results = calls.run(run.worker);
  std::vector<DrawnDirection> drawn;
  drawn.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    drawn.push_back({results.vector(i, 0), results.number(i, 3)});
  return drawn;
}

Finding judgeOwnDensity(CheckRun& run, const Vector& axis, const AxialDensity& q,
                        const DrawDirections& draw, const std::string& where,
                        std::uint32_t pointsPerReplicate,
                        const std::vector<Suspicion>& suspicions) {
  const DoubleFrame frame{glm::dvec3(axis)};
  Points points(run.seed, pointsPerReplicate);
  std::uint64_t calls = 0;
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    const std::vector<DirectionDraw> draws = drawsOf(points, pointsPerReplicate, first, count);
    calls += draws.size();
    const std::vector<DrawnDirection> drawn = draw(draws);
    std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t i = 0; i < drawn.size(); ++i)
      addSample(q, frame, drawn[i], 1.0 / pointsPerReplicate,
                values.subspan(i / pointsPerReplicate * kMeans, kMeans));
  };
  Finding finding = judgeMeans(run, expectedMeans(q), measure, where, suspicions);
  finding.calls = calls;
  return finding;
}

std::vector<double> axialMoments(const AxialDensity& q,
                                 const std::function<double(double cosine)>& actual,
                                 const std::function<double(double cosine)>& claimed,
                                 double lowest) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  // In the angle, so that a density with a pole at cosine 1 is integrated well too.
  const auto mean = [&](const std::function<double(double)>& g, double low, double high) {
    low = std::max(low, lowest);
    if (!(low < high)) return 0.0;
    const auto integrand = [&](double theta) {
      const double c = std::cos(theta), pdf = claimed(c);
      return pdf > 0.0 ? actual(c) * q.density(c) / pdf * g(c) * std::sin(theta) : 0.0;
    };
    return 2.0 * kPiD * Gauss::integrate(integrand, std::acos(high), std::acos(low));
  };
  std::vector<double> result{mean([](double) { return 1.0; }, -1.0, 1.0),
                             mean([](double c) { return c; }, -1.0, 1.0),
                             0.0,
                             0.0,
                             mean([](double c) { return c * c; }, -1.0, 1.0),
                             0.0,
                             0.0,
                             0.0};
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector)
      result.push_back(mean([](double) { return 1.0; }, ringEdge(q, ring), ringEdge(q, ring + 1)) /
                       kSectors);
  return result;
}

std::vector<double> momentsOf(const Vector& axis, const AxialDensity& q,
                              const std::function<DrawnDirection(const DirectionDraw&)>& drawOne) {
  constexpr std::uint32_t kPoints = 1u << 14;  // the means are exact to about 2e-4
  const DoubleFrame frame{glm::dvec3(axis)};
  Points points(0, kPoints);
  std::vector<double> sums(kMeans, 0.0);
  for (const DirectionDraw& point : drawsOf(points, kPoints, 0, 1))
    addSample(q, frame, drawOne(point), 1.0 / kPoints, sums);
  return sums;
}

}  // namespace pathmark::checks
