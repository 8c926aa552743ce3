// One bounce and the whole path of part 0, in meshes like those of
// checks/part0_radiance_checks.cpp.
#include "checks/channels.h"
#include "checks/pcg2d.h"
#include "checks/points.h"
#include "checks/radiance_checks.h"
#include "checks/shells.h"
#include "diagnosis/warmup_probes.h"

#include <pathmark/warmup.h>

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;

constexpr std::uint32_t kReplicates = 64, kSeeds = 1024;

std::uint32_t wordOf(float u, Random& random) {
  return (static_cast<std::uint32_t>(u * 0x1p24f) << 8) | (random.bits() >> 24);
}

// `add` adds a call with this seed. Radiances are taken over `scale`.
void addMeans(const ProbeRun& run, const Words& mesh, const std::string& where, const Colour& scale,
              const std::function<void(Calls&, uvec2)>& add, Signature& signature) {
  Random random(run.seed);
  Calls calls(run.function, mesh);
  // The first two numbers of the seeds are evenly spread: the hash is turned back.
  Points points(run.seed, kSeeds);
  for (std::uint32_t r = 0; r < kReplicates; ++r) {
    points.start(r);
    for (std::uint32_t m = 0; m < kSeeds; ++m) {
      points.point(m);
      const vec2 u = points.pair();
      const std::uint32_t x = wordOf(u.x, random);
      add(calls, seedOf({x, wordOf(u.y, random)}));
    }
  }
  const Results results = calls.run(run.worker);
  Replicates means(kReplicates, 5);
  for (std::size_t i = 0; i < results.count(); ++i) {
    const std::span<double> of = means.of(static_cast<std::uint32_t>(i / kSeeds));
    const vec3 radiance = results.vector(i, 0);
    // The seed follows, whose bits may look like no number.
    if (!std::isfinite(radiance.x + radiance.y + radiance.z))
      of[4] += 1.0;
    else
      for (std::size_t c = 0; c < 3; ++c)
        of[c] += double{radiance[static_cast<int>(c)]} / double{scale[static_cast<int>(c)]};
  }
  means.divideBy(kSeeds);
  const std::string what = scale == Colour(1.0f) ? "mean radiance" : "mean radiance over emission";
  for (int c = 0; c < 3; ++c)
    means.add(signature, fmt::format("{}, {}", inChannel(what, c), where),
              static_cast<std::size_t>(c));
  means.add(signature, "share of values that are no numbers, " + where, 4);
}

// A plate at this height over the origin.
Plate plateAt(double height, bool up, const glm::dvec3& colour, const glm::dvec3& emission) {
  Plate plate{{-1, height, -1}, {2, 0, 0}, {0, 0, 2}, {0, up ? 1.0 : -1.0, 0}};
  plate.colour = colour;
  plate.emission = emission;
  return plate;
}

MeshWords twoPlates(const glm::dvec3& emission) {
  MeshWords mesh;
  mesh.plate(plateAt(0.0, true, {0.6, 0.4, 0.3}, emission));
  mesh.plate(plateAt(0.5, false, {0.4, 0.7, 0.9}, {0.9, 0.25, 0.8}));
  return mesh;
}

void addShells(const ProbeRun& run, const std::vector<Shell>& shells, bool outermostInwards,
               const std::string& where, Signature& signature) {
  Random random(8);
  const Shells scene(random, shells, outermostInwards);
  const Point inside = scene.room.inside(random);
  const Vector direction = random.direction();
  addMeans(
      run, scene.mesh.words(), where, Colour(1.0f),
      [&](Calls& calls, uvec2 seed) { calls.add(inside, direction, seed); }, signature);
}

// A call that begins at this place of the triangle number 0, or a path that hits it first.
void addCallAt(const ProbeRun& run, const glm::dvec3& x, const glm::dvec3& n, uvec2 seed,
               Calls& calls) {
  if (run.function == CourseworkFunction::kGetRayRadiance)
    calls.add(Point(x + 0.1 * n), Vector(-n), seed);
  else
    calls.add(Point(x), 0, seed);
}

// A right path may draw numbers at its last hit or not.
void addSeeds(const ProbeRun& run, int fewest, Signature& signature) {
  constexpr int kMost = 4 * MAX_PATH_LENGTH, kCalls = 40;
  Random random(9);
  const EvenRoom room(random, 1.0);
  Calls calls(run.function, room.mesh.words());
  std::vector<uvec2> seeds;
  for (int k = 0; k < kCalls; ++k) {
    const std::uint32_t x = random.bits();
    seeds.emplace_back(x, random.bits());
    addCallAt(run, glm::dvec3(room.pointOn(0)), room.normal(0), seeds.back(), calls);
  }
  const Results results = calls.run(run.worker);
  bool changed = true, made = true;
  int enough = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const uvec2 next(results.word(i, 3), results.word(i, 4));
    const int hashes = hashesBetween(seeds[i], next, kMost);
    changed = changed && next != seeds[i];
    made = made && hashes != kNoHashes;
    enough += hashes >= fewest ? 1 : 0;
  }
  signature.addAnswer("whether the seed is another after a call", changed);
  signature.addAnswer("whether that seed is made by get_random_numbers", made);
  signature.addAnswer(
      fmt::format("whether that seed is made by {} calls of get_random_numbers or more", fewest),
      2 * enough > kCalls);
}

// Far enough from the origin for its points to be rounded to either side of it.
void addLoneTriangle(const ProbeRun& run, Signature& signature) {
  Random random(10);
  const DoubleFrame frame{glm::dvec3(random.direction())};
  const glm::dvec3 a = 30.0 * frame.u + 21.0 * frame.n - 27.0 * frame.v;
  MeshWords mesh;
  mesh.triangle(a, a + 2.0 * frame.u, a + 2.0 * frame.v, frame.n, Colour(0.8f), Colour(1.0f));
  Calls calls(run.function, mesh.words());
  for (int k = 0; k < 200; ++k) {
    const glm::dvec3 x =
        a + random.between(0.2, 0.9) * frame.u + random.between(0.2, 0.9) * frame.v;
    const std::uint32_t word = random.bits();
    addCallAt(run, x, frame.n, uvec2(word, random.bits()), calls);
  }
  const Results results = calls.run(run.worker);
  bool again = false;
  for (std::size_t i = 0; i < results.count(); ++i)
    again = again || results.vector(i, 0).x > 1.0001f;
  signature.addAnswer("whether a ray that leaves a triangle ever meets the same one", again);
}

}  // namespace

Signature probeBounce(const ProbeRun& run) {
  Random random(6);
  Signature signature;
  for (const double size : {1.0, 3e-6}) {
    const EvenRoom room(random, size);
    addMeans(
        run, room.mesh.words(), fmt::format("in a room of size {} that emits evenly", size),
        EvenRoom::kEmission, [&](Calls& calls, uvec2 seed) { calls.add(room.pointOn(1), 1, seed); },
        signature);
  }
  for (const double own : {0.0, 0.7})
    addMeans(
        run, twoPlates(glm::dvec3(own)).words(),
        fmt::format("on a plate of emission {} under another one", own), Colour(1.0f),
        [](Calls& calls, uvec2 seed) { calls.add(Point(0.1f, 0.0f, -0.2f), 0, seed); }, signature);
  MeshWords behind;
  behind.plate(plateAt(0.0, true, {0.6, 0.4, 0.3}, {0.0, 0.0, 0.0}));
  behind.plate(plateAt(0.5, true, {0.4, 0.7, 0.9}, {0.9, 0.25, 0.8}));
  addMeans(
      run, behind.words(), "under the back of a plate that emits", Colour(1.0f),
      [](Calls& calls, uvec2 seed) { calls.add(Point(0.1f, 0.0f, -0.2f), 0, seed); }, signature);
  addSeeds(run, 1, signature);
  addLoneTriangle(run, signature);
  return signature;
}

Signature probeWarmUpPath(const ProbeRun& run) {
  Random random(7);
  Signature signature;
  for (const double size : {100.0, 3e-6}) {
    const EvenRoom room(random, size);
    const Point inside = room.inside(random);
    const Vector direction = random.direction();
    addMeans(
        run, room.mesh.words(), fmt::format("in a room of size {} that emits evenly", size),
        EvenRoom::kEmission, [&](Calls& calls, uvec2 seed) { calls.add(inside, direction, seed); },
        signature);
  }
  for (const double own : {0.0, 0.7})
    addMeans(
        run, twoPlates(glm::dvec3(own)).words(),
        fmt::format("from a plate of emission {} under another one", own), Colour(1.0f),
        [](Calls& calls, uvec2 seed) {
          calls.add(Point(0.1f, 0.3f, -0.2f), Vector(0, -1, 0), seed);
        },
        signature);
  addMeans(
      run, twoPlates(glm::dvec3(1.0)).words(), "where a ray meets nothing", Colour(1.0f),
      [](Calls& calls, uvec2 seed) { calls.add(Point(0.1f, 0.3f, -0.2f), Vector(1, 0, 0), seed); },
      signature);
  addShells(run, faintShells(), false, "out of shells that emit more and more", signature);
  addShells(run, blackShells(), false, "out of shells that do not reflect all colours", signature);
  const Shell alike{glm::dvec3(EvenRoom::kColour), glm::dvec3(EvenRoom::kEmission)};
  addShells(run, {alike, alike}, true, "out of a shell into a room of the same kind", signature);
  addSeeds(run, MAX_PATH_LENGTH - 1, signature);
  addLoneTriangle(run, signature);
  MeshWords bright;
  bright.plate(plateAt(0.0, true, glm::dvec3(0.0), glm::dvec3(2000.0)));
  Calls calls(run.function, bright.words());
  calls.add(Point(0.1f, 0.3f, -0.2f), Vector(0, -1, 0), uvec2(1, 2));
  signature.add("radiance (red) from a light of emission 2000",
                calls.run(run.worker).vector(0, 0).x, 0.0, 2000.0);
  return signature;
}

}  // namespace pathmark::diagnosis
