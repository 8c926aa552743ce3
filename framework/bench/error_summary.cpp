#include "bench/error_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::bench {

namespace {

// The replicates of one point, number by number.
struct Replicates {
  std::uint64_t raysPerPixel = 0;
  std::vector<double> cpuSeconds, mse, relativeMse, worstShare, mean;

  std::size_t count() const { return cpuSeconds.size(); }
  void add(const ErrorRun& run) {
    cpuSeconds.push_back(run.cpuSeconds);
    mse.push_back(run.deviation.mse);
    relativeMse.push_back(run.deviation.relativeMse);
    worstShare.push_back(run.deviation.worstShare);
    mean.push_back(run.deviation.mean);
  }
};

struct Curve {
  std::string estimator, sampler;
  std::vector<Replicates> points;
};

double meanOver(std::span<const double> values, std::span<const std::size_t> chosen) {
  double sum = 0.0;
  for (const std::size_t k : chosen) sum += values[k];
  return sum / static_cast<double>(chosen.size());
}

Interval meanInterval(const std::vector<double>& values) {
  return jackknife(values.size(), [&](auto chosen) { return meanOver(values, chosen); });
}

Interval positiveInterval(const std::vector<double>& values, double besides = 0.0) {
  return exponential(jackknife(
      values.size(), [&](auto chosen) { return logOfMean(values, chosen); }, besides));
}

PointSummary summarise(const Replicates& r, const OwnDeviation& reference) {
  PointSummary point;
  point.raysPerPixel = r.raysPerPixel;
  point.replicates = r.count();
  const Interval error = meanInterval(r.relativeMse);
  const double besides = reference.relativeMseError / error.value;
  point.cpuSeconds = positiveInterval(r.cpuSeconds);
  point.mse = positiveInterval(r.mse);
  point.relativeMse = positiveInterval(r.relativeMse, besides);
  point.efficiency = exponential(jackknife(
      r.count(),
      [&](auto chosen) {
        return -logOfMean(r.relativeMse, chosen) - logOfMean(r.cpuSeconds, chosen);
      },
      besides));
  point.worstShare = meanInterval(r.worstShare);
  point.mean = meanInterval(r.mean);
  return point;
}

// Of the replicates that all points have: each of them is a whole curve, from which the others are
// independent.
Interval slopeOf(const std::vector<Replicates>& points) {
  if (points.size() < 2) return {};
  std::size_t common = points.front().count();
  for (const Replicates& r : points) common = std::min(common, r.count());
  return jackknife(common, [&](auto chosen) {
    std::vector<double> time, error;
    for (const Replicates& r : points) {
      time.push_back(logOfMean(r.cpuSeconds, chosen));
      error.push_back(logOfMean(r.relativeMse, chosen));
    }
    return slope(time, error);
  });
}

std::vector<Curve> curvesOf(const std::string& scene, const std::vector<ErrorRun>& runs) {
  std::vector<Curve> curves;
  for (const ErrorRun& run : runs) {
    if (run.point.scene != scene) continue;
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const Curve& c) {
      return c.estimator == run.point.estimator && c.sampler == run.point.sampler;
    });
    if (curve == curves.end())
      curve = curves.insert(curves.end(), {run.point.estimator, run.point.sampler, {}});
    auto point = std::lower_bound(
        curve->points.begin(), curve->points.end(), run.point.raysPerPixel,
        [](const Replicates& r, std::uint64_t rays) { return r.raysPerPixel < rays; });
    if (point == curve->points.end() || point->raysPerPixel != run.point.raysPerPixel) {
      point = curve->points.insert(point, Replicates{});
      point->raysPerPixel = run.point.raysPerPixel;
    }
    point->add(run);
  }
  return curves;
}

}  // namespace

std::string CurveSummary::name() const {
  return sampler.empty() ? estimator : fmt::format("{}, {}", estimator, sampler);
}

SceneSummary summarise(const std::string& scene, const OwnDeviation& reference,
                       const std::vector<ErrorRun>& runs) {
  SceneSummary summary{scene, reference, {}};
  for (const Curve& curve : curvesOf(scene, runs)) {
    CurveSummary c{curve.estimator, curve.sampler, {}, slopeOf(curve.points)};
    for (const Replicates& r : curve.points) c.points.push_back(summarise(r, reference));
    summary.curves.push_back(std::move(c));
  }
  return summary;
}

}  // namespace pathmark::bench
