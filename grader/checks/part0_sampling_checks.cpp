// What is asked of part 0: random numbers and uniform directions.
#include "checks/calls.h"
#include "checks/direction_checks.h"
#include "checks/exact.h"
#include "checks/part0_checks.h"
#include "checks/pcg2d.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr double kPiD = std::numbers::pi;
constexpr double kRoundoff = 0x1p-24;

std::string hex(uvec2 v) { return fmt::format("({:#010x}, {:#010x})", v.x, v.y); }

// The published seed first; some that are hashed to the ends of the range, where conversions to
// float go wrong; then any.
std::vector<uvec2> seeds(std::uint64_t seed) {
  std::vector<uvec2> result{{0, 0}, {1, 0}, {0, 1}};
  for (const std::uint32_t x : {0xffffffffu, 0xffffff80u, 0xffffff7fu, 0u, 0x80000000u, 0x7fu})
    for (const std::uint32_t y : {0xffffffffu, 0xffffff80u, 0x7fffffffu, 0u})
      result.push_back(seedOf({x, y}));
  Random random(seed);
  for (int k = 0; k < 1000; ++k) {
    const std::uint32_t x = random.bits();
    result.emplace_back(x, random.bits());
  }
  return result;
}

// PCG2D with one mistake.
enum class Slip { kOldX, kNoXor, kOneRound, kNoIncrement };

uvec2 hashWith(Slip slip, uvec2 v) {
  v = v * pcg::kMultiplier + (slip == Slip::kNoIncrement ? 0u : pcg::kIncrement);
  for (int round = 0; round < (slip == Slip::kOneRound ? 1 : 2); ++round) {
    const std::uint32_t oldX = v.x;
    v.x += pcg::kMultiplier * v.y;
    v.y += pcg::kMultiplier * (slip == Slip::kOldX ? oldX : v.x);
    if (slip != Slip::kNoXor) v ^= v >> 16u;
  }
  return v;
}

// Whether a number of this call comes from the hash, though the hash may not have been stored.
bool isOneOf(const Results& results, std::size_t call, const uvec2& hash) {
  constexpr double kAllowed = 0x1p-20;
  for (const std::uint32_t word : {hash.x, hash.y})
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}})
      if (std::abs(results.number(call, k) - word * 0x1p-32) <= kAllowed) return true;
  return false;
}

Finding seedIsHashed(CheckRun& run) {
  const std::vector<uvec2> inputs = seeds(run.seed);
  Calls calls(F::kGetRandomNumbers);
  for (const uvec2& s : inputs) calls.add(s);
  const Results results = calls.run(run.worker);
  Exact exact{
      "the seed that was handed over is not changed: `seed` is a reference, and a copy of it may "
      "be changed instead",
      "v.y is changed with the old v.x; it needs the new one", "v ^= v >> 16 is missing",
      "one of the two rounds is missing", "1013904223 is not added"};
  exact.count(results.count());
  bool unchanged = true;
  std::size_t hashed = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const uvec2 expected = pcg2d(inputs[i]), got(results.word(i, 2), results.word(i, 3));
    exact.answer(
        got, expected, "new seed " + hex(expected), [&] { return "new seed " + hex(got); },
        [&] { return "seed " + hex(inputs[i]); },
        {inputs[i], hashWith(Slip::kOldX, inputs[i]), hashWith(Slip::kNoXor, inputs[i]),
         hashWith(Slip::kOneRound, inputs[i]), hashWith(Slip::kNoIncrement, inputs[i])});
    unchanged = unchanged && got == inputs[i];
    if (isOneOf(results, i, expected)) ++hashed;
  }
  Finding finding = exact.finding();
  if (!finding.passed() && unchanged && 2 * hashed < inputs.size())
    finding.cause =
        "the seed is not changed, and the numbers are not those of its hash: both numbers come "
        "from `seed` alone, not from another generator such as rand()";
  return finding;
}

// Any use of the high bits is right: the upper 24, the upper 23 by way of the bits of a float, all
// with a clamp or a factor just below 1; and either component may come first.
Finding numbersAreTheHighBits(CheckRun& run) {
  constexpr double kAllowed = 0x1p-20;
  const std::vector<uvec2> inputs = seeds(run.seed);
  Calls calls(F::kGetRandomNumbers);
  for (const uvec2& s : inputs) calls.add(s);
  const Results results = calls.run(run.worker);
  const auto fits = [&](std::size_t i, std::uint32_t x, std::uint32_t y) {
    return std::abs(results.number(i, 0) - x * 0x1p-32) <= kAllowed &&
           std::abs(results.number(i, 1) - y * 0x1p-32) <= kAllowed;
  };
  const bool swapped = !fits(0, results.word(0, 2), results.word(0, 3)) &&
                       fits(0, results.word(0, 3), results.word(0, 2));
  Exact exact{
      "a 32-bit integer near 2^32 is rounded up when it becomes a float, and times 2^-32 it "
      "is exactly 1: convert the upper 24 bits only",
      "both numbers are made from v.x; one comes from v.x and one from v.y",
      "both numbers are made from v.y; one comes from v.x and one from v.y"};
  exact.count(results.count());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto where = [&] {
      return fmt::format("seed {}, which becomes {}", hex(inputs[i]),
                         hex({results.word(i, 2), results.word(i, 3)}));
    };
    for (std::size_t c = 0; c < 2; ++c) {
      const double got = results.number(i, c);
      const std::uint32_t word = results.word(i, 2 + (swapped ? 1 - c : c));
      const bool roundedUp = static_cast<float>(word) * 0x1p-32f >= 1.0f;
      exact.answer(got >= 0.0 && got < 1.0, true, "numbers of at least 0 and below 1",
                   [&] { return fmt::format("number {} = {:.9g}", c + 1, got); }, where,
                   {!roundedUp, true, true});
      exact.value(fmt::format("number {}", c + 1), got, word * 0x1p-32, kAllowed, where,
                  {word * 0x1p-32, results.word(i, 2) * 0x1p-32, results.word(i, 3) * 0x1p-32});
    }
  }
  return exact.finding();
}

// Density 1 / (4 pi), or 1 / (2 pi) on the hemisphere. A direction on the horizon may be rounded to
// either side.
const AxialDensity kSphereDensity{
    .density = [](double) { return 0.25 / kPiD; },
    .mass = [](double low, double high) { return 0.5 * (high - low); },
    .lowest = -1.0,
    .meanCosine = 0.0,
    .meanCosine2 = 1.0 / 3.0};
const AxialDensity kHemisphereDensity{
    .density = [](double c) { return c > -1e-6 ? 0.5 / kPiD : 0.0; },
    .mass = [](double low, double high) { return high - low; },
    .meanCosine = 0.5,
    .meanCosine2 = 1.0 / 3.0};

struct DirectionInput {
  vec2 u;
  Vector n;
};

Calls directionCalls(F function, const std::vector<DirectionInput>& inputs) {
  Calls calls(function);
  for (const DirectionInput& in : inputs)
    function == F::kSampleSphere ? calls.add(in.u) : calls.add(in.u, in.n);
  return calls;
}

Finding directionsAreValid(CheckRun& run, F function, std::vector<DirectionInput> inputs) {
  const std::size_t count = inputs.size();
  for (std::size_t i = count; i-- > 0;) inputs.push_back(inputs[i]);
  const Results results = directionCalls(function, inputs).run(run.worker);
  const bool hemisphere = function == F::kSampleHemisphere;
  Exact exact;
  exact.count(results.count());
  for (std::size_t i = 0; i < count; ++i) {
    const DirectionInput& in = inputs[i];
    const auto where = [&] {
      const std::string u = fmt::format("u = ({:.8g}, {:.8g})", in.u.x, in.u.y);
      return hemisphere ? fmt::format("n = {}, {}", text(in.n), u) : u;
    };
    const Vector w = results.vector(i, 0), again = results.vector(2 * count - 1 - i, 0);
    if (!exact.holds(
            results.finite(i), "finite numbers", [&] { return "direction " + text(w); }, where))
      break;
    // A mirrored direction adds the rounding of the normal's length to its own.
    exact.value("length of the direction", glm::length(glm::dvec3(w)), 1.0, 16.0 * kRoundoff,
                where);
    if (hemisphere)
      exact.holds(
          glm::dot(glm::dvec3(w), glm::dvec3(in.n)) > -8.0 * kRoundoff,
          "a direction above the surface, on the side of n",
          [&] {
            return fmt::format("direction {}, its cosine to n is {:.6g}", text(w),
                               glm::dot(glm::dvec3(w), glm::dvec3(in.n)));
          },
          where);
    exact.holds(
        results.same(i, 2 * count - 1 - i),
        "the same direction again for the same u, without random numbers of its own",
        [&] { return fmt::format("{} and then {}", text(w), text(again)); }, where);
  }
  return exact.finding();
}

std::vector<DirectionInput> directionInputs(std::uint64_t seed,
                                            const std::vector<Vector>& normals) {
  std::vector<DirectionInput> inputs;
  Random random(seed);
  for (const Vector& n : normals) {
    for (const float x : kEdgeNumbers)
      for (const float y : kEdgeNumbers) inputs.push_back({{x, y}, n});
    for (int k = 0; k < 48; ++k) {
      const float x = random.uniform();
      inputs.push_back({{x, random.uniform()}, n});
    }
  }
  return inputs;
}

Finding sphereIsValid(CheckRun& run) {
  return directionsAreValid(run, F::kSampleSphere,
                            directionInputs(run.seed, std::vector<Vector>(4, Vector(0, 0, 1))));
}

Finding hemisphereIsValid(CheckRun& run) {
  return directionsAreValid(run, F::kSampleHemisphere,
                            directionInputs(run.seed, awkwardNormals(run.seed)));
}

// Directions as the coursework would draw them with a mistake; z up.
glm::dvec3 sphereDirection(double z, double azimuth) {
  const double radius = std::sqrt(std::max(1.0 - z * z, 0.0));
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

using Mapping = std::function<glm::dvec3(double u0, double u1)>;

struct SuspectedMapping {
  const char* mistake;
  Mapping mapping;
};

constexpr std::string_view kWeight = "mean weight q/pdf";

// The suspicions cost more than the judgement, and are only asked for where it is a fail: then the
// same samples are judged once more.
Finding judgeUniform(CheckRun& run, F function, const Vector& axis, const AxialDensity& q,
                     const std::string& where, const std::vector<SuspectedMapping>& mistakes) {
  // A map that tears the square apart, as w to -w below the surface, needs more than a smooth one.
  constexpr std::uint32_t kPoints = 128;
  const double density = q.density(1.0);
  const auto draw = [&](const std::vector<DirectionDraw>& draws) {
    std::vector<DirectionInput> inputs;
    inputs.reserve(draws.size());
    for (const DirectionDraw& d : draws) inputs.push_back({d.st, axis});
    const Results results = directionCalls(function, inputs).run(run.worker);
    std::vector<DrawnDirection> drawn;
    drawn.reserve(draws.size());
    for (std::size_t i = 0; i < draws.size(); ++i) drawn.push_back({results.vector(i, 0), density});
    return drawn;
  };
  const Finding finding = judgeOwnDensity(run, axis, q, draw, where, kPoints);
  if (finding.status != Status::kFail) return finding;
  std::vector<Suspicion> suspicions;
  for (const SuspectedMapping& m : mistakes)
    suspicions.push_back({m.mistake, momentsOf(axis, q, [&](const DirectionDraw& d) {
                            return DrawnDirection{Vector(m.mapping(d.st.x, d.st.y)), density};
                          })});
  stats::ErrorBudget same;
  CheckRun again{run.worker, run.seed, same};
  Finding failed = judgeOwnDensity(again, axis, q, draw, where, kPoints, suspicions);
  // There is no density to weight with: what is lost lies where it should not.
  for (std::string* words : {&failed.expected, &failed.got})
    if (const std::size_t at = words->find(kWeight); at != std::string::npos)
      words->replace(at, kWeight.size(), "share of the directions that lie above the surface");
  return failed;
}

Finding sphereIsUniform(CheckRun& run) {
  const std::vector<SuspectedMapping> mistakes{
      {"the polar angle is uniform (theta = pi u) instead of the height z: directions crowd at the "
       "poles",
       [](double u0, double u1) { return sphereDirection(std::cos(kPiD * u1), 2.0 * kPiD * u0); }},
      {"the polar angle is uniform (theta = pi u) instead of the height z: directions crowd at the "
       "poles",
       [](double u0, double u1) { return sphereDirection(std::cos(kPiD * u0), 2.0 * kPiD * u1); }},
      {"the azimuth runs over half a turn: 2 pi u, not pi u",
       [](double u0, double u1) { return sphereDirection(2.0 * u1 - 1.0, kPiD * u0); }},
      {"the height z runs from 0 to 1: 2 u - 1, not u",
       [](double u0, double u1) { return sphereDirection(u1, 2.0 * kPiD * u0); }},
      {"one number is used for both the height and the azimuth",
       [](double u0, double) { return sphereDirection(2.0 * u0 - 1.0, 2.0 * kPiD * u0); }},
      {"one number is used for both the height and the azimuth",
       [](double, double u1) { return sphereDirection(2.0 * u1 - 1.0, 2.0 * kPiD * u1); }},
  };
  Finding finding;
  std::uint64_t calls = 0;
  for (const Vector& axis : {Vector(0, 0, 1), Vector(glm::normalize(glm::dvec3(1, 2, -3)))}) {
    CheckRun own{run.worker, run.seed + calls, run.budget};
    finding =
        judgeUniform(own, F::kSampleSphere, axis, kSphereDensity,
                     fmt::format("angles theta counted from the axis {}", text(axis)), mistakes);
    calls += finding.calls;
    if (!finding.passed()) break;
  }
  finding.calls = calls;
  return finding;
}

Finding hemisphereIsUniform(CheckRun& run) {
  Finding finding;
  std::uint64_t calls = 0;
  for (const Vector& n : awkwardNormals(run.seed)) {
    const glm::dvec3 axis(n);
    const auto uniform = [](double u0, double u1) {
      return sphereDirection(2.0 * u1 - 1.0, 2.0 * kPiD * u0);
    };
    const std::vector<SuspectedMapping> mistakes{
        {"w - (n . w) n lays what is below into the surface; the mirror takes away twice as much",
         [=](double u0, double u1) {
           const glm::dvec3 w = uniform(u0, u1);
           const double height = glm::dot(w, axis);
           return height < 0.0 ? glm::normalize(w - height * axis) : w;
         }},
        {"directions are mirrored in the plane z = 0, whatever the normal is",
         [=](double u0, double u1) {
           const glm::dvec3 w = uniform(u0, u1);
           return glm::dvec3(w.x, w.y, std::abs(w.z));
         }},
        {"directions below the surface are not mirrored", uniform},
        {"the test is the wrong way round: what lies above the surface is mirrored to below it",
         [=](double u0, double u1) {
           const glm::dvec3 w = uniform(u0, u1);
           return w - 2.0 * std::max(glm::dot(w, axis), 0.0) * axis;
         }},
        {"the directions have the density of the cosine, not the uniform one",
         [=](double u0, double u1) {
           return DoubleFrame(axis).direction(std::sqrt(u1), 2.0 * kPiD * u0);
         }},
    };
    CheckRun own{run.worker, run.seed + calls, run.budget};
    finding = judgeUniform(own, F::kSampleHemisphere, n, kHemisphereDensity,
                           fmt::format("n = {}", text(n)), mistakes);
    calls += finding.calls;
    if (!finding.passed()) break;
  }
  finding.calls = calls;
  return finding;
}

}  // namespace

std::vector<Check> part0SamplingChecks() {
  return {
      {"seed", F::kGetRandomNumbers, "the new seed is the PCG2D hash of the old one, bit by bit",
       0.0, seedIsHashed},
      {"numbers", F::kGetRandomNumbers,
       "the two numbers are the new seed divided by 2^32, to six digits, and never 1", 0.0,
       numbersAreTheHighBits},
      {"uniform", F::kSampleSphere, "the directions are uniform on the sphere", 0.01,
       sphereIsUniform},
      {"valid", F::kSampleSphere,
       "for all u, also at the ends, the direction is a unit vector, and the same again for the "
       "same u",
       0.0, sphereIsValid},
      {"uniform",
       F::kSampleHemisphere,
       "the directions are uniform on the hemisphere around the normal",
       0.01,
       hemisphereIsUniform,
       {F::kSampleSphere}},
      {"valid",
       F::kSampleHemisphere,
       "for all u, also at the ends, the direction is a unit vector on the side of the normal, and "
       "the same again for the same u",
       0.0,
       hemisphereIsValid,
       {F::kSampleSphere}},
  };
}

}  // namespace pathmark::checks
