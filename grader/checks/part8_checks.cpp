// What is asked of bonus part 8, multiple importance sampling. The path tracer of 8.3 is asked all
// that part 5's is, and what is in part8_light_checks.cpp.
#include "checks/part8_checks.h"

#include "checks/all_checks.h"
#include "checks/calls.h"
#include "checks/exact.h"
#include "checks/part5_checks.h"
#include "checks/points.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Densities {
  float a, b;

  std::string text() const { return fmt::format("a = {:.8g}, b = {:.8g}", a, b); }
};

std::vector<Densities> densities(std::uint64_t seed) {
  std::vector<Densities> all{{1, 1}, {2, 1}, {1, 2}, {3, 4}, {0.25f, 5}, {1e-3f, 2e-3f}};
  Random random(seed);
  for (int k = 0; k < 200; ++k) {
    // Alike, and as different as densities of a light and of a mirror are.
    const double exponent = random.between(-6.0, 6.0);
    const double ratio = random.between(k % 2 == 0 ? -1.0 : -5.0, k % 2 == 0 ? 1.0 : 5.0);
    all.push_back({static_cast<float>(std::pow(10.0, exponent)),
                   static_cast<float>(std::pow(10.0, exponent + ratio))});
  }
  return all;
}

double square(double x) { return x * x; }

Finding weightIsThePowerHeuristic(CheckRun& run) {
  Exact exact{"the balance heuristic a / (a + b), without the squares",
              "a and b are exchanged: the weight of the other technique",
              "a^2 / (a + b)^2 leaves out 2 a b: the weights do not add up to 1",
              "the square of the ratio is missing in the numerator: a / (a^2 + b^2)", "always 1/2"};
  const std::vector<Densities> all = densities(run.seed);
  Calls calls(F::kPowerHeuristic);
  for (const Densities& d : all) calls.add(d.a, d.b);
  const Results results = calls.run(run.worker);
  exact.count(results.count());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double a{all[i].a}, b{all[i].b}, expected = square(a) / (square(a) + square(b));
    exact.value(
        "weight", results.number(i, 0), expected, relativeTolerance() * expected,
        [&] { return all[i].text(); },
        {a / (a + b), 1.0 - expected, square(a / (a + b)), a / (square(a) + square(b)), 0.5});
  }
  return exact.finding();
}

Finding weightAtTheEnds(CheckRun& run) {
  struct Case {
    Densities d;
    double expected;
    const char* why;
  };
  constexpr float kLarge = 1e30f, kSmall = 1e-30f, kTiny = 1e-42f;
  const std::vector<Case> cases{
      {{0, 0}, 0.0, "nobody draws such a sample"},
      {{0, 1}, 0.0, "only the other technique draws it"},
      {{1, 0}, 1.0, "the other technique never draws it"},
      {{kSmall, 0}, 1.0, "the other technique never draws it"},
      {{0, kSmall}, 0.0, "only the other technique draws it"},
      {{kInfinity, 1}, 1.0, "the other density is nothing beside it"},
      {{1, kInfinity}, 0.0, "it is nothing beside the other density"},
      {{kInfinity, 0}, 1.0, "the other technique never draws it"},
      {{0, kInfinity}, 0.0, "only the other technique draws it"},
      {{kInfinity, kInfinity}, 0.5, "neither can be told from the other"},
      {{kLarge, kLarge}, 0.5, "the densities are equal; their squares overflow"},
      {{kLarge, 2 * kLarge}, 0.2, "the squares of the densities overflow"},
      {{kSmall, kSmall}, 0.5, "the densities are equal; their squares underflow"},
      {{2 * kSmall, kSmall}, 0.8, "the squares of the densities underflow"},
      {{kLarge, kSmall}, 1.0, "the other density is nothing beside it"},
      {{kSmall, kLarge}, 0.0, "it is nothing beside the other density"},
      {{1, kTiny}, 1.0, "the other density is nothing beside it"},
      {{kTiny, 1}, 0.0, "it is nothing beside the other density"}};
  Exact exact;
  Calls calls(F::kPowerHeuristic);
  for (const Case& c : cases) calls.add(c.d.a, c.d.b);
  const Results results = calls.run(run.worker);
  exact.count(results.count());
  bool onlyNan = true;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const double weight = results.number(i, 0);
    const bool right = exact.value("weight", weight, cases[i].expected, relativeTolerance(), [&] {
      return fmt::format("{}: {}", cases[i].d.text(), cases[i].why);
    });
    onlyNan = onlyNan && (right || std::isnan(weight));
  }
  Finding finding = exact.finding();
  if (exact.failed() && onlyNan)
    finding.cause =
        "squares that overflow or underflow leave inf / inf or 0 / 0: divide by one of the "
        "densities first, and ask for 0 before";
  return finding;
}

Finding weightsAddUp(CheckRun& run) {
  Exact exact;
  const std::vector<Densities> all = densities(run.seed + 1);
  Calls calls(F::kPowerHeuristic);
  for (const Densities& d : all) calls.add(d.a, d.b);
  for (const Densities& d : all) calls.add(d.b, d.a);
  const Results results = calls.run(run.worker);
  exact.count(results.count());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double one{results.number(i, 0)}, other{results.number(i + all.size(), 0)};
    const auto where = [&] { return all[i].text(); };
    exact.holds(
        one >= 0.0 && one <= 1.0, "a weight in [0,1]",
        [&] { return fmt::format("weight = {:.6g}", one); }, where);
    exact.value("weight of (a, b) + weight of (b, a)", one + other, 1.0, relativeTolerance(),
                where);
  }
  return exact.finding();
}

struct LightPoint {
  Point from;
  LightSample y;

  glm::dvec3 back() const { return glm::dvec3(from) - glm::dvec3(y.p); }
  double distance() const { return glm::length(back()); }
  double cosine() const { return glm::dot(glm::dvec3(y.n), back()) / distance(); }

  // How much a rounding of the coordinates may change the result.
  double condition() const {
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      largest = std::max({largest, std::abs(double{from[axis]}), std::abs(double{y.p[axis]})});
    return 3.0 * (1.0 + largest / distance()) / std::abs(cosine());
  }
  std::string text() const {
    return fmt::format("from = {}, y.p = {}, y.n = {}, y.pdf = {:.8g}", checks::text(from),
                       checks::text(y.p), checks::text(y.n), y.pdf);
  }
};

std::vector<LightPoint> lightPoints(std::uint64_t seed) {
  std::vector<LightPoint> all{{{0, 0, 0}, {{0, 2, 0}, {0, -1, 0}, 0.25f}},
                              {{0, 0, 0}, {{1, 1, 0}, {0, -1, 0}, 3.0f}},
                              {{0, 0, 0}, {{3e-5f, 4e-5f, 0}, {0, -1, 0}, 1e4f}},
                              {{0, 0, 0}, {{3e-7f, 4e-7f, 0}, {0, -1, 0}, 1e4f}}};
  Random random(seed);
  // Small cosines are right too: seen at a grazing angle, a light is there.
  for (int k = 0; k < 60; ++k) {
    LightPoint point;
    point.y = {Point(random.direction()), random.direction(), 2.0f};
    const double cosine = std::pow(10.0, random.between(-3.5, -1.7));
    const Vector towards = atCosine(point.y.n, cosine, random.between(0.0, 6.28));
    point.from = point.y.p + static_cast<float>(random.between(0.5, 2.0)) * towards;
    all.push_back(point);
  }
  while (all.size() < 364) {
    const double size = std::pow(10.0, random.between(-4.0, 4.0));
    LightPoint point;
    point.from = Point(size * random.between(0.0, 2.0) * glm::dvec3(random.direction()));
    point.y.p = Point(size * random.between(0.0, 2.0) * glm::dvec3(random.direction()));
    point.y.n = random.direction();
    point.y.pdf = static_cast<float>(random.between(0.1, 4.0) / (size * size));
    if (std::abs(point.cosine()) > 0.02 && point.distance() > 0.05 * size) all.push_back(point);
  }
  return all;
}

Finding densityIsPerSolidAngle(CheckRun& run) {
  Exact exact{"y.pdf itself: the density per unit area is not converted",
              "r^2 is missing",
              "the cosine at the light is missing",
              "multiplied with cos(theta) / r^2 where it must be divided by",
              "r stands where r^2 belongs",
              "the cosine is a factor where it must be divided by"};
  const std::vector<LightPoint> all = lightPoints(run.seed);
  Calls calls(F::kSolidAnglePdf);
  for (const LightPoint& x : all) calls.add(x.from, x.y.p, x.y.n, x.y.pdf);
  const Results results = calls.run(run.worker);
  exact.count(results.count());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const LightPoint& x = all[i];
    const double pdf{x.y.pdf}, r = x.distance(), cosine = x.cosine();
    if (cosine < 0.0) continue;
    const double expected = pdf * r * r / cosine;
    exact.value("density per unit solid angle", results.number(i, 0), expected,
                relativeTolerance(x.condition()) * expected, [&] { return x.text(); },
                {pdf, pdf / cosine, pdf * r * r, pdf * cosine / (r * r), pdf * r / cosine,
                 pdf * r * r * cosine});
  }
  return exact.finding();
}

Finding noDensityFromBehind(CheckRun& run) {
  std::vector<std::pair<LightPoint, const char*>> all;
  for (const LightPoint& x : lightPoints(run.seed))
    if (x.cosine() < 0.0) all.emplace_back(x, "`from` is behind the light");
  const LightSample y{{1, 2, 3}, {0, -1, 0}, 2.0f};
  all.push_back({{{1, 2, 3}, y}, "`from` is the point itself"});
  all.push_back({{{5, 2, 7}, y}, "`from` is in the plane of the light"});
  all.push_back({{{1, 0, 3}, {y.p, y.n, 0.0f}}, "y.pdf is 0: there is no sample"});
  Calls calls(F::kSolidAnglePdf);
  for (const auto& [x, why] : all) calls.add(x.from, x.y.p, x.y.n, x.y.pdf);
  const Results results = calls.run(run.worker);
  Exact exact;
  exact.count(results.count());
  for (std::size_t i = 0; i < all.size(); ++i)
    exact.holds(
        results.number(i, 0) == 0.0f, "the density 0",
        [&] { return fmt::format("{:.6g}", results.number(i, 0)); },
        [&] { return fmt::format("{}: {}", all[i].first.text(), all[i].second); });
  return exact.finding();
}

}  // namespace

std::span<const Check> part8Checks() {
  static const std::vector<Check> kChecks = [] {
    std::vector<Check> all{
        {"values", F::kPowerHeuristic, "the weight is a^2 / (a^2 + b^2)", 0.0,
         weightIsThePowerHeuristic},
        {"ends", F::kPowerHeuristic,
         "the weight is right also for densities of 0 and infinity, and for those whose squares "
         "are",
         0.0, weightAtTheEnds},
        {"sum", F::kPowerHeuristic, "the weights of both techniques add up to 1", 0.0,
         weightsAddUp},
        {"values", F::kSolidAnglePdf, "the density is y.pdf r^2 / cos(theta)", 0.0,
         densityIsPerSolidAngle},
        {"dark", F::kSolidAnglePdf,
         "the density is 0 from behind the light and in its plane, at the point itself, and where "
         "there is no sample",
         0.0, noDensityFromBehind}};
    // Where the roulette comes is free, before light that the ray finds or after it, and a roulette
    // that is not fair tells them apart: path::lightChecks() has a check of its own for it. What
    // single bounces add is noisier than in part 5, since half of it comes one ray later: "room"
    // and "later-hits" look at bounces.
    for (const Check& check : path::checksOf(F::kTracePathMis))
      if (check.name != "roulette" && check.name != "bounces") all.push_back(check);
    for (const Check& check : path::lightChecks()) all.push_back(check);
    return all;
  }();
  return kChecks;
}

}  // namespace pathmark::checks
