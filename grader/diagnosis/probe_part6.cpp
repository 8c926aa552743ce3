// Russian roulette. Which probability a path survives with is left open: described is how the
// weight goes with the probability, over many paths.
#include "checks/calls.h"
#include "checks/points.h"
#include "diagnosis/probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

constexpr std::uint32_t kNumbers = 8192;  // u for each path, one in each of as many strata

struct Path {
  Colour throughput;
  int depth;

  bool oneBlack() const { return std::min({throughput.x, throughput.y, throughput.z}) == 0.0f; }
  bool mustEnd() const {
    return depth >= 4 && std::max({throughput.x, throughput.y, throughput.z}) <= 0.5f;
  }
};

std::vector<Path> paths() {
  std::vector<Path> all;
  for (const Colour& throughput :
       {Colour(0.5f), Colour(0.3f), Colour(0.1f), Colour(0.03f), Colour(1e-3f), Colour(1e-6f),
        Colour(0.2f, 0.1f, 0.3f), Colour(0.4f, 0.0f, 0.0f), Colour(0.0f, 0.3f, 0.2f),
        Colour(0.9f, 0.01f, 0.2f), Colour(0.7f, 0.8f, 0.75f), Colour(3.0f)})
    for (const int depth : {1, 4, 12}) all.push_back({throughput, depth});
  return all;
}

struct Fate {
  double q = 0.0;       // share of the u with which it survives
  double weight = 0.0;  // its mean where it survives
};

std::vector<Fate> fates(const ProbeRun& run, const std::vector<Path>& all, Signature& signature) {
  Random random(run.seed);
  Calls calls(F::kRussianRoulette);
  for (const Path& path : all)
    for (std::uint32_t k = 0; k < kNumbers; ++k) {
      const double u = (k + 0.998 * random.number()) / kNumbers;
      calls.add(path.throughput, path.depth, std::min(u, 1.0 - 0x1p-24));
    }
  const Results results = calls.run(run.worker), again = calls.run(run.worker);
  double repeated = 0.0;
  std::vector<Fate> result(all.size());
  for (std::size_t i = 0; i < results.count(); ++i) {
    repeated += results.word(i, 0) == again.word(i, 0) ? 1.0 : 0.0;
    if (results.word(i, 0) == 0) continue;
    Fate& fate = result[i / kNumbers];
    fate.q += 1.0 / kNumbers;
    fate.weight += results.number(i, 1);
  }
  for (Fate& fate : result)
    if (fate.q > 0.0) fate.weight /= fate.q * kNumbers;
  signature.addAnswer("whether the same arguments give the same answer again",
                      repeated == static_cast<double>(results.count()));
  return result;
}

bool near(double a, double b) { return std::abs(a - b) <= 4e-3 * std::max(std::abs(b), 1.0); }

}  // namespace

Signature probePart6(const ProbeRun& run) {
  Signature signature;
  const std::vector<Path> all = paths();
  const std::vector<Fate> of = fates(run, all, signature);
  const auto share = [&](const char* what, const auto& among, const auto& holds) {
    double count = 0.0, held = 0.0;
    for (std::size_t p = 0; p < all.size(); ++p) {
      if (!among(all[p], of[p])) continue;
      count += 1.0;
      held += holds(all[p], of[p]) ? 1.0 : 0.0;
    }
    signature.add(fmt::format("{} (-1: there is none)", what), count > 0.0 ? held / count : -1.0);
  };
  const auto sometimes = [](const Path&, const Fate& f) { return f.q > 1e-3 && f.q < 0.999; };
  const auto toEnd = [](const Path& p, const Fate&) { return p.mustEnd(); };
  share("share of the paths that end sometimes whose weight is 1/q", sometimes,
        [](const Path&, const Fate& f) { return near(f.q * f.weight, 1.0); });
  share("share of the paths that end sometimes whose weight is 1", sometimes,
        [](const Path&, const Fate& f) { return near(f.weight, 1.0); });
  share("share of the paths that end sometimes whose weight is 1/(1 - q)", sometimes,
        [](const Path&, const Fate& f) { return near((1.0 - f.q) * f.weight, 1.0); });
  share(
      "share of the paths with a black channel that never survive",
      [](const Path& p, const Fate&) { return p.oneBlack(); },
      [](const Path&, const Fate& f) { return f.q == 0.0; });
  share(
      "share of the paths without a black channel that never survive",
      [](const Path& p, const Fate&) { return !p.oneBlack() && p.throughput.x > 0.01f; },
      [](const Path&, const Fate& f) { return f.q == 0.0; });
  share(
      "share of the dark paths that never survive",
      [](const Path& p, const Fate&) { return p.mustEnd() && p.throughput.x == 1e-6f; },
      [](const Path&, const Fate& f) { return f.q < 1e-3; });
  share("share of the paths that must end sometimes and never do", toEnd,
        [](const Path&, const Fate& f) { return f.q > 0.999; });
  share(
      "share of the weights that are below 1", [](const Path&, const Fate& f) { return f.q > 0.0; },
      [](const Path&, const Fate& f) { return f.weight < 0.996; });
  std::vector<double> products;
  bool falls = false;
  for (std::size_t p = 0; p < all.size(); ++p)
    if (sometimes(all[p], of[p])) products.push_back(of[p].q * of[p].weight);
  for (std::size_t p = 0; p + 6 < all.size(); ++p)
    if (all[p].throughput == Colour(0.3f) && all[p].depth == 12)
      falls = of[p].q + 0.01 < of[p + 3].q;
  std::sort(products.begin(), products.end());
  // A choice of the probability does not change this where the weight is in proportion to 1/q.
  const bool alike = !products.empty() && near(products.front(), products.back());
  signature.add("q times the weight, if that is the same for all paths (-1: it is not)",
                alike ? products[products.size() / 2] : -1.0, 0.0, 10.0);
  signature.addAnswer("whether darker paths survive more often", falls);
  Calls black(F::kRussianRoulette);
  for (const float u : kEdgeNumbers) black.add(Colour(0.0f), 5, u);
  const Results results = black.run(run.worker);
  bool lives = false;
  for (std::size_t i = 0; i < results.count(); ++i) lives = lives || results.word(i, 0) != 0;
  signature.addAnswer("whether a black path ever survives", lives);
  return signature;
}

}  // namespace pathmark::diagnosis
