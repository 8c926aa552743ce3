// One bounce and the whole path of part 0, in meshes like those of
// checks/part0_radiance_checks.cpp.
#include "checks/channels.h"
#include "checks/pcg2d.h"
#include "checks/points.h"
#include "checks/radiance_checks.h"
#include "diagnosis/warmup_probes.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>

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
    if (!results.finite(i))
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

}  // namespace

Signature probeBounce(const ProbeRun& run) {
  Random random(6);
  Signature signature;
  for (const double size : {1.0, 1e-3}) {
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
  return signature;
}

Signature probeWarmUpPath(const ProbeRun& run) {
  Random random(7);
  Signature signature;
  const EvenRoom room(random, 0.5);
  const Point inside = room.inside(random);
  const Vector direction = random.direction();
  addMeans(
      run, room.mesh.words(), "in a room that emits evenly", EvenRoom::kEmission,
      [&](Calls& calls, uvec2 seed) { calls.add(inside, direction, seed); }, signature);
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
  return signature;
}

}  // namespace pathmark::diagnosis
