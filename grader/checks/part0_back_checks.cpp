// What is asked of the whole path where it hits triangles from behind.
#include "checks/part0_checks.h"
#include "checks/radiance_checks.h"
#include "checks/shells.h"

#include <pathmark/warmup.h>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr const char* kEndsAtBack = "the path ends where it hits a triangle from behind";
constexpr const char* kOneSided =
    "light is emitted only on the side of the normal; in this part emission is two-sided";
constexpr const char* kTurned =
    "the normal is turned to the side from which the ray comes; n is the triangle's own, so that "
    "after a hit from behind the path goes on through the triangle";
constexpr const char* kEndsAtBlack =
    "the path ends where a single channel of the throughput is 0, though the others go on";
constexpr const char* kEndsAtUnlit = "the path ends at a triangle that emits nothing";

struct ShellQuestion {
  const Shells& scene;
  std::string where;
};

Finding judgeShells(CheckRun& run, Random& random, const ShellQuestion& question,
                    const glm::dvec3& expected, const std::vector<SuspectedRadiance>& suspects) {
  Ray ray;
  const AddCall add = [&](Calls& calls, std::uint32_t m, uvec2 seed) {
    if (m == 0) ray = {question.scene.room.inside(random), random.direction()};
    calls.add(ray, seed);
  };
  return judgeRadiance(run,
                       {F::kGetRayRadiance, question.scene.mesh.words(), add, question.where, 1024},
                       expected, suspects);
}

// All emit and reflect alike, so that every hit counts the same from wherever it comes.
Finding throughBackIntoEvenRoom(CheckRun& run) {
  Random random(run.seed);
  const glm::dvec3 colour(EvenRoom::kColour), emission(EvenRoom::kEmission);
  const std::vector<Shell> alike(2, Shell{colour, emission});
  const glm::dvec3 expected =
      throughShells(std::vector<Shell>(MAX_PATH_LENGTH, alike.front()), MAX_PATH_LENGTH);
  return judgeShells(run, random,
                     {Shells(random, alike, true),
                      "rays that leave a closed tetrahedron, hit from behind, for one around it, "
                      "hit from the front"},
                     expected, {{kEndsAtBack, emission}, {kOneSided, expected - emission}});
}

Finding throughFaintShells(CheckRun& run) {
  Random random(run.seed);
  const std::vector<Shell> shells = faintShells();
  const std::vector<Shell> innermost(MAX_PATH_LENGTH, shells.front());
  const auto after = [&](std::size_t hits) { return throughShells(shells, hits); };
  return judgeShells(
      run, random,
      {Shells(random, shells),
       "a ray inside of six closed tetrahedra, each inside of the next, all hit from "
       "behind"},
      after(MAX_PATH_LENGTH),
      {{kTurned, throughShells(innermost, MAX_PATH_LENGTH)},
       {kOneSided, glm::dvec3(0.0)},
       {kOneSided, after(1)}});
}

Finding throughBlackShells(CheckRun& run) {
  Random random(run.seed);
  const std::vector<Shell> shells = blackShells();
  const auto after = [&](std::size_t hits) { return throughShells(shells, hits); };
  return judgeShells(
      run, random,
      {Shells(random, shells),
       "a ray inside of six closed tetrahedra, each inside of the next, of which the "
       "first reflects no blue, the second no red, and the fourth emits nothing"},
      after(MAX_PATH_LENGTH),
      {{kEndsAtBlack, after(1)}, {kEndsAtBlack, after(2)}, {kEndsAtUnlit, after(3)}});
}

Finding backsAreGoneThrough(CheckRun& run) {
  return judgeAll(run, {throughBackIntoEvenRoom, throughFaintShells, throughBlackShells});
}

}  // namespace

std::vector<Check> part0BackChecks() {
  return {{"backs",
           F::kGetRayRadiance,
           "a path goes on through what it hits from behind, and ends nowhere before it meets "
           "nothing or has MAX_PATH_LENGTH hits",
           0.005,
           backsAreGoneThrough,
           {F::kRayTriangleIntersection, F::kRayMeshIntersection, F::kGetRandomNumbers,
            F::kSampleSphere, F::kSampleHemisphere}}};
}

}  // namespace pathmark::checks
