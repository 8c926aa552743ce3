// Direct light in rooms whose radiance is known: see checks/part2_direct_checks.cpp.
#include "checks/calls.h"
#include "checks/channels.h"
#include "checks/plain_light.h"
#include "checks/random_rooms.h"
#include "diagnosis/light_probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;

struct Room {
  std::string name;
  LitRoom room;
};

std::vector<Room> rooms() {
  Random random(26);
  const LitRoom plain{{plainLight(LightShape::kParallelogram)}, {}, kBelowPlainLight};
  std::vector<Room> all{
      {"under a rectangle", plain},
      {"under a triangle", {{plainLight(LightShape::kTriangle)}, {}, kBelowPlainLight}},
      {"under a polygon", {{plainLight(LightShape::kPolygon)}, {}, kBelowPlainLight}},
      {"under a sphere", {{plainLight(LightShape::kSphere)}, {}, kBelowPlainLight}}};
  LitRoom room = plain;
  room.receiver.lopsided = true;
  all.push_back({"under a rectangle, with a BRDF that depends on both directions", room});
  for (const double size : {0.01, 30.0}) {
    const RoomLight light = makeLight(random, LightShape::kParallelogram, size);
    all.push_back({fmt::format("from a slanted light of size {}", size),
                   {{light}, {}, place(random, light, Placement::kWhollyLit)}});
  }
  for (const int count : {2, 3, 5}) {
    LitRoom several{{}, {}, kBelowPlainLight};
    for (int k = 0; k < count; ++k)
      several.lights.push_back(
          lightAround(random, several.receiver, LightShape::kParallelogram, k, count));
    all.push_back({fmt::format("from {} lights", count), several});
  }
  // A screen half way hides all that is to the right of p0 + 0.5 (p1 - p0).
  room = plain;
  const auto half = [&](double x, double z) {
    return Point(glm::mix(glm::dvec3(kBelowPlainLight.p), glm::dvec3(x, 2.0, z), 0.5));
  };
  room.lights[0].open = 0.5;
  room.screens.push_back({half(0.0, -1.4), half(1.6, -1.4), half(1.6, 0.9), half(0.0, 0.9)});
  all.push_back({"under a rectangle that is half hidden", room});
  return all;
}

// Of which the radiance is compared with that under the plain light.
std::vector<Room> unusualRooms() {
  const RoomLight shines = plainLight(LightShape::kParallelogram);
  const LitRoom lit{{shines}, {}, kBelowPlainLight};
  std::vector<Room> all;
  LitRoom room = lit;
  room.receiver.emission = Colour(0.25f, 0.5f, 0.75f);
  all.push_back({"on a surface that emits", room});
  room = lit;
  room.lights[0].emission.x = 0.0f;
  all.push_back({"from a light without red", room});
  RoomLight below = shines;
  for (Point& v : below.vertices) v.y = -v.y;
  std::ranges::reverse(below.vertices);
  all.push_back({"beside a light below the horizon", {{below, shines}, {}, kBelowPlainLight}});
  room = {{{.centre = {1, 2, 3}, .radius = 2.0f, .inward = true, .emission = kPlainEmission}},
          {},
          {{3, 2, 3}, {-1, 0, 0}, {-0.8f, 0.6f, 0}}};
  room.receiver.onLight = true;
  all.push_back({"on the inside of a sphere that lights itself", room});
  return all;
}

std::vector<Room> darkRooms() {
  LitRoom lit{{plainLight(LightShape::kParallelogram)}, {}, kBelowPlainLight};
  std::vector<Room> all;
  LitRoom room = lit;
  room.receiver.n = {0, -1, 0};
  room.receiver.wo = {0.6f, -0.8f, 0};
  all.push_back({"from a light below the horizon", room});
  room.receiver.wo = {0.6f, 0.8f, 0};
  all.push_back({"towards the back of a surface that is lit from behind", room});
  room = lit;
  room.lights[0].frontOnly = true;
  room.receiver = {{0.3f, 4, 0.2f}, {0, -1, 0}, {0.6f, -0.8f, 0}};
  all.push_back({"from the back of a light", room});
  room = lit;
  room.lights[0] = plainLight(LightShape::kSphere);
  room.receiver = {{0.0f, 2.2f, 0.0f}, {0, 1, 0}, {0.6f, 0.8f, 0}};
  all.push_back({"inside a sphere that shines outwards", room});
  return all;
}

void addMean(const ProbeRun& run, const Room& r, const glm::dvec3& right, Signature& signature) {
  constexpr std::uint32_t kReplicates = 32, kRays = 512;
  const FlatScene flat = r.room.flat();
  run.worker.loadScene(flat);
  EstimateRequest request;
  request.function = static_cast<std::uint32_t>(CourseworkFunction::kDirectLighting);
  request.seed = run.seed;
  request.replicates = kReplicates;
  request.calls = 1;
  request.rays = kRays;
  const Receiver& x = r.room.receiver;
  const std::vector<Estimate> estimates = run.worker.estimate(
      request, Words().add(x.p, x.n, r.room.rounding(), flat.materials.size() - 1, x.wo).words());
  Replicates means(kReplicates, 5);
  for (std::uint32_t k = 0; k < kReplicates; ++k) {
    const std::span<double> of = means.of(k);
    for (int c = 0; c < 3; ++c) {
      of[static_cast<std::size_t>(c)] = estimates[k].mean[c] / right[c];
      of[3] += estimates[k].mean[c] / right[c] / 3.0;
    }
    of[4] = static_cast<double>(estimates[k].invalid) / kRays;
  }
  means.add(signature, "radiance over what it must be, " + r.name, 3);
  if (r.name == "under a rectangle")
    for (std::size_t c = 0; c < 3; ++c)
      means.add(signature,
                checks::inChannel("radiance over what it must be, " + r.name, static_cast<int>(c)),
                c);
  means.add(signature, "share of estimates that are no radiance, " + r.name, 4);
}

}  // namespace

Signature probeDirectLighting(const ProbeRun& run) {
  Signature signature;
  for (const Room& room : rooms())
    addMean(run, room, radianceBy(rightKernel, room.room), signature);
  const glm::dvec3 typical = glm::dvec3(kReceiverKd) * glm::dvec3(kPlainEmission);
  for (const Room& room : unusualRooms()) addMean(run, room, typical, signature);
  for (const Room& room : darkRooms()) addMean(run, room, typical, signature);
  return signature;
}

}  // namespace pathmark::diagnosis
