// What is asked of part 6, Russian roulette.
#include "checks/all_checks.h"
#include "checks/calls.h"
#include "checks/exact.h"
#include "checks/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

// u is a multiple of this.
constexpr double kStep = 0x1p-24;
constexpr std::uint32_t kSteps = 1u << 24;

float uOf(std::uint32_t step) { return static_cast<float>(step) * 0x1p-24f; }

struct Path {
  Colour throughput;
  int depth;

  float largest() const { return std::max({throughput.x, throughput.y, throughput.z}); }
  float mean() const { return (throughput.x + throughput.y + throughput.z) / 3.0f; }
  float luminance() const { return glm::dot(throughput, Colour(0.2126f, 0.7152f, 0.0722f)); }
  std::string text() const {
    return fmt::format("throughput = {}, depth = {}", checks::text(throughput), depth);
  }
};

constexpr int kDepths[] = {1, 2, 3, 4, 5, 8, 20, 33, 64, 1000};
constexpr int kFirstEnding = 4;  // depth from which on dark paths must end now and then

// From plain ones to those that carry one colour only, next to nothing, or more than 1.
std::vector<Path> paths(std::uint64_t seed) {
  std::vector<Colour> throughputs{
      Colour(0.5f),       Colour(0.3f),         Colour(1.0f),           {0.2f, 0.1f, 0.3f},
      {0.4f, 0.0f, 0.0f}, {0.0f, 0.3f, 0.0f},   {0.0f, 0.0f, 0.4f},     {0.9f, 0.01f, 0.2f},
      Colour(0.03f),      {1e-3f, 2e-3f, 0.0f}, Colour(1e-6f),          {0.0f, 0.0f, 1e-20f},
      {1.5f, 0.1f, 0.0f}, Colour(3.0f),         {0.999f, 0.999f, 0.0f}, {0.04f, 0.05f, 0.0f},
  };
  Random random(seed);
  for (int k = 0; k < 4; ++k)
    throughputs.emplace_back(random.number(), random.number(), random.number());
  std::vector<Path> result;
  for (const Colour& throughput : throughputs)
    for (const int depth : kDepths) result.push_back({throughput, depth});
  return result;
}

// What becomes of a path, over all u.
struct Outcome {
  double survival = 0.0;      // share of the u with which it survives
  double mean = 0.0;          // of survives * weight
  bool smallSurvive = false;  // with u = 0
  bool largeSurvive = false;  // with the largest u
  double weight = 0.0;        // at some u with which it survives
  int changes = 0;            // of its fate, from u = 0 upwards
  double error = 0.0;         // standard error of the mean, where it is not exact
};

// Finds the u at which a path changes its fate by bisection, between points that are evenly spread.
class Sweep {
 public:
  Sweep(CheckRun& run, std::span<const Path> paths) : run_(run), paths_(paths) {
    constexpr std::uint32_t kStrata = 64;
    Random random(run.seed);
    for (std::size_t p = 0; p < paths.size(); ++p) {
      ask(p, 0);
      for (std::uint32_t k = 0; k < kStrata; ++k) {
        const std::uint32_t width = kSteps / kStrata;
        const std::uint32_t step = k * width + random.bits() % width;
        if (step != 0 && step != kSteps - 1) ask(p, step);
      }
      ask(p, kSteps - 1);
    }
    answer();
    while (bisect()) answer();
  }

  std::vector<Outcome> outcomes() const {
    std::vector<Outcome> result(paths_.size());
    std::size_t i = 0;
    for (std::size_t p = 0; p < paths_.size(); ++p) {
      Outcome& outcome = result[p];
      outcome.smallSurvive = known_[i].survives;
      for (; i < known_.size() && known_[i].path == p; ++i) {
        const bool last = i + 1 == known_.size() || known_[i + 1].path != p;
        if (last) outcome.largeSurvive = known_[i].survives;
        if (!last && known_[i + 1].survives != known_[i].survives) ++outcome.changes;
        if (!known_[i].survives) continue;
        // An answer stands for the u up to the next one asked, itself included.
        const std::uint32_t end = last ? kSteps : known_[i + 1].step;
        const double share = static_cast<double>(end - known_[i].step) * kStep;
        outcome.survival += share;
        outcome.mean += share * known_[i].weight;
        outcome.weight = known_[i].weight;
      }
    }
    return result;
  }

  std::uint64_t calls() const { return calls_; }

 private:
  struct Answer {
    std::size_t path;
    std::uint32_t step;
    bool survives = false;
    double weight = 0.0;
  };

  void ask(std::size_t path, std::uint32_t step) { asked_.push_back({path, step}); }

  void answer() {
    Calls calls(F::kRussianRoulette);
    for (const Answer& a : asked_)
      calls.add(paths_[a.path].throughput, paths_[a.path].depth, uOf(a.step));
    const Results results = calls.run(run_.worker);
    calls_ += results.count();
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      asked_[i].survives = results.word(i, 0) != 0;
      asked_[i].weight = results.number(i, 1);
    }
    known_.insert(known_.end(), asked_.begin(), asked_.end());
    asked_.clear();
    std::sort(known_.begin(), known_.end(), [](const Answer& a, const Answer& b) {
      return a.path != b.path ? a.path < b.path : a.step < b.step;
    });
  }

  bool bisect() {
    for (std::size_t i = 0; i + 1 < known_.size(); ++i) {
      const Answer &a = known_[i], &b = known_[i + 1];
      if (a.path == b.path && a.survives != b.survives && b.step - a.step > 1)
        ask(a.path, a.step + (b.step - a.step) / 2);
    }
    return !asked_.empty();
  }

  CheckRun& run_;
  std::span<const Path> paths_;
  std::vector<Answer> known_, asked_;  // known_ in the order of paths and u
  std::uint64_t calls_ = 0;
};

Finding answersAreValid(CheckRun& run) {
  struct Input {
    Path path;
    float u;
  };
  std::vector<Input> inputs;
  Random random(run.seed);
  std::vector<Path> all = paths(run.seed);
  for (const int depth : kDepths) all.push_back({Colour(0.0f), depth});
  for (const Path& path : all) {
    for (const float u : kEdgeNumbers) inputs.push_back({path, u});
    for (int k = 0; k < 4; ++k) inputs.push_back({path, random.uniform()});
  }
  Calls calls(F::kRussianRoulette);
  for (const Input& in : inputs) calls.add(in.path.throughput, in.path.depth, in.u);
  for (auto in = inputs.rbegin(); in != inputs.rend(); ++in)
    calls.add(in->path.throughput, in->path.depth, in->u);
  const Results results = calls.run(run.worker);
  Exact exact;
  exact.count(results.count());
  bool blackHasWeight = false;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input& in = inputs[i];
    const auto where = [&] { return fmt::format("{}, u = {:.8g}", in.path.text(), in.u); };
    const auto answer = [&](std::size_t call) {
      return fmt::format("{{{}, {:.6g}}}", results.word(call, 0) != 0 ? "true" : "false",
                         results.number(call, 1));
    };
    const bool survives = results.word(i, 0) != 0;
    const double weight = results.number(i, 1);
    const std::size_t again = results.count() - 1 - i;
    exact.holds(
        results.same(i, again), "the same answer again for the same throughput, depth and u",
        [&] { return fmt::format("{} and then {}", answer(i), answer(again)); }, where);
    const auto got = [&] { return answer(i); };
    const bool black = in.path.largest() == 0.0f;
    if (black) {
      exact.holds(!survives, "{false, 0}, since nothing can come of a throughput of 0", got, where);
      blackHasWeight = blackHasWeight || weight != 0.0;
    } else if (survives) {
      exact.holds(std::isfinite(weight) && weight >= 1.0 - relativeTolerance(),
                  "a weight of at least 1, which is 1/q of a probability q", got, where);
    }
  }
  Finding finding = exact.finding();
  if (finding.passed() && blackHasWeight)
    finding.remark = "correct, but for a throughput of 0 the contract names the weight 0";
  return finding;
}

// By many u at random, one in each of many strata.
Outcome outcomeOfManyNumbers(CheckRun& run, const Path& path, Random& random) {
  constexpr std::uint32_t kStrata = 1u << 16, kWidth = kSteps / kStrata;
  Calls calls(F::kRussianRoulette);
  for (std::uint32_t k = 0; k < kStrata; ++k)
    calls.add(path.throughput, path.depth, uOf(k * kWidth + random.bits() % kWidth));
  const Results results = calls.run(run.worker);
  Outcome outcome;
  double squares = 0.0;
  for (std::size_t i = 0; i < results.count(); ++i) {
    if (results.word(i, 0) == 0) continue;
    outcome.weight = results.number(i, 1);
    outcome.survival += 1.0 / kStrata;
    outcome.mean += outcome.weight / kStrata;
    squares += outcome.weight * outcome.weight / kStrata;
  }
  const double variance = squares - outcome.mean * outcome.mean;
  outcome.error = std::sqrt(std::max(variance, 0.0) / kStrata);
  return outcome;
}

// Where the u that survive are no interval, bisection may overlook some of them: late digits of a
// u that has chosen a lobe before, for instance.
std::vector<Outcome> outcomesOf(CheckRun& run, const std::vector<Path>& all, Exact& exact) {
  const Sweep sweep(run, all);
  exact.count(sweep.calls());
  std::vector<Outcome> outcomes = sweep.outcomes();
  const bool intervals = std::all_of(outcomes.begin(), outcomes.end(),
                                     [](const Outcome& o) { return o.changes <= 2; });
  if (intervals) return outcomes;
  Random random(run.seed);
  for (std::size_t p = 0; p < all.size(); ++p)
    outcomes[p] = outcomeOfManyNumbers(run, all[p], random);
  return outcomes;
}

// Exact up to the steps of u: rounding of q, and of 1/q.
double allowedFor(const Outcome& outcome) {
  constexpr double kErrors = 6.0;
  return relativeTolerance() + 2.0 * kStep * std::max(outcome.weight, 1.0) +
         kErrors * outcome.error;
}

// Whether what is wrong is that the darkest paths never survive.
bool onlyCut(const std::vector<Path>& all, const std::vector<Outcome>& outcomes) {
  constexpr float kNone = 1e9f;
  float brightestCut = 0.0f, darkestRight = kNone;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const bool right = std::abs(outcomes[p].mean - 1.0) <= allowedFor(outcomes[p]);
    if (!right && outcomes[p].survival > 0.0) return false;
    if (all[p].depth < kFirstEnding) continue;
    if (right)
      darkestRight = std::min(darkestRight, all[p].largest());
    else
      brightestCut = std::max(brightestCut, all[p].largest());
  }
  return brightestCut > 0.0f && darkestRight < kNone && brightestCut < darkestRight;
}

// Empty if some path survives at the largest depth.
std::string causeOfNoSurvivors(const std::vector<Path>& all, const std::vector<Outcome>& outcomes) {
  int deepest = 0;  // at which some path survives
  for (std::size_t p = 0; p < all.size(); ++p)
    if (outcomes[p].survival > 0.0) deepest = std::max(deepest, all[p].depth);
  const auto next = std::upper_bound(std::begin(kDepths), std::end(kDepths), deepest);
  if (next == std::end(kDepths)) return {};
  const int first = std::max(*next, all.front().depth);
  if (first == kFirstEnding)
    return "from depth 4 on no path survives: is the probability a quotient of integers, such as "
           "1/2, which is 0?";
  return fmt::format(
      "at depth {} no path survives any more: what it would still have carried is lost; "
      "maxBounces() is the only limit, and tracePath keeps it",
      first);
}

// Whether bright paths survive more often than dark ones, 1, or less often, -1, or neither, 0.
int survivalGoesWithThroughput(const std::vector<Path>& all, const std::vector<Outcome>& outcomes) {
  constexpr double kClear = 0.01;
  const auto survivalOf = [&](const Colour& throughput) {
    for (std::size_t p = 0; p < all.size(); ++p)
      if (all[p].throughput == throughput && all[p].depth == 8) return outcomes[p].survival;
    return 0.0;
  };
  const double difference = survivalOf(Colour(0.5f)) - survivalOf(Colour(1e-6f));
  return std::abs(difference) < kClear ? 0 : difference > 0.0 ? 1 : -1;
}

Finding meanIsOne(CheckRun& run) {
  const std::vector<Path> all = paths(run.seed);
  Exact exact{"the weight is always 1: survivors must stand for those that ended, with 1/q",
              "the weight is q instead of 1/q",
              "the weight is 1/(1 - q), for a path that survives with probability q",
              "the test is turned round: the path survives with probability 1 - q and has the "
              "weight 1/q",
              "the weight is 1/(largest channel), but the path does not survive with that "
              "probability",
              "the weight is 1/(mean of the channels), but the path does not survive with that "
              "probability",
              "the weight is 1/luminance, but the path does not survive with that probability",
              "a throughput with a black channel ends, though the other channels carry light",
              "no path ever survives"};
  const std::vector<Outcome> outcomes = outcomesOf(run, all, exact);
  // A test that is turned round and a weight of 1 - q give the same mean. The first lets dark paths
  // live rather than bright ones, and where the probability is the same for all, large u.
  const int goes = survivalGoesWithThroughput(all, outcomes);
  for (std::size_t p = 0; p < all.size(); ++p) {
    const Outcome& o = outcomes[p];
    const bool turned = goes == 0 ? o.largeSurvive : goes < 0,
               notTurned = goes == 0 ? o.smallSurvive : goes > 0;
    const Colour& c = all[p].throughput;
    const double q = o.survival;
    const bool oneBlack = std::min({c.x, c.y, c.z}) == 0.0f;
    const double others = q > 0.0 && q < 1.0 ? q / (1.0 - q) : o.mean;
    exact.value("mean over u of survives * weight", o.mean, 1.0, allowedFor(o),
                [&] {
                  return fmt::format("{}, where {:.6g} of all u survive, with the weight {:.6g}",
                                     all[p].text(), q, o.weight);
                },
                {q, q * q, turned && q < 1.0 ? -1.0 : others, notTurned && q < 1.0 ? -1.0 : others,
                 q / double{all[p].largest()}, q / double{all[p].mean()},
                 q / double{all[p].luminance()}, oneBlack ? 0.0 : 1.0, 0.0});
  }
  Finding finding = exact.finding();
  if (finding.passed() || !finding.cause.empty()) return finding;
  finding.cause = causeOfNoSurvivors(all, outcomes);
  if (finding.cause.empty() && onlyCut(all, outcomes))
    finding.cause =
        "dark paths always end: what they would still have carried is lost; let some of them "
        "survive, with a larger weight";
  return finding;
}

Finding darkPathsEnd(CheckRun& run) {
  std::vector<Path> all = paths(run.seed);
  std::erase_if(all, [](const Path& p) { return p.depth < kFirstEnding || p.largest() > 0.5f; });
  Exact exact;
  const std::vector<Outcome> outcomes = outcomesOf(run, all, exact);
  bool neverEnds = true, unbounded = true, endsLater = true;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const double q = outcomes[p].survival;
    neverEnds = neverEnds && q == 1.0;
    endsLater = endsLater && (all[p].depth == kFirstEnding) == (q == 1.0);
    unbounded = unbounded && q <= std::max(0.95, 4.0 * double{all[p].largest()});
    const double slack = allowedFor(outcomes[p]) * q;
    exact.holds(
        q >= 0.05 - slack && q <= 0.95 + slack, "to survive with a probability of 0.05 to 0.95",
        [&] { return fmt::format("the path survives with probability {:.6g}", q); },
        [&] { return all[p].text(); });
  }
  Finding finding = exact.finding();
  if (finding.passed()) return finding;
  const bool darkest = std::any_of(outcomes.begin(), outcomes.end(),
                                   [](const Outcome& o) { return o.survival < 0.01; });
  if (neverEnds)
    finding.cause =
        "no path ever ends: the roulette is not written, or the probability is clamped from the "
        "wrong side";
  else if (endsLater)
    finding.cause = "at depth 4 no path ever ends: from depth 4 on means that 4 is one of them";
  else if (const std::string cause = causeOfNoSurvivors(all, outcomes); !cause.empty())
    finding.cause = cause;
  else if (unbounded && darkest)
    finding.cause =
        "the probability has no lower bound: survivors of dark paths get enormous weights";
  return finding;
}

}  // namespace

std::span<const Check> part6Checks() {
  static const std::vector<Check> kChecks{
      {"valid", F::kRussianRoulette,
       "a path that survives has a weight of at least 1, one that carries nothing ends, and the "
       "answer is the same again for the same throughput, depth and u",
       0.0, answersAreValid},
      {"mean", F::kRussianRoulette,
       "the mean over u of survives * weight is 1 for every throughput that is not 0", 0.0,
       meanIsOne},
      {"ends", F::kRussianRoulette,
       "from depth 4 on, a path with at most 0.5 in every channel survives with a probability of "
       "0.05 to 0.95",
       0.0, darkPathsEnd},
  };
  return kChecks;
}

}  // namespace pathmark::checks
