// Multiple importance sampling: weights and densities, which have one right value each.
#include "checks/calls.h"
#include "diagnosis/mis_probe.h"
#include "diagnosis/probes.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

Signature probeWeights(const ProbeRun& run) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr std::array<std::array<float, 2>, 16> kDensities{{{1, 1},
                                                             {3, 4},
                                                             {4, 3},
                                                             {0.25f, 5},
                                                             {1e-3f, 2e-3f},
                                                             {0, 0},
                                                             {0, 1},
                                                             {1, 0},
                                                             {kInfinity, 1},
                                                             {1, kInfinity},
                                                             {kInfinity, kInfinity},
                                                             {1e30f, 1e30f},
                                                             {1e30f, 2e30f},
                                                             {2e-30f, 1e-30f},
                                                             {1e30f, 1e-30f},
                                                             {1e-30f, 1e30f}}};
  Calls calls(F::kPowerHeuristic);
  for (const auto& [a, b] : kDensities) calls.add(a, b);
  const Results results = calls.run(run.worker);
  Signature signature;
  for (std::size_t k = 0; k < kDensities.size(); ++k)
    signature.add(fmt::format("weight for a = {:g}, b = {:g}", kDensities[k][0], kDensities[k][1]),
                  double{results.number(k, 0)});
  return signature;
}

struct Place {
  const char* what;
  Point from;
  LightSample y;
  double right;  // 0: none is seen
};

Signature probeDensities(const ProbeRun& run) {
  const Vector down(0, -1, 0);
  const Place places[] = {
      {"two above", {0, 0, 0}, {{0, 2, 0}, down, 0.25f}, 1.0},
      {"half above", {0, 0, 0}, {{0, 0.5f, 0}, down, 2.0f}, 0.5},
      {"aside", {0, 0, 0}, {{3, 4, 0}, down, 3.0f}, 93.75},
      {"aside and near", {0, 0, 0}, {{0.3f, 0.4f, 0}, down, 3.0f}, 0.9375},
      {"at a grazing angle", {0, 0, 0}, {{0.99995f, 0.01f, 0}, down, 0.02f}, 2.0},
      {"in a very small scene", {0, 0, 0}, {{3e-7f, 4e-7f, 0}, down, 1e12f}, 0.3125},
      {"behind the light", {0, 3, 0}, {{0, 2, 0}, down, 0.25f}, 0.0},
      {"behind it and aside", {3, 6, 0}, {{0, 2, 0}, down, 0.25f}, 0.0},
      {"in the light's plane", {5, 2, 7}, {{1, 2, 3}, down, 2.0f}, 0.0},
      {"at the point itself", {1, 2, 3}, {{1, 2, 3}, down, 2.0f}, 0.0},
      {"where there is no sample", {1, 0, 3}, {{1, 2, 3}, down, 0.0f}, 0.0}};
  Calls calls(F::kSolidAnglePdf);
  for (const Place& place : places) calls.add(place.from, place.y.p, place.y.n, place.y.pdf);
  const Results results = calls.run(run.worker);
  Signature signature;
  for (std::size_t k = 0; k < std::size(places); ++k) {
    const Place& place = places[k];
    const double density{results.number(k, 0)};
    if (place.right > 0.0)
      signature.add(fmt::format("density / (density + the right one), {}", place.what),
                    density >= 0.0 ? density / (density + place.right) : -1.0);
    else
      signature.add(fmt::format("sign of the density {}", place.what),
                    density == 0.0 ? 0.0 : std::copysign(1.0, density));
  }
  return signature;
}

}  // namespace

Signature probePart8(const ProbeRun& run) {
  if (run.function == F::kPowerHeuristic) return probeWeights(run);
  if (run.function == F::kSolidAnglePdf) return probeDensities(run);
  return probePathMis(run);
}

}  // namespace pathmark::diagnosis
