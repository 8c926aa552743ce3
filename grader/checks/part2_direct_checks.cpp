// What is asked of 2.6: direct light.
#include "checks/calls.h"
#include "checks/direct_cases.h"
#include "checks/exact.h"
#include "checks/irradiance.h"
#include "checks/part2_checks.h"
#include "checks/plain_light.h"
#include "checks/random_rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr double kPiD = std::numbers::pi;

// By closed forms that need no light to be wholly above the horizon, with the BRDF Kd/pi.
DirectCase diffuseCase(const LitRoom& room, double irradiance, std::uint32_t rays = 128) {
  const glm::dvec3 colour = glm::dvec3(kReceiverKd) * glm::dvec3(room.lights[0].emission);
  return {room, colour * (irradiance / kPiD), false, rays};
}

template <LightShape kShape>
Finding polygonLights(CheckRun& run) {
  // What chooses the triangle of a polygon is no smooth function of its point.
  constexpr std::uint32_t kRays = kShape == LightShape::kPolygon ? 256 : 128;
  LitRoom plain{{plainLight(kShape)}, {}, kBelowPlainLight};
  std::vector<DirectCase> cases{caseOf(plain, kRays)};
  plain.receiver.lopsided = true;
  cases.push_back(caseOf(plain, kRays));
  Random random(run.seed);
  for (const double size : {1.0, 3.0, 1.0, 1e-3, 1e4}) {
    const RoomLight light = makeLight(random, kShape, size);
    cases.push_back(caseOf({{light}, {}, place(random, light, Placement::kWhollyLit)}, kRays));
  }
  return judgeCases(run, cases);
}

Finding lightsAtTheHorizon(CheckRun& run) {
  std::vector<DirectCase> cases;
  Random random(run.seed);
  for (const double size : {1.0, 3.0, 1.0, 1e-3, 1e4}) {
    const RoomLight light = makeLight(random, LightShape::kParallelogram, size);
    const LitRoom room{{light}, {}, place(random, light, Placement::kCut)};
    cases.push_back(
        diffuseCase(room, polygonIrradiance(light.openOutline(), glm::dvec3(room.receiver.p),
                                            glm::dvec3(room.receiver.n))));
  }
  return judgeCases(run, cases);
}

Finding sphereLights(CheckRun& run) {
  constexpr std::uint32_t kRays = 256;  // half of the points by area are on the far side
  LitRoom plain{{plainLight(LightShape::kSphere)}, {}, kBelowPlainLight};
  std::vector<DirectCase> cases{caseOf(plain, kRays)};
  plain.receiver.lopsided = true;
  cases.push_back(caseOf(plain, kRays));
  Random random(run.seed);
  const std::pair<double, double> sizesAndSines[] = {
      {1.0, 0.5}, {3.0, 0.1}, {1e-3, 0.3}, {1e4, 0.5}, {1.0, 1e-3}};
  for (const auto& [size, sine] : sizesAndSines) {
    const RoomLight light = makeLight(random, LightShape::kSphere, size);
    cases.push_back(
        caseOf({{light}, {}, place(random, light, Placement::kWhollyLit, sine)}, kRays));
    const LitRoom cut{{light}, {}, place(random, light, Placement::kCut, sine)};
    const glm::dvec3 axis = glm::dvec3(light.centre) - glm::dvec3(cut.receiver.p);
    const double distance = glm::length(axis);
    cases.push_back(
        diffuseCase(cut,
                    sphereIrradiance(double{light.radius} / distance,
                                     glm::dot(axis, glm::dvec3(cut.receiver.n)) / distance),
                    kRays));
  }
  return judgeCases(run, cases);
}

// The receiver is a light too, about as bright as what it reflects of the other one. What it sends
// towards wo by itself is not scattered: tracePath adds it.
DirectCase receiverThatEmits(Random& random) {
  LitRoom room{{}, {}, kBelowPlainLight};
  room.lights.push_back(lightAround(random, room.receiver, LightShape::kParallelogram, 0, 1));
  room.receiver.emission = Colour(0.25f, 0.5f, 0.75f);
  return caseOf(room, 256);
}

// What hides a parallelogram light from p0 + share (p1 - p0) on: a parallelogram at a part of the
// way from the receiver.
std::vector<Point> screenBefore(const RoomLight& light, const Point& x, double share, double way) {
  constexpr double kMargin = 0.2;
  const glm::dvec3 p0(light.vertices[0]), v1 = glm::dvec3(light.vertices[1]) - p0,
                                          v2 = glm::dvec3(light.vertices[3]) - p0;
  const auto on = [&](double a, double b) {
    return Point(glm::mix(glm::dvec3(x), p0 + a * v1 + b * v2, way));
  };
  return {on(share, -kMargin), on(1.0 + kMargin, -kMargin), on(1.0 + kMargin, 1.0 + kMargin),
          on(share, 1.0 + kMargin)};
}

constexpr const char* kLoopEnds = "a light that sends nothing ends the loop over the lights";

// Of two lights the first sends nothing, and the second is in full view.
std::vector<LitCase> besideADarkLight() {
  const RoomLight shines = plainLight(LightShape::kParallelogram);
  std::vector<LitCase> cases;
  const auto add = [&](const RoomLight& dark, const char* why) -> LitRoom& {
    cases.push_back({{{dark, shines}, {}, kBelowPlainLight}, why, kLoopEnds});
    return cases.back().room;
  };
  RoomLight aside = shines;
  for (Point& v : aside.vertices) v.x += 20.0f;
  LitRoom& hidden = add(aside, "a screen hides the first light, and not the second");
  hidden.screens.push_back(screenBefore(aside, hidden.receiver.p, -0.2, 0.5));
  RoomLight below = shines;
  for (Point& v : below.vertices) v.y = -v.y;
  std::ranges::reverse(below.vertices);
  add(below, "the first light is below the horizon, the second above it");
  RoomLight turned = aside;
  std::ranges::reverse(turned.vertices);
  add(turned, "the first light has turned its back, the second has not");
  return cases;
}

// Lights of a single channel, very small and very large ones, and each of many.
std::vector<LitCase> unusualLights(std::uint64_t seed) {
  const LitRoom plain{{plainLight(LightShape::kParallelogram)}, {}, kBelowPlainLight};
  std::vector<LitCase> cases;
  for (int channel = 0; channel < 3; ++channel) {
    LitRoom room = plain;
    room.lights[0].emission = Colour(0.0f);
    room.lights[0].emission[channel] = 2.0f;
    cases.push_back({room, "the light shines in one channel only",
                     "a light is taken for black where only some of its channels are 0"});
  }
  Random random(seed);
  for (const double size : {1e-5, 1e6}) {
    const RoomLight light = makeLight(random, LightShape::kParallelogram, size);
    cases.push_back({{{light}, {}, place(random, light, Placement::kWhollyLit)},
                     "the light is as large in view as any other, and only the unit of length is "
                     "another",
                     "a distance, a density or a cosine that is small is taken for 0"});
  }
  constexpr int kMany = 12;
  for (const std::size_t shining : {0u, 5u, 11u}) {
    LitRoom room{{}, {}, kBelowPlainLight};
    for (int k = 0; k < kMany; ++k) {
      room.lights.push_back(
          lightAround(random, room.receiver, LightShape::kParallelogram, k, kMany));
      if (room.lights.size() != shining + 1) std::ranges::reverse(room.lights.back().vertices);
    }
    cases.push_back({room,
                     fmt::format("of {} lights number {} shines on the receiver, and the others "
                                 "have turned their backs",
                                 kMany, shining + 1),
                     "only some of the lights are asked"});
  }
  return cases;
}

// The first of two lights is a sphere around everything, and the only light is a sphere that x lies
// on.
std::vector<LitCase> inSpheres() {
  const RoomLight around{.radius = 50.0f, .emission = kPlainEmission};
  std::vector<LitCase> cases{
      {{{around, plainLight(LightShape::kParallelogram)}, {}, kBelowPlainLight},
       "the first light is a sphere around everything that shines outwards, the second is in it",
       kLoopEnds}};
  LitRoom inside{
      {{.centre = {1, 2, 3}, .radius = 2.0f, .inward = true, .emission = kPlainEmission}},
      {},
      {{3, 2, 3}, {-1, 0, 0}, {-0.8f, 0.6f, 0}}};
  inside.receiver.onLight = true;
  cases.push_back({inside, "x lies on the inside of a sphere that lights itself",
                   "the light that x is a part of is left out; what y.pdf, the cosines and "
                   "visible() say of it is enough"});
  return cases;
}

// What is always 0 has causes of its own, so the means come first.
Finding judgeBoth(CheckRun& run, const std::vector<DirectCase>& cases,
                  const std::vector<LitCase>& shining) {
  Finding finding = judgeCases(run, cases);
  if (!finding.passed()) return finding;
  const Finding found = judgeSomeLight(run, shining);
  const std::uint64_t calls = finding.calls + found.calls;
  if (!found.passed()) finding = found;
  finding.calls = calls;
  return finding;
}

// A sphere that shines inwards sends pi Le to every surface in it.
Finding inwardSpheres(CheckRun& run) {
  std::vector<DirectCase> cases;
  Random random(run.seed);
  for (const double share : {0.0, 0.3, 0.5}) {
    RoomLight light{
        .centre = {1, 2, 3}, .radius = 2.0f, .inward = true, .emission = kPlainEmission};
    Receiver receiver;
    receiver.p = light.centre + static_cast<float>(2.0 * share) * random.direction();
    receiver.n = share == 0.0 ? Vector(0, 1, 0) : random.direction();
    receiver.wo = atCosine(receiver.n, 0.8, 1.0);
    cases.push_back(diffuseCase({{light}, {}, receiver}, kPiD, 512));
  }
  return judgeBoth(run, cases, inSpheres());
}

// Two light a receiver from the front, one of five has turned its back on it.
Finding severalLights(CheckRun& run) {
  std::vector<DirectCase> cases;
  Random random(run.seed);
  for (const int count : {2, 3, 5}) {
    LitRoom room{{}, {}, kBelowPlainLight};
    room.receiver.lopsided = count > 2;
    for (int k = 0; k < count; ++k)
      room.lights.push_back(
          lightAround(random, room.receiver,
                      k % 2 == 0 ? LightShape::kParallelogram : LightShape::kTriangle, k, count));
    if (count == 5) std::reverse(room.lights[3].vertices.begin(), room.lights[3].vertices.end());
    cases.push_back(caseOf(room, 256));
  }
  cases.push_back(receiverThatEmits(random));
  std::vector<LitCase> shining = besideADarkLight();
  for (const LitCase& c : unusualLights(run.seed)) shining.push_back(c);
  return judgeBoth(run, cases, shining);
}

Finding screens(CheckRun& run) {
  constexpr std::uint32_t kRays = 256;
  const auto hide = [](const LitRoom& room, double share, double way) {
    LitRoom hidden = room;
    hidden.lights[0].open = share;
    hidden.screens.push_back(screenBefore(room.lights[0], room.receiver.p, share, way));
    return hidden;
  };
  const LitRoom plain{{plainLight(LightShape::kParallelogram)}, {}, kBelowPlainLight};
  std::vector<DirectCase> cases{caseOf(hide(plain, 0.5, 0.5), kRays)};
  // On the way to the light, but behind it or behind the receiver.
  for (const double way : {1.5, -0.5}) {
    LitRoom elsewhere = plain;
    elsewhere.screens.push_back(screenBefore(plain.lights[0], plain.receiver.p, 0.0, way));
    cases.push_back(caseOf(elsewhere));
  }
  Random random(run.seed);
  for (const auto& [size, share] : {std::pair{1.0, 0.45}, {1e-3, 0.75}, {1e4, 0.4}, {2.0, 0.6}}) {
    const RoomLight light = makeLight(random, LightShape::kParallelogram, size);
    const LitRoom room{{light}, {}, place(random, light, Placement::kWhollyLit)};
    cases.push_back(caseOf(hide(room, share, random.between(0.3, 0.7)), kRays));
  }
  return judgeCases(run, cases);
}

Finding darkness(CheckRun& run) {
  const LitRoom lit{{plainLight(LightShape::kParallelogram)}, {}, kBelowPlainLight};
  std::vector<DarkCase> cases;
  LitRoom room = lit;
  room.receiver.wo = {0.6f, -0.8f, 0};
  cases.push_back({room, "wo is below the surface, where the BRDF is 0", ""});
  room = lit;
  room.receiver.n = {0, -1, 0};
  room.receiver.wo = {0.6f, -0.8f, 0};
  cases.push_back({room, "the light is below the receiver's horizon",
                   "the cosine at the receiver must be positive"});
  room = lit;
  room.receiver.n = {0, -1, 0};
  cases.push_back({room, "wo and the light are both below the surface",
                   "the normal is turned round to the side of wo: hit.n is the front, and the BRDF "
                   "and the cosine tell that wo and wi are behind it"});
  room = lit;
  room.lights[0].frontOnly = true;
  room.receiver = {{0.3f, 4, 0.2f}, {0, -1, 0}, {0.6f, -0.8f, 0}};
  cases.push_back({room, "the receiver is behind the light, which shines from its front only",
                   "the cosine at the light must be positive"});
  room = lit;
  room.screens.push_back(screenBefore(room.lights[0], room.receiver.p, -0.2, 0.5));
  cases.push_back(
      {room, "a screen hides the light", "whether something lies between is not asked"});
  room = lit;
  room.lights.clear();
  cases.push_back({room, "there are no lights", ""});
  const char* none = "a sample with the density 0 is none: nothing may be divided by it";
  const Point centre(1, 2, 3);
  const auto sphereCase = [&](float share, const Vector& n, bool inward, const char* why) {
    room.lights = {
        {.centre = centre, .radius = 2.0f, .inward = inward, .emission = kPlainEmission}};
    room.receiver = {centre + Vector(2.0f * share, 0, 0), n, n};
    cases.push_back({room, why, none});
  };
  for (const Vector& n : {Vector(1, 0, 0), Vector(-1, 0, 0)}) {
    sphereCase(0.0f, n, false, "the receiver is inside a sphere that shines outwards");
    sphereCase(0.5f, n, false, "the receiver is inside a sphere that shines outwards");
    sphereCase(1.0f, n, false, "the receiver is on a sphere that shines outwards");
    sphereCase(2.5f, n, true, "the receiver is outside a sphere that shines inwards");
  }
  return judgeDarkness(run, cases);
}

// Exact, whatever the function is: it says where each number comes from.
Finding isAFunctionOfItsNumbers(CheckRun& run) {
  constexpr std::uint32_t kSeeds = 64;
  Random random(run.seed);
  Exact exact;
  for (const int count : {1, 3}) {
    LitRoom room{{}, {}, kBelowPlainLight};
    for (int k = 0; k < count; ++k)
      room.lights.push_back(
          lightAround(random, room.receiver, LightShape::kParallelogram, k, count));
    const auto call = [&](bool backwards) {
      const FlatScene flat = room.flat();
      run.worker.loadScene(flat);
      Calls calls(F::kDirectLighting);
      for (std::uint32_t k = 0; k < kSeeds; ++k)
        calls.add(room.receiver.p, room.receiver.n, room.rounding(), flat.materials.size() - 1,
                  room.receiver.wo, uvec2(backwards ? kSeeds - 1 - k : k, 7u));
      exact.count(kSeeds);
      return calls.run(run.worker);
    };
    const Results first = call(false), again = call(true);
    const std::string where = room.text();
    for (RoomLight& light : room.lights) light.emission *= 2.0f;
    const Results twice = call(false);
    for (std::uint32_t k = 0; k < kSeeds; ++k) {
      const Colour radiance = first.vector(k, 0);
      exact.holds(
          again.vector(kSeeds - 1 - k, 0) == radiance,
          "the same radiance again for the same numbers from the sampler",
          [&] {
            return fmt::format("{} and then {}", text(radiance),
                               text(again.vector(kSeeds - 1 - k, 0)));
          },
          [&] { return where; });
      exact.holds(
          twice.vector(k, 0) == 2.0f * radiance,
          "exactly twice the radiance for lights of twice the emission",
          [&] { return fmt::format("{} and {}", text(radiance), text(twice.vector(k, 0))); },
          [&] { return where; });
    }
  }
  return exact.finding();
}

}  // namespace

std::vector<Check> directLightingChecks() {
  constexpr F kDirect = F::kDirectLighting;
  const std::vector<F> triangle{F::kTriangularSampling}, rectangle{F::kRectangularSampling},
      polygon{F::kPolygonSampling}, sphere{F::kSphereSample},
      both{F::kTriangularSampling, F::kRectangularSampling};
  return {
      {"rectangle", kDirect, "the light of a rectangle that arrives, reflected by the BRDF", 0.005,
       polygonLights<LightShape::kParallelogram>, rectangle},
      {"triangle", kDirect, "the light of a triangle that arrives, reflected by the BRDF", 0.005,
       polygonLights<LightShape::kTriangle>, triangle},
      {"visibility", kDirect, "what a screen hides sends no light, and what it leaves open does",
       0.005, screens, rectangle},
      {"horizon", kDirect,
       "of a light that the horizon cuts, the part above it sends light, and the part below none",
       0.005, lightsAtTheHorizon, rectangle},
      {"dark", kDirect,
       "no light from below the horizon, to wo below it, from the back of a light, "
       "through a screen, or by a sample of density 0",
       0.0, darkness, rectangle},
      {"repeatable", kDirect,
       "the radiance depends on the numbers from the sampler and on nothing else, and is "
       "proportional to the emission",
       0.0, isAFunctionOfItsNumbers, rectangle},
      {"lights", kDirect,
       "of several lights the sum arrives, whichever of them are sampled, and what the surface "
       "itself emits is no part of it",
       0.005, severalLights, both},
      {"polygon", kDirect, "the light of a polygon that arrives, reflected by the BRDF", 0.005,
       polygonLights<LightShape::kPolygon>, polygon},
      {"sphere", kDirect, "the light of a sphere that arrives, reflected by the BRDF", 0.005,
       sphereLights, sphere},
      {"inside", kDirect,
       "in a sphere that shines inwards, Kd Le leaves every surface, also its own", 0.005,
       inwardSpheres, sphere},
  };
}

}  // namespace pathmark::checks
