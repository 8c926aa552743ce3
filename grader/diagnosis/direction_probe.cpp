#include "diagnosis/direction_probe.h"

#include "checks/points.h"

#include <algorithm>
#include <cmath>

namespace pathmark::diagnosis {

namespace {

using namespace checks;

// Far above what a reasonable choice of lobes gives.
constexpr double kLargestWeight = 20.0;

double weightOf(double named, double returned) {
  return returned > 0.0 ? std::min(named / returned, kLargestWeight) : 0.0;
}

// At the ends of the numbers' range.
void probeEdges(const ProbeRun& run, const DirectionCase& c, Signature& signature) {
  Calls calls(run.function, c.object);
  for (const float s : kEdgeNumbers)
    for (const float t : kEdgeNumbers)
      for (const float u : kEdgeNumbers) calls.add(c.wo, c.n, s, t, u);
  const Results results = calls.run(run.worker);
  double invalid = 0.0;
  for (std::size_t i = 0; i < results.count(); ++i) invalid += results.finite(i) ? 0.0 : 1.0;
  signature.add("share of answers that are no numbers where s, t, u are 0 or next to 1" + c.where,
                invalid / static_cast<double>(results.count()));
}

}  // namespace

void probeDirections(const ProbeRun& run, const DirectionCase& c, Signature& signature) {
  constexpr std::uint32_t kReplicates = 64, kPoints = 256;
  Points points(run.seed, kPoints);
  Calls calls(run.function, c.object), densities(c.pdf, c.object);
  for (std::uint32_t r = 0; r < kReplicates; ++r) {
    points.start(r);
    for (std::uint32_t m = 0; m < kPoints; ++m) {
      points.point(m);
      const vec2 st = points.pair();
      calls.add(c.wo, c.n, st, points.single());
    }
  }
  const Results results = calls.run(run.worker), again = calls.run(run.worker);
  for (std::size_t i = 0; i < results.count(); ++i) densities.add(c.wo, results.vector(i, 0), c.n);
  const Results own = densities.run(run.worker);
  DirectionMoments moments(c.axis, kReplicates);
  double repeated = 0.0;
  for (std::size_t i = 0; i < results.count(); ++i) {
    const auto replicate = static_cast<std::uint32_t>(i / kPoints);
    const Vector wi = results.vector(i, 0);
    const double returned = results.number(i, 3), named = c.named(wi);
    moments.add(replicate, wi, c.weighted ? weightOf(named, returned) : 1.0);
    moments.densities(replicate, returned, named, own.number(i, 0));
    bool same = true;
    for (std::size_t word = 0; word < 4; ++word)
      same = same && results.word(i, word) == again.word(i, word);
    repeated += same ? 1.0 : 0.0;
  }
  moments.addTo(
      signature, c.where, kPoints,
      c.weighted ? DirectionMoments::Densities::kOwn : DirectionMoments::Densities::kNamed);
  signature.add("share of answers that are the same again" + c.where,
                repeated / static_cast<double>(results.count()));
  probeEdges(run, c, signature);
}

}  // namespace pathmark::diagnosis
