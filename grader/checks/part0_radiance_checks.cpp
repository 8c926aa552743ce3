// What is asked of part 0: one bounce, and the whole path. Their means: part0_mean_checks.cpp.
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/part0_checks.h"
#include "checks/part0_radiance.h"
#include "checks/pcg2d.h"
#include "checks/radiance_checks.h"

#include <pathmark/warmup.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

bool sameRadiance(const Results& results, std::size_t a, std::size_t b) {
  return results.word(a, 0) == results.word(b, 0) && results.word(a, 1) == results.word(b, 1) &&
         results.word(a, 2) == results.word(b, 2);
}

// Finite, at least 0, the same for the same seed, in any order; and the seed moves on by calls of
// get_random_numbers.
Finding radianceIsValid(CheckRun& run, F function) {
  constexpr std::size_t kSeeds = 200;
  // More than one at a hit are a waste, but no harm.
  constexpr int kMostCalls = 4 * MAX_PATH_LENGTH;
  Random random(run.seed);
  const EvenRoom room(random, 1.0);
  std::vector<uvec2> seeds{{0, 0}};
  while (seeds.size() < kSeeds) seeds.emplace_back(random.bits(), random.bits());
  Calls calls(function, room.mesh.words());
  // Towards the inside of a face, so that the path has a hit.
  const Ray ray{Point(0.0f), glm::normalize(room.pointOn(0))};
  for (std::size_t i = 0; i < 2 * kSeeds; ++i) {
    const uvec2 seed = seeds[i < kSeeds ? i : 2 * kSeeds - 1 - i];
    if (function == F::kGetRayRadiance)
      calls.add(ray, seed);
    else
      calls.add(room.pointOn(0), 0, seed);
  }
  const Results results = calls.run(run.worker);
  const bool isPath = function == F::kGetRayRadiance;
  Exact exact;
  exact.count(results.count());
  std::size_t shortPaths = 0;
  bool alike = true;  // all radiances
  for (std::size_t i = 0; i < kSeeds; ++i) alike = alike && sameRadiance(results, 0, i);
  for (std::size_t i = 0; i < kSeeds; ++i) {
    const uvec2 s = seeds[i], next(results.word(i, 3), results.word(i, 4));
    const auto where = [&] {
      return fmt::format("{}, seed ({:#x}, {:#x})", room.where(), s.x, s.y);
    };
    const vec3 l = results.vector(i, 0), again = results.vector(2 * kSeeds - 1 - i, 0);
    exact.holds(
        std::isfinite(l.x + l.y + l.z) && std::min({l.x, l.y, l.z}) >= 0.0f,
        "finite numbers, at least 0", [&] { return "radiance " + text(l); }, where);
    exact.holds(
        next != s, "another seed after the call than before it",
        [&] {
          return alike ? "the same seed, and the same radiance with every seed: no random number "
                         "is drawn"
                       : "the same seed: `seed` is a reference, so that the next path gets other "
                         "numbers";
        },
        where);
    const int drawn = hashesBetween(s, next, kMostCalls);
    exact.holds(
        drawn != kNoHashes, "a seed that get_random_numbers(seed) has made from the one before",
        [] {
          return "another seed: what follows then gets numbers that have been used already, or "
                 "those of another sequence";
        },
        where);
    if (isPath && drawn != kNoHashes && drawn < MAX_PATH_LENGTH - 1) ++shortPaths;
    exact.holds(
        results.same(i, 2 * kSeeds - 1 - i), "the same radiance again for the same seed",
        [&] { return fmt::format("{} and then {}", text(l), text(again)); }, where);
  }
  // A path may leave the room at an edge, but not many do; nothing need be drawn at the last hit.
  exact.holds(
      2 * shortPaths < kSeeds,
      fmt::format("get_random_numbers(seed) is called at each of the {} hits of a path, "
                  "or at all of them but the last",
                  MAX_PATH_LENGTH),
      [&] {
        return fmt::format(
            "after {} of {} paths the seed has seen fewer calls; are there fewer "
            "hits, or is a copy of it used?",
            shortPaths, kSeeds);
      },
      [&] { return room.where() + ", in which every path has all its hits"; });
  return exact.finding();
}

Finding directIsValid(CheckRun& run) { return radianceIsValid(run, F::kComputeDirectIllumination); }
Finding pathIsValid(CheckRun& run) { return radianceIsValid(run, F::kGetRayRadiance); }

constexpr const char* kMeetsItself =
    "rays meet the triangle that they leave: spawn_ray moves their origin off it by more than the "
    "rounding error of the point";

// Where nothing is left to chance: what is hit reflects nothing, or nothing is hit.
Finding endsAreExact(CheckRun& run) {
  Random random(run.seed);
  const Setting setting(random, 1.0);
  const auto wall = [&](double height, const glm::dvec3& emission, bool normalUp) {
    Plate p = setting.plate(setting.at(-1, height, -1), setting.at(2, 0, 0), setting.at(0, 0, 2),
                            normalUp);
    p.emission = emission;
    return p;
  };
  MeshWords mesh;
  mesh.plate(wall(1.0, {3, 2, 1}, true));
  mesh.plate(wall(-1.0, {0.5, 0.25, 4}, true));
  mesh.plate(wall(2.0, {7, 2000, 50}, false));
  struct Input {
    Ray ray;
    Colour expected;
    bool fromFront;
    const char* where;
  };
  const Vector up(setting.up());
  const Vector aside(glm::normalize(setting.at(1, 0, 0.5)));
  const Point between(setting.at(0.3, 0, 0.2)), above(setting.at(0.3, 5, 0.2)),
      below(setting.at(0.3, -3, 0.2));
  const std::vector<Input> inputs{
      {{between, -up},
       {0.5f, 0.25f, 4},
       true,
       "a light of colour 0 is hit from the side of its normal, and the path leaves the scene"},
      {{between, up},
       {3, 2, 1},
       false,
       "a light of colour 0 is hit from behind: emission is two-sided"},
      {{above, -up},
       {7, 2000, 50},
       false,
       "the nearest of three lights of colour 0 is hit from behind"},
      {{below, up},
       {0.5f, 0.25f, 4},
       false,
       "the nearest of three lights of colour 0 is hit from behind"},
      {{between, aside}, Colour(0.0f), false, "nothing is hit"}};
  Calls calls(F::kGetRayRadiance, mesh.words());
  for (const Input& in : inputs) {
    const std::uint32_t x = random.bits();
    calls.add(in.ray, uvec2(x, random.bits()));
  }
  const Results results = calls.run(run.worker);
  Exact exact{kOneSided};
  exact.count(results.count());
  bool limited = true;  // wherever it is wrong, to this:
  double limit = 0.0;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double expected = inputs[i].expected[c];
      const double got = results.vector(i, 0)[c];
      const bool right = exact.value(
          inChannel("radiance", c), got, expected, relativeTolerance() * std::max(expected, 1.0),
          [&] { return inputs[i].where; }, {inputs[i].fromFront ? expected : 0.0});
      if (right) continue;
      limited = limited && got > 0.0 && got < expected && (limit == 0.0 || got == limit);
      limit = got;
    }
  Finding finding = exact.finding();
  if (!finding.passed() && limited)
    finding.cause =
        fmt::format("radiance is limited to {:.4g}; it may be as large as it comes", limit);
  return finding;
}

// A triangle that sees nothing but the dark, far enough from the origin for its points to be
// rounded to either side of it.
Finding aloneItOnlyEmits(CheckRun& run, F function) {
  Random random(run.seed);
  const Setting setting(random, 1.0);
  const Colour emission(0.5f, 2.0f, 0.0f);
  const glm::dvec3 a = setting.at(30, 21, -27), e1 = setting.at(2, 0, 0), e2 = setting.at(0, 0, 2);
  const glm::dvec3 up = setting.up();
  MeshWords mesh;
  mesh.triangle(a, a + e1, a + e2, up, Colour(0.8f), emission);
  Calls calls(function, mesh.words());
  for (int k = 0; k < 200; ++k) {
    const glm::dvec3 x = a + random.between(0.1, 0.45) * e1 + random.between(0.1, 0.45) * e2;
    const std::uint32_t word = random.bits();
    const uvec2 seed(word, random.bits());
    if (function == F::kComputeDirectIllumination) {
      calls.add(Point(x), 0, seed);
      continue;
    }
    const Vector d = random.direction();
    calls.add(Point(x - random.between(1.0, 3.0) * glm::dvec3(d)), d, seed);
  }
  const Results results = calls.run(run.worker);
  Exact exact{"what the point itself emits is left out"};
  exact.count(results.count());
  const auto where = [&] {
    return fmt::format("a single triangle of emission {}: no ray that leaves it meets anything",
                       text(emission));
  };
  bool meetsItself = true;  // wherever it is wrong
  for (std::size_t i = 0; i < results.count(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double got = results.vector(i, 0)[c], expected = double{emission[c]};
      const bool right = exact.value(inChannel("radiance", c), got, expected,
                                     relativeTolerance() * 2.0, where, {0.0});
      if (!right && !(got > expected)) meetsItself = false;
    }
  Finding finding = exact.finding();
  if (!finding.passed() && meetsItself) finding.cause = kMeetsItself;
  return finding;
}

Finding pointAlone(CheckRun& run) { return aloneItOnlyEmits(run, F::kComputeDirectIllumination); }
Finding triangleAlone(CheckRun& run) { return aloneItOnlyEmits(run, F::kGetRayRadiance); }

}  // namespace

std::vector<Check> part0RadianceChecks() {
  const std::vector<F> needs{F::kRayTriangleIntersection, F::kRayMeshIntersection,
                             F::kGetRandomNumbers, F::kSampleSphere, F::kSampleHemisphere};
  return {
      {"valid", F::kComputeDirectIllumination,
       "the radiance is finite, at least 0 and the same again for the same seed, and the seed "
       "moves on by get_random_numbers",
       0.0, directIsValid, needs},
      {"alone", F::kComputeDirectIllumination,
       "a point that sees nothing sends out exactly what it emits", 0.0, pointAlone, needs},
      {"even-room", F::kComputeDirectIllumination,
       "in a closed room in which all surfaces are alike the mean radiance is Le (1 + a)", 0.005,
       oneBounceInEvenRoom, needs},
      {"light", F::kComputeDirectIllumination,
       "under a light that is partly hidden the mean radiance is Le(x) + a/pi E, E the irradiance",
       0.005, oneBounceFromLight, needs},
      {"valid", F::kGetRayRadiance,
       "the radiance is finite, at least 0 and the same again for the same seed, and the seed "
       "moves on by get_random_numbers",
       0.0, pathIsValid, needs},
      {"alone", F::kGetRayRadiance,
       "a path that meets a triangle alone sees exactly what it emits, and never meets it again",
       0.0, triangleAlone, needs},
      {"even-room", F::kGetRayRadiance,
       "in a closed room in which all surfaces are alike the mean radiance is Le (1 + a + a^2 + "
       "...), with a term for each of MAX_PATH_LENGTH hits",
       0.005, pathInEvenRooms, needs},
      {"plates", F::kGetRayRadiance,
       "between two unequal plates the mean radiance is that of all paths to and fro", 0.005,
       pathBetweenPlates, needs},
      {"ends", F::kGetRayRadiance,
       "a ray that meets nothing sees black, and one that meets a light without colour sees "
       "exactly what the light emits",
       0.0, endsAreExact, needs},
  };
}

}  // namespace pathmark::checks
