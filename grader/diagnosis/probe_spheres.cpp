// Points of spheres, and their density. Which density a sphere is sampled with is left open:
// samples count with the contract's density over their own.
#include "checks/calls.h"
#include "checks/points.h"
#include "checks/sphere_views.h"
#include "diagnosis/light_probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

struct View {
  const char* name;
  SphereView view;
};

std::vector<View> views() {
  const Vector generic(glm::normalize(glm::dvec3(0.3, -0.7, 0.5)));
  const Point centre(1, 2, 3);
  return {{"from two radii away", {{0, 0, 0}, 2.0f, {0, 4, 0}}},
          {"from four radii away", {centre, 0.5f, centre + 2.0f * generic}},
          {"from afar", {{0, 0, 0}, 1.0f, 1000.0f * generic}},
          {"from very far", {{0, 0, 0}, 1.0f, 30000.0f * generic}},
          {"from within", {centre, 2.0f, centre + 1.2f * generic}},
          {"from the centre", {{0, 0, 0}, 2.0f, {0, 0, 0}}}};
}

glm::dvec3 axisOf(const SphereView& view) {
  const glm::dvec3 axis(view.oracle.from - view.oracle.centre);
  return glm::dot(axis, axis) > 0.0 ? glm::normalize(axis) : glm::dvec3(0, 1, 0);
}

enum Sum : std::size_t {
  kInvalid,
  kWeight,
  kH,
  kH2,
  kX,
  kY,
  kCos2,
  kSin2,
  kXh,
  kYh,
  kOwn,
  kOffOwn,
  kOutward,
  kRadius,
  kSums
};

constexpr double kLargestWeight = 40.0;

// A sample that is valid.
void addSample(const SphereView& view, const Results& results, std::size_t i, double own,
               std::span<double> sums) {
  const Vector n = results.vector(i, 3);
  const double pdf = results.number(i, 6);
  const glm::dvec3 out = glm::dvec3(results.vector(i, 0)) - glm::dvec3(view.centre),
                   unit = glm::normalize(out);
  const double named = static_cast<double>(view.oracle.pdf(Vector(unit)));
  const double weight = pdf > 0.0 ? std::min(named / pdf, kLargestWeight) : 0.0;
  const bool outside = view.oracle.outside();
  const DoubleFrame frame(axisOf(view));
  const double h = outside ? std::clamp(view.oracle.coneFraction(Vector(unit)), 0.0, 2.0)
                           : 0.5 * (1.0 - glm::dot(unit, frame.n));
  const double azimuth = frame.azimuth(unit);
  sums[kWeight] += weight;
  sums[kH] += weight * h;
  sums[kH2] += weight * h * h;
  sums[kX] += weight * std::cos(azimuth);
  sums[kY] += weight * std::sin(azimuth);
  sums[kCos2] += weight * std::cos(2.0 * azimuth);
  sums[kSin2] += weight * std::sin(2.0 * azimuth);
  sums[kXh] += weight * h * std::cos(azimuth);
  sums[kYh] += weight * h * std::sin(azimuth);
  const double share = pdf + own > 0.0 ? pdf / (pdf + own) : 0.5;
  sums[kOwn] += std::isfinite(share) ? share : 2.0;
  sums[kOffOwn] += std::abs(share - 0.5) < 1e-3 ? 0.0 : 1.0;
  sums[kOutward] += glm::dot(glm::dvec3(n), unit);
  sums[kRadius] += std::min(glm::length(out) / double{view.radius}, 10.0);
}

void addFeatures(Replicates& sums, const char* name, Signature& signature) {
  const auto words = [&](const char* what) { return fmt::format("{}, {}", what, name); };
  const auto add = [&](const char* what, std::size_t k) { sums.add(signature, words(what), k); };
  add("mean of h, which is 0 in the middle of the sphere and 1 at its limb", kH);
  add("mean of h squared, which is 0 in the middle of the sphere and 1 at its limb", kH2);
  add("mean weight: the contract's density over the one that is returned", kWeight);
  sums.addLength(signature, words("size of the mean of e^(i phi)"), {kX, kY});
  sums.addLength(signature, words("size of the mean of e^(2 i phi)"), {kCos2, kSin2});
  sums.addLength(signature, words("size of the mean of h e^(i phi)"), {kXh, kYh});
  add("density / (density + that of pdf())", kOwn);
  add("share of samples whose density is not that of pdf()", kOffOwn);
  add("mean cosine between n and the outward normal", kOutward);
  add("mean distance from the centre, over the radius", kRadius);
  add("share of answers that are no numbers", kInvalid);
}

}  // namespace

Signature probeSphereSample(const ProbeRun& run) {
  constexpr std::uint32_t kReplicates = 64, kPoints = 256;
  Signature signature;
  for (const View& v : views()) {
    const SphereView& view = v.view;
    Points points(run.seed, kPoints);
    Calls calls(F::kSphereSample), densities(F::kSpherePdf);
    for (std::uint32_t r = 0; r < kReplicates; ++r) {
      points.start(r);
      for (std::uint32_t m = 0; m < kPoints; ++m) {
        points.point(m);
        calls.add(view.centre, view.radius, view.from, points.pair());
      }
    }
    const Results results = calls.run(run.worker), again = calls.run(run.worker);
    for (std::size_t i = 0; i < results.count(); ++i)
      densities.add(view.centre, view.radius, view.from, results.vector(i, 0),
                    results.vector(i, 3));
    const Results own = densities.run(run.worker);
    Replicates sums(kReplicates, kSums);
    double repeated = 0.0;
    for (std::size_t i = 0; i < results.count(); ++i) {
      const auto of = sums.of(static_cast<std::uint32_t>(i / kPoints));
      repeated += results.word(i, 0) == again.word(i, 0) ? 1.0 : 0.0;
      if (results.finite(i) && results.number(i, 6) >= 0.0f)
        addSample(view, results, i, own.number(i, 0), of);
      else
        of[kInvalid] += 1.0;
    }
    sums.divideBy(kPoints);
    addFeatures(sums, v.name, signature);
    signature.add(fmt::format("share of points that are the same again, {}", v.name),
                  repeated / static_cast<double>(results.count()));
  }
  return signature;
}

Signature probeSpherePdf(const ProbeRun& run) {
  Signature signature;
  for (const View& v : views()) {
    const SphereView& view = v.view;
    Calls calls(F::kSpherePdf);
    std::vector<double> cosines{0.999, 0.9, 0.7, 0.4, 0.2, -0.1, -0.8};
    std::vector<double> right;
    Random random(22);
    for (const double cosine : cosines) {
      const Vector n = atCosine(Vector(axisOf(view)), cosine, random.between(0.0, 6.0));
      calls.add(view.centre, view.radius, view.from, view.centre + view.radius * n, n);
      right.push_back(static_cast<double>(view.oracle.pdf(n)));
    }
    const Results results = calls.run(run.worker);
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      const double byArea = 4.0 * std::numbers::pi * double{view.radius} * double{view.radius};
      const bool seen = right[i] > 0.0;
      signature.add(
          fmt::format("{}, {}, where the cosine at the centre is {}",
                      seen ? "pdf over that of the contract" : "pdf times the sphere's area",
                      v.name, cosines[i]),
          results.number(i, 0) * (seen ? 1.0 / right[i] : byArea));
    }
  }
  return signature;
}

}  // namespace pathmark::diagnosis
