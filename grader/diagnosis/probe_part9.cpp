// Points on triangles and rectangles by the solid angle. Where a light is small enough for any
// density, nothing is asked; which corner a map begins at is left open.
#include "checks/calls.h"
#include "checks/points.h"
#include "checks/seen_light.h"
#include "diagnosis/probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

bool isOfTriangles(F function) {
  return function == F::kSphericalTriangleSampling || function == F::kSphericalTrianglePdf;
}

bool draws(F function) {
  return function == F::kSphericalTriangleSampling || function == F::kSphericalRectangleSampling;
}

// In [0,1], whatever the density is; a half if it is right.
double shareOf(double density, double right) {
  return density >= 0.0 ? density / (density + right) : -1.0;
}

// The place of a point along both edges from the first corner, in [0,1] each.
std::array<double, 2> placeOf(const Outline& outline, const Point& p) {
  const auto& v = outline.vertices();
  const glm::dvec3 a(v[1] - v[0]), b(v.back() - v[0]), to = glm::dvec3(p) - glm::dvec3(v[0]);
  const double aa = glm::dot(a, a), bb = glm::dot(b, b), ab = glm::dot(a, b), pa = glm::dot(to, a),
               pb = glm::dot(to, b), det = aa * bb - ab * ab;
  return {(pa * bb - pb * ab) / det, (pb * aa - pa * ab) / det};
}

// Products of the distances from all edges: large in the middle.
double middleness(const Outline& outline, double a, double b) {
  return outline.vertices().size() == 3 ? 27.0 * a * b * (1.0 - a - b)
                                        : 16.0 * a * (1.0 - a) * b * (1.0 - b);
}

enum Sum : std::size_t { kInvalid, kOutside, kDensity, kMiddle, kA, kB, kAA, kBB, kAB, kSums };

void addPoint(const SeenLight& light, const Results& results, std::size_t i,
              std::span<double> sums) {
  if (!results.finite(i)) {
    sums[kInvalid] += 1.0;
    return;
  }
  const Point p = results.vector(i, 0);
  const auto [a, b] = placeOf(light.outline(), p);
  if (light.outline().distance(p) > 1e-3 * std::sqrt(light.outline().area())) sums[kOutside] += 1.0;
  sums[kDensity] += shareOf(results.number(i, 6), light.density(p));
  sums[kMiddle] += middleness(light.outline(), a, b);
  sums[kA] += a;
  sums[kB] += b;
  sums[kAA] += a * a;
  sums[kBB] += b * b;
  sums[kAB] += a * b;
}

void probePoints(const ProbeRun& run, const SeenLight& light, Signature& signature) {
  constexpr std::uint32_t kReplicates = 32, kPoints = 256;
  Points points(run.seed, kPoints);
  Calls calls(run.function, light.outline().words());
  for (std::uint32_t r = 0; r < kReplicates; ++r) {
    points.start(r);
    for (std::uint32_t m = 0; m < kPoints; ++m) {
      points.point(m);
      calls.add(light.from(), points.pair());
    }
  }
  const Results results = calls.run(run.worker);
  Replicates sums(kReplicates, kSums);
  for (std::size_t i = 0; i < results.count(); ++i)
    addPoint(light, results, i, sums.of(static_cast<std::uint32_t>(i / kPoints)));
  sums.divideBy(kPoints);
  const auto add = [&](const char* what, std::size_t k) {
    sums.add(signature, fmt::format("{} (light: {})", what, light.what()), k);
  };
  add("mean of density / (density + the right one)", kDensity);
  add("mean place of the points along the first edge", kA);
  add("mean place of the points along the last edge", kB);
  add("mean square of the place along the first edge", kAA);
  add("mean square of the place along the last edge", kBB);
  add("mean product of the places along both", kAB);
  add("mean of how far from all edges the points are", kMiddle);
  add("share of the points outside", kOutside);
  add("share of answers that are no numbers", kInvalid);
}

void probeDensity(const ProbeRun& run, const SeenLight& light, Signature& signature) {
  constexpr std::size_t kEvery = 7;
  const auto nodes = light.quadrature();
  Calls calls(run.function, light.outline().words());
  for (std::size_t k = 0; k < nodes.size(); k += kEvery) calls.add(light.from(), nodes[k].first);
  const Results results = calls.run(run.worker);
  double share = 0.0, invalid = 0.0;
  for (std::size_t i = 0; i < results.count(); ++i) {
    const double density{results.number(i, 0)};
    if (std::isfinite(density))
      share += shareOf(density, light.density(nodes[i * kEvery].first));
    else
      invalid += 1.0;
  }
  const auto count = static_cast<double>(results.count());
  signature.add(
      fmt::format("mean of density / (density + the right one) (light: {})", light.what()),
      share / count);
  signature.add(fmt::format("share of answers that are no numbers (light: {})", light.what()),
                invalid / count);
}

// From behind, and in the plane.
void probeDarkness(const ProbeRun& run, const SeenLight& light, Signature& signature) {
  const auto& v = light.outline().vertices();
  const std::pair<const char*, Point> places[] = {
      {"behind the light", v[0] - (light.from() - v[0])},
      {"in the light's plane", v[0] + 3.0f * (v[0] - v[1]) + 2.0f * (v[0] - v.back())}};
  for (const auto& [what, from] : places) {
    Calls calls(run.function, light.outline().words());
    if (draws(run.function))
      calls.add(from, vec2(0.3f, 0.6f));
    else
      calls.add(from, v[0] + 0.3f * (v[1] - v[0]) + 0.3f * (v.back() - v[0]));
    const Results results = calls.run(run.worker);
    const double density{results.number(0, draws(run.function) ? 6 : 0)};
    signature.add(fmt::format("sign of the density {}", what),
                  density == 0.0 ? 0.0 : std::copysign(1.0, density));
  }
}

}  // namespace

Signature probePart9(const ProbeRun& run) {
  Signature signature;
  const std::vector<SeenLight> lights = lightsInSight(isOfTriangles(run.function), 91);
  for (const SeenLight& light : lights) {
    // Close to the limit a sum of angles in float may fall on either side of it.
    if (light.omega() < 4.0 * kSmallestSolidAngle) continue;
    if (draws(run.function))
      probePoints(run, light, signature);
    else
      probeDensity(run, light, signature);
  }
  probeDarkness(run, lights.front(), signature);
  return signature;
}

}  // namespace pathmark::diagnosis
