// What is asked of 8.3 before lights that can be sampled. Its worker has the stand-ins of part 5's;
// that of part 2 gives points of rectangles.
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/hollow.h"
#include "checks/lit_room.h"
#include "checks/lopsided_furnace.h"
#include "checks/part8_checks.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "checks/random_rooms.h"
#include "checks/standins/beam.h"
#include "checks/standins/leaning.h"
#include "checks/standins/lopsided.h"
#include "checks/standins/sampled_sphere.h"
#include "checks/standins/unfair_roulette.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace pathmark::checks::path {

namespace {

using F = CourseworkFunction;

constexpr double kDelta = 0.005, kRouletteDelta = 0.02, kTwoPi = 2.0 * std::numbers::pi;

// A throughput that is black in red or green keeps the roulette's stand-in from ending paths, which
// would be most of the noise.
enum class Black { kRed, kGreen };

Colour without(Colour colour, Black black) {
  (black == Black::kRed ? colour.x : colour.y) = 0.0f;
  return colour;
}

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
FlatScene sceneOf(const LitRoom& room, double size, Black black) {
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
  const float exponent = room.receiver.lopsided ? 1.0f : leaning::kExponent;
  builder.polygon({.kd = without(kReceiverKd, black), .ks = Colour(0.05f), .exponent = exponent},
                  vertices);
  return builder.flat();
}

struct Case {
  std::string what;
  LitRoom room;
  double size = 1.0;  // of the room
  std::uint32_t paths = 512;
  Black black = Black::kGreen;
  bool isDark = false;  // in some channel, or in all

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
  // What is black in some channel is not black.
  for (const Colour& lit : {Colour(1, 0, 0), Colour(0, 1, 0), Colour(0, 0, 1), Colour(1e-3f)}) {
    LitRoom room = below({above(random, 1.0, 2.0, 2.0)}, random);
    room.lights[0].emission = lit * room.lights[0].emission;
    all.push_back({fmt::format("a light of the emission {}", text(room.lights[0].emission)), room,
                   1.0, 512, lit.x == 1.0f ? Black::kGreen : Black::kRed, true});
  }
  // On the side away from wo, where the leaning BRDF draws most of its directions.
  LitRoom glossy = below({}, random);
  glossy.receiver.lopsided = false;
  glossy.receiver.wo = atCosine({0, 1, 0}, random.between(0.4, 0.7), random.between(0.0, kTwoPi));
  const glm::dvec3 away =
      glm::normalize(glm::dvec3(-glossy.receiver.wo.x, 0.0, -glossy.receiver.wo.z));
  const glm::dvec3 towards = glm::normalize(away + glm::dvec3(0.0, 0.8, 0.0));
  glossy.lights.push_back(
      rectangle(0.9 * towards, -towards, 0.9, 0.9, 0.0, randomEmission(random)));
  all.push_back({"a surface whose directions depend on wo", glossy, 1.0, 1024});
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
    {"the emission of a light that the path meets is weighted, but not the light samples, or the "
     "density in their weight is asked for a wo below the surface: it is -ray.direction",
     [](const LightTerms& t) { return (2.0 - lightWeight(t)) * rightKernel(t); }},
    {"the weights are those of densities per unit area and per unit solid angle, mixed",
     [](const LightTerms& t) {
       const double area = t.density, brdf = lopsided::kShareOfSamples / kTwoPi;
       const double mixed = area * area / (area * area + brdf * brdf);
       return (1.0 - lightWeight(t) + mixed) * rightKernel(t);
     }},
};

glm::dvec3 expected(Kernel kernel, const LitRoom& room) { return radianceBy(kernel, room); }

// Channels in which there is something to see.
std::vector<int> litChannels(const glm::dvec3& radiance, Black black) {
  std::vector<int> lit;
  for (int channel = 0; channel < 3; ++channel)
    if (radiance[channel] > 0.0 && channel != (black == Black::kRed ? 0 : 1))
      lit.push_back(channel);
  return lit;
}

// Along one ray through the scene that the worker has.
Finding judgeRay(CheckRun& run, const PathRay& ray, std::uint32_t paths, const glm::dvec3& right,
                 const std::vector<int>& lit, const std::string& where,
                 const std::vector<Suspicion>& suspicions) {
  std::vector<Mean> means;
  for (const int channel : lit)
    means.push_back({.what = inChannel("radiance", channel),
                     .expected = right[channel],
                     .delta = kDelta,
                     .scale = right[channel]});
  PathEstimates estimates(run, {ray}, paths);
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> all(3 * count);
    estimates.measure(first, count, all);
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t k = 0; k < lit.size(); ++k)
        values[r * lit.size() + k] = all[3 * r + static_cast<std::size_t>(lit[k])];
  };
  Finding finding = judgeMeans(run, means, measure, where, suspicions);
  finding.calls = estimates.paths();
  return finding;
}

Finding judge(CheckRun& run, const Case& c, std::uint64_t seed) {
  run.worker.loadScene(sceneOf(c.room, c.size, c.black));
  const glm::dvec3 right = expected(rightKernel, c.room);
  const std::vector<int> lit = litChannels(right, c.black);
  std::vector<Suspicion> suspicions;
  if (c.room.lights.size() == 1 && c.room.receiver.lopsided && !c.isDark)
    for (const MisMistake& mistake : kMistakes) {
      const glm::dvec3 wrong = expected(mistake.kernel, c.room);
      suspicions.push_back({mistake.words, {}});
      for (const int channel : lit) suspicions.back().means.push_back(wrong[channel]);
    }
  CheckRun own{run.worker, seed, run.budget, run.function};
  return judgeRay(own, c.ray(), c.paths, right, lit,
                  fmt::format("{}, maxBounces() = 1\n{}", c.what, c.room.text()), suspicions);
}

// What a case asks that plainer ones before it have not.
std::string causeOf(const Case& c) {
  if (!c.room.receiver.lopsided)
    return "the density in the weight of a light sample is hit.brdf->pdf(wo, wi, n), with the wo "
           "of "
           "this hit, -ray.direction";
  if (c.isDark)
    return "what is black in one channel, or dark, is taken for black: compare with Colour(0)";
  if (c.room.lights.size() > 1)
    return "one of several lights: its probability belongs in both weights, and the light that the "
           "path meets is hit.light, which may be another than the one that was sampled";
  return {};
}

Finding directLight(CheckRun& run) {
  Finding worst;
  std::uint64_t calls = 0, seed = run.seed;
  for (const Case& c : cases(run.seed)) {
    const Finding finding = judge(run, c, ++seed);
    calls += finding.calls;
    if (worst.passed()) worst = finding;
    if (!finding.passed()) {
      if (finding.status == Status::kFail && worst.cause.empty()) worst.cause = causeOf(c);
      break;
    }
  }
  worst.calls = calls;
  return worst;
}

// Variance of one path over the squared mean.
double relativeVariance(CheckRun& run, const Case& c, std::uint64_t& calls) {
  constexpr std::uint32_t kPaths = 1u << 13;
  run.worker.loadScene(sceneOf(c.room, c.size, c.black));
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

// The same of light samples alone, uniform on one light: the second moment over the squared mean,
// less one.
double varianceOfLightSamples(const LitRoom& room) {
  const RoomLight& light = room.lights[0];
  const double factor = double{kReceiverKd.x} * double{light.emission.x} / std::numbers::pi;
  const Kernel squared = [](const LightTerms& t) { return rightKernel(t) * rightKernel(t); };
  const double mean = expected(rightKernel, room).x / factor;
  return light.area() * (expected(squared, room).x / factor) / (mean * mean) - 1.0;
}

// A light so near that points of it are a bad guess, and one so small that directions are: by
// either way alone the variance is above a hundred, by both it is about 1, and no path counts for
// much more than the mean.
Finding bothWays(CheckRun& run) {
  constexpr double kMost = 10.0;
  Random random(run.seed);
  Exact exact;
  bool nearFails = false, smallFails = false, lightSamplesAlone = false;
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
    if (near) {
      const double alone = varianceOfLightSamples(c.room);
      lightSamplesAlone = variance > 0.7 * alone && variance < 1.4 * alone;
    }
  }
  exact.count(calls);
  Finding finding = exact.finding();
  if (nearFails && smallFails)
    finding.cause = "the weights are exchanged: each sample has the weight of the other way";
  else if (nearFails)
    finding.cause =
        lightSamplesAlone
            ? "direct light comes from light samples alone, as in part 5"
            : "the near light is noisy: what the BRDF's directions find counts too little, or "
              "their "
              "paths end too early. Are both densities of a weight per unit solid angle? Is the "
              "roulette shown the updated throughput?";
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
  // The walls' directions depend on wo, which is another one at each hit.
  const Surface wall{
      .kd = albedo, .emission = emission, .ks = Colour(0.05f), .exponent = leaning::kExponent};
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
  const std::vector<int> lit{0, 2};
  for (const int channel : lit) {
    const double rho{albedo[channel]};
    double share = 1.0;
    for (int bounce = 1; bounce <= kBounces; ++bounce, share *= rho) right[channel] += share;
    right[channel] *= double{kd[channel]} * double{emission[channel]};
  }
  return judgeRay(
      run, {{centre + 1e-2f * length * wo, -wo}, kBounces}, 512, right, lit,
      fmt::format("in a box of which all walls emit {} and reflect {}, looking at a small surface "
                  "that reflects into a narrow cone only, maxBounces() = {}",
                  text(emission), text(albedo), kBounces),
      {});
}

// The furnace's direct light at one hit, where the half that light samples find is left out:
// uniform by area, their density per unit solid angle is cos(wi) / pi.
double withoutOwnLight(const LopsidedFurnace& furnace, double cosine) {
  constexpr int kSteps = 4096;
  constexpr double kBrdf = lopsided::kShareOfSamples / kTwoPi;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double c = (k + 0.5) / kSteps, density = c / std::numbers::pi;
    const double found = kBrdf * kBrdf / (kBrdf * kBrdf + density * density);
    sum += found * lopsided::shape(cosine, c) * c / kSteps;
  }
  return furnace.emission * (1.0 + 2.0 * furnace.kd * sum);
}

// Of a sphere that part 2's stand-in gives points of, the inside lights itself.
Finding ownLight(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random, 2.0f * kSampledRadius);
  const Colour kd(0.6f, 0.0f, 0.8f), emission(1.0f, 0.5f, 2.0f);
  constexpr double kCosine = 0.7;
  run.worker.loadScene(furnaceIn(hollow, kd, emission));
  const std::vector<int> lit{0, 2};
  glm::dvec3 right(0.0);
  Suspicion skipped{
      "the light that a hit is on gives it no light samples: the inside of a sphere lights itself",
      {}};
  for (const int channel : lit) {
    const LopsidedFurnace furnace{double{emission[channel]}, double{kd[channel]}};
    right[channel] = furnace.radiance(kCosine, 1);
    skipped.means.push_back(withoutOwnLight(furnace, kCosine));
  }
  return judgeRay(run, {hollow.rayAt(kCosine, random), 1}, 512, right, lit,
                  fmt::format("inside a sphere that emits {} everywhere and of which light samples "
                              "are taken, maxBounces() = 1",
                              text(emission)),
                  {skipped});
}

// With a roulette that is not fair the mean shows what it was asked. Where it comes is free, before
// the light that the ray finds or after it: each of these gives another mean, and any of them is
// right.
Finding unfairRoulette(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random);
  const Colour kd(0.9f, 0.8f, 0.0f), emission(1.0f, 0.5f, 2.0f);
  constexpr double kCosine = 0.8;
  constexpr std::array kBounces{1, 2};
  run.worker.loadScene(furnaceIn(hollow, kd, emission));
  std::vector<PathRay> rays;
  for (const int bounces : kBounces) rays.push_back({hollow.rayAt(kCosine, random), bounces});
  using Factor = std::function<double(int hit, int bounces)>;
  const auto meansBy = [&](LightBefore before, const Factor& factor) {
    std::vector<double> means;
    double sum = 0.0;
    for (const int bounces : kBounces)
      for (const int channel : {0, 1}) {
        const LopsidedFurnace furnace{double{emission[channel]}, double{kd[channel]}};
        means.push_back(unfairMisRadiance(furnace, kCosine, bounces, before,
                                          [&](int hit) { return factor(hit, bounces); }));
        sum += means.back() / furnace.emission;
      }
    means.push_back(sum);
    return means;
  };
  const Factor right = [](int hit, int) { return unfair::factor(hit); };
  const std::pair<const char*, Factor> mistakes[] = {
      {"RussianRoulette is not asked, or its answer is not used", [](int, int) { return 1.0; }},
      {"depth counts from 0: it is the number of scattering events so far, 1 at hit 1",
       [](int hit, int) { return unfair::factor(hit - 1); }},
      {"depth is one too large: it is the number of scattering events so far, 1 at hit 1",
       [](int hit, int) { return unfair::factor(hit + 1); }},
      {"the roulette is told maxBounces() as the depth: it is the number of scattering events so "
       "far, 1 at hit 1",
       [](int, int bounces) { return unfair::factor(bounces); }},
      {"the roulette is shown the throughput from before its update",
       [](int hit, int) { return hit == 1 ? 1.0 : unfair::factor(hit); }},
  };
  constexpr std::array kOrders{LightBefore::kNone, LightBefore::kLast, LightBefore::kAll};
  std::vector<Suspicion> suspicions;
  for (const auto& [words, factor] : mistakes)
    for (const LightBefore before : kOrders) suspicions.push_back({words, meansBy(before, factor)});
  PathEstimates estimates(run, rays, 512);
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> all(6 * count);
    estimates.measure(first, count, all);
    for (std::size_t r = 0; r < count; ++r) {
      double* of = &values[5 * r];
      of[4] = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        of[k] = all[6 * r + 3 * (k / 2) + k % 2];
        of[4] += of[k] / double{emission[static_cast<int>(k % 2)]};
      }
    }
  };
  Finding first;
  for (const LightBefore before : kOrders) {
    const std::vector<double> expectedMeans = meansBy(before, right);
    std::vector<Mean> means;
    for (std::size_t k = 0; k < expectedMeans.size(); ++k)
      means.push_back({.what = k == 4 ? "radiance / emission, sum over all rays and channels"
                                      : fmt::format("{}, maxBounces() = {}",
                                                    inChannel("radiance", static_cast<int>(k % 2)),
                                                    kBounces[k / 2]),
                       .expected = expectedMeans[k],
                       .delta = k == 4 ? kRouletteDelta : 3.0 * kRouletteDelta,
                       .scale = expectedMeans[k]});
    Finding finding =
        judgeMeans(run, means, measure,
                   "inside a sphere that emits everywhere, with a roulette for testing: where the "
                   "throughput's blue is 0, as after every update here, its weight is not 1/q but "
                   "(1 + 1/(1 + depth)) / q",
                   suspicions);
    finding.calls = estimates.paths();
    if (before == kOrders[0]) first = finding;
    if (finding.passed()) return finding;
  }
  first.calls = estimates.paths();
  return first;
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
      {"own-light", F::kTracePathMis,
       "a light that the hit is on gives light samples as all others do", kDelta, ownLight},
      {"unfair-roulette", F::kTracePathMis,
       "RussianRoulette is asked after each update of the throughput, with the updated throughput "
       "and the number of scattering events so far, and what it says is done",
       kRouletteDelta, unfairRoulette},
      {"both-ways", F::kTracePathMis,
       "lights are found both by points on them and by the path itself, so that neither a near "
       "light nor a small one is noisy",
       0.0, bothWays},
  };
}

}  // namespace pathmark::checks::path
