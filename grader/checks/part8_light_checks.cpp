// What is asked of 8.3 before lights that can be sampled. Its worker has the stand-ins of part 5's;
// that of part 2 gives points of rectangles.
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/lit_room.h"
#include "checks/part8_checks.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "checks/random_rooms.h"
#include "checks/standins/beam.h"
#include "checks/standins/lopsided.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace pathmark::checks::path {

namespace {

using F = CourseworkFunction;

constexpr double kDelta = 0.005, kTwoPi = 2.0 * std::numbers::pi;

// A throughput that is black in green keeps the roulette's stand-in from ending paths, which would
// be most of the noise.
constexpr std::array kLit{0, 2};
const Colour kKd(kReceiverKd.x, 0.0f, kReceiverKd.z);

// `width` along an axis of the plane that is turned by `turn`, `height` across.
RoomLight rectangle(const glm::dvec3& centre, const glm::dvec3& normal, double width, double height,
                    double turn, const Colour& emission) {
  const DoubleFrame frame(normal);
  const glm::dvec3 u = std::cos(turn) * frame.u + std::sin(turn) * frame.v,
                   v = glm::cross(frame.n, u);
  const glm::dvec3 corner = centre - 0.5 * width * u - 0.5 * height * v;
  RoomLight light;
  light.emission = emission;
  for (const glm::dvec3& p :
       {corner, corner + width * u, corner + width * u + height * v, corner + height * v})
    light.vertices.emplace_back(p);
  return light;
}

// The room with its receiver as a small surface, and a ray that looks at it.
FlatScene sceneOf(const LitRoom& room, double size) {
  SceneBuilder builder;
  for (const RoomLight& light : room.lights)
    builder.polygon({.emission = light.emission}, light.vertices);
  for (const auto& screen : room.screens) builder.polygon({}, screen);
  const DoubleFrame frame{glm::dvec3(room.receiver.n)};
  const double side = 1e-3 * size;
  const glm::dvec3 corner = glm::dvec3(room.receiver.p) - 0.5 * side * (frame.u + frame.v);
  std::vector<Point> vertices{Point(corner), Point(corner + side * frame.u),
                              Point(corner + side * (frame.u + frame.v)),
                              Point(corner + side * frame.v)};
  if (glm::dot(glm::cross(frame.u, frame.v), frame.n) < 0.0)
    std::reverse(vertices.begin(), vertices.end());
  builder.polygon({.kd = kKd, .ks = Colour(0.05f), .exponent = 1.0f}, vertices);
  return builder.flat();
}

struct Case {
  std::string what;
  LitRoom room;
  double size = 1.0;  // of the room
  std::uint32_t paths = 512;

  PathRay ray() const {
    const Receiver& x = room.receiver;
    return {{x.p + static_cast<float>(1e-2 * size) * x.wo, -x.wo}, 1};
  }
};

LitRoom below(std::vector<RoomLight> lights, Random& random) {
  LitRoom room{std::move(lights), {}, {}};
  room.receiver = {{0, 0, 0}, {0, 1, 0}, {0, 1, 0}, true};
  room.receiver.wo = atCosine({0, 1, 0}, random.between(0.3, 0.9), random.between(0.0, kTwoPi));
  return room;
}

// Above a receiver at the origin, around which it stands somewhere.
RoomLight above(Random& random, double height, double width, double depth) {
  const double aside = 0.3 * height;
  return rectangle({random.between(-aside, aside), height, random.between(-aside, aside)},
                   {0, -1, 0}, width, depth, random.between(0.0, kTwoPi), randomEmission(random));
}

std::vector<Case> cases(std::uint64_t seed) {
  Random random(seed);
  std::vector<Case> all;
  all.push_back({"one light", below({above(random, 1.0, 2.0, 3.0)}, random)});
  all.push_back({"a light that is near", below({above(random, 0.3, 2.0, 2.0)}, random), 1.0, 2048});
  all.push_back({"a light that is far", below({above(random, 2.0, 0.5, 0.3)}, random)});
  for (const int count : {2, 3, 5}) {
    const double largest = 1.5 / count;  // none hides another
    LitRoom room = below({}, random);
    for (int k = 0; k < count; ++k) {
      const double azimuth = kTwoPi * (k + random.between(0.4, 0.6)) / count;
      const glm::dvec3 towards(0.7 * std::cos(azimuth), 0.7, 0.7 * std::sin(azimuth));
      room.lights.push_back(rectangle(
          random.between(1.0, 1.3) * towards, -towards, random.between(0.5, 1.0) * largest,
          random.between(0.5, 1.0) * largest, 0.0, randomEmission(random)));
    }
    all.push_back({fmt::format("{} lights", count), room, 1.0, 1024});
  }
  // A screen halfway hides all of the light but the open share.
  LitRoom hidden = below({above(random, 1.0, 2.0, 2.0)}, random);
  RoomLight& light = hidden.lights[0];
  light.open = random.between(0.4, 0.6);
  const glm::dvec3 p0(light.vertices[0]), v1 = glm::dvec3(light.vertices[1]) - p0,
                                          v2 = glm::dvec3(light.vertices[3]) - p0;
  const auto halfway = [&](double a, double b) { return Point(0.5 * (p0 + a * v1 + b * v2)); };
  hidden.screens.push_back(
      {halfway(light.open, -0.2), halfway(1.2, -0.2), halfway(1.2, 1.2), halfway(light.open, 1.2)});
  all.push_back({"a light half hidden", hidden, 1.0, 1024});
  for (const double size : {1e-3, 1e4}) {
    LitRoom room = below({above(random, 1.0, 2.0, 2.0)}, random);
    for (Point& v : room.lights[0].vertices) v *= static_cast<float>(size);
    all.push_back({fmt::format("a light {:g} times as large", size), room, size});
  }
  return all;
}

// Of a light sample against the stand-in BRDF's uniform density.
double lightWeight(const LightTerms& t) {
  const double light = t.density * t.distance * t.distance / t.cosY,
               brdf = lopsided::kShareOfSamples / kTwoPi;
  return light * light / (light * light + brdf * brdf);
}

struct MisMistake {
  const char* words;
  Kernel kernel;
};

constexpr MisMistake kMistakes[] = {
    {"direct light is counted twice, both ways fully: without weights",
     [](const LightTerms& t) { return 2.0 * rightKernel(t); }},
    {"the half that light samples find is all: the emission of a light that the path meets is left "
     "out, or its last ray is",
     [](const LightTerms& t) { return lightWeight(t) * rightKernel(t); }},
    {"the half that the path meets by itself is all: light samples are left out",
     [](const LightTerms& t) { return (1.0 - lightWeight(t)) * rightKernel(t); }},
    {"light samples are weighted, but not the emission of a light that the path meets",
     [](const LightTerms& t) { return (1.0 + lightWeight(t)) * rightKernel(t); }},
    {"the emission of a light that the path meets is weighted, but not the light samples",
     [](const LightTerms& t) { return (2.0 - lightWeight(t)) * rightKernel(t); }},
    {"the weights are those of densities per unit area and per unit solid angle, mixed",
     [](const LightTerms& t) {
       const double area = t.density, brdf = lopsided::kShareOfSamples / kTwoPi;
       const double mixed = area * area / (area * area + brdf * brdf);
       return (1.0 - lightWeight(t) + mixed) * rightKernel(t);
     }},
};

glm::dvec3 expected(Kernel kernel, const LitRoom& room) { return radianceBy(kernel, room); }

// Along one ray through the scene that the worker has.
Finding judgeRay(CheckRun& run, const PathRay& ray, std::uint32_t paths, const glm::dvec3& right,
                 const std::string& where, const std::vector<Suspicion>& suspicions) {
  std::vector<Mean> means;
  for (const int channel : kLit)
    means.push_back({.what = inChannel("radiance", channel),
                     .expected = right[channel],
                     .delta = kDelta,
                     .scale = right[channel]});
  PathEstimates estimates(run, {ray}, paths);
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> all(3 * count);
    estimates.measure(first, count, all);
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t k = 0; k < kLit.size(); ++k)
        values[r * kLit.size() + k] = all[3 * r + static_cast<std::size_t>(kLit[k])];
  };
  Finding finding = judgeMeans(run, means, measure, where, suspicions);
  finding.calls = estimates.paths();
  return finding;
}

Finding judge(CheckRun& run, const Case& c, std::uint64_t seed) {
  run.worker.loadScene(sceneOf(c.room, c.size));
  std::vector<Suspicion> suspicions;
  if (c.room.lights.size() == 1)
    for (const MisMistake& mistake : kMistakes) {
      const glm::dvec3 wrong = expected(mistake.kernel, c.room);
      suspicions.push_back({mistake.words, {wrong.x, wrong.z}});
    }
  CheckRun own{run.worker, seed, run.budget, run.function};
  return judgeRay(own, c.ray(), c.paths, expected(rightKernel, c.room),
                  fmt::format("{}, maxBounces() = 1\n{}", c.what, c.room.text()), suspicions);
}

Finding directLight(CheckRun& run) {
  Finding worst;
  std::uint64_t calls = 0, seed = run.seed;
  for (const Case& c : cases(run.seed)) {
    const Finding finding = judge(run, c, ++seed);
    calls += finding.calls;
    if (worst.passed()) worst = finding;
    if (!finding.passed()) break;
  }
  worst.calls = calls;
  return worst;
}

// Variance of one path over the squared mean.
double relativeVariance(CheckRun& run, const Case& c, std::uint64_t& calls) {
  constexpr std::uint32_t kPaths = 1u << 13;
  run.worker.loadScene(sceneOf(c.room, c.size));
  PathEstimates estimates(run, {c.ray()}, 1);
  std::vector<double> values(3 * kPaths);
  estimates.measure(0, kPaths, values);
  calls += estimates.paths();
  const double mean = expected(rightKernel, c.room).x;
  double sum = 0.0;
  for (std::size_t k = 0; k < kPaths; ++k)
    sum += (values[3 * k] / mean - 1.0) * (values[3 * k] / mean - 1.0);
  return sum / kPaths;
}

// A light so near that points of it are a bad guess, and one so small that directions are: by
// either way alone the variance is above a hundred, by both it is about 1, and no path counts for
// much more than the mean.
Finding bothWays(CheckRun& run) {
  constexpr double kMost = 10.0;
  Random random(run.seed);
  Exact exact;
  bool nearFails = false, smallFails = false;
  std::uint64_t calls = 0;
  for (const bool near : {true, false}) {
    const Case c{
        near ? "a light close by" : "a small light",
        below({near ? above(random, 0.05, 2.0, 2.0) : above(random, 1.0, 0.1, 0.1)}, random)};
    const double variance = relativeVariance(run, c, calls);
    const bool right = exact.holds(
        variance <= kMost,
        fmt::format("paths whose variance is at most {:g} squared means of them", kMost),
        [&] { return fmt::format("{:.3g} squared means", variance); },
        [&] { return fmt::format("{}\n{}", c.what, c.room.text()); });
    (near ? nearFails : smallFails) = !right;
  }
  exact.count(calls);
  Finding finding = exact.finding();
  if (nearFails && smallFails)
    finding.cause = "the weights are exchanged: each sample has the weight of the other way";
  else if (nearFails)
    finding.cause = "direct light comes from light samples alone, as in part 5";
  else if (smallFails)
    finding.cause = "direct light comes from the lights that paths meet by themselves alone";
  return finding;
}

// In a box whose walls all emit and reflect alike, what comes from any of them is known. A small
// surface that looks at it draws directions with quite another density than the walls: a weight
// that takes the density of another hit than its own is wrong from the second hit on.
Finding laterHits(CheckRun& run) {
  Random random(run.seed);
  constexpr int kBounces = 3;
  const auto length = static_cast<float>(random.between(0.5, 2.0));
  const Colour emission = randomEmission(random), albedo(0.7f, 0.0f, 0.5f), kd(0.6f, 0.0f, 0.8f);
  const Surface wall{.kd = albedo, .emission = emission};
  const Vector x(length, 0, 0), y(0, length, 0), z(0, 0, length);
  SceneBuilder builder;
  builder.parallelogram(wall, Point(0), x, y)
      .parallelogram(wall, Point(z), y, x)
      .parallelogram(wall, Point(0), z, x)
      .parallelogram(wall, Point(y), x, z)
      .parallelogram(wall, Point(0), y, z)
      .parallelogram(wall, Point(x), z, y);
  const Point centre(0.5f * (x + y + z));
  const float side = 1e-3f;  // of the box
  builder.parallelogram({.kd = kd, .ks = Colour(0.05f), .exponent = beam::kLeastExponent},
                        centre - 0.5f * side * (x + z), side * z, side * x);
  run.worker.loadScene(builder.flat());
  const Vector wo = atCosine({0, 1, 0}, random.between(0.3, 0.9), random.between(0.0, kTwoPi));
  glm::dvec3 right(0.0);
  for (const int channel : kLit) {
    const double rho{albedo[channel]};
    double share = 1.0;
    for (int bounce = 1; bounce <= kBounces; ++bounce, share *= rho) right[channel] += share;
    right[channel] *= double{kd[channel]} * double{emission[channel]};
  }
  return judgeRay(
      run, {{centre + 1e-2f * length * wo, -wo}, kBounces}, 512, right,
      fmt::format("in a box of which all walls emit {} and reflect {}, looking at a small surface "
                  "that reflects into a narrow cone only, maxBounces() = {}",
                  text(emission), text(albedo), kBounces),
      {});
}

}  // namespace

std::vector<Check> lightChecks() {
  return {
      {"direct-light", F::kTracePathMis,
       "the mean radiance of a surface before lights is the light that they send, found in two "
       "ways and counted once",
       kDelta, directLight},
      {"later-hits", F::kTracePathMis,
       "the weights at each hit are those of its own densities, not of another hit's", kDelta,
       laterHits},
      {"both-ways", F::kTracePathMis,
       "lights are found both by points on them and by the path itself, so that neither a near "
       "light nor a small one is noisy",
       0.0, bothWays},
  };
}

}  // namespace pathmark::checks::path
