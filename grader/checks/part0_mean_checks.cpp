// What is asked of part 0: means over many paths, of one bounce and of all.
#include "checks/exact.h"
#include "checks/part0_radiance.h"
#include "checks/radiance_checks.h"

#include <pathmark/warmup.h>

#include <fmt/format.h>

#include <numbers>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr double kPiD = std::numbers::pi;

constexpr const char* kNoBounce = "the reflected light is left out";
constexpr const char* kLongOffset =
    "in a small scene rays meet nothing: their origin is moved off the surface by a fixed length, "
    "which is larger than the scene; spawn_ray knows the right one";

// What mistakes in the estimate of one bounce give: `own` is emitted, `reflected` is what the
// bounce adds, and `withoutCosine` what it would add with 2 a Le instead of 2 a Le cos(theta).
// `withoutReflected`: what the mistake is if the bounce adds nothing.
std::vector<SuspectedRadiance> directSuspects(const char* withoutReflected, const glm::dvec3& own,
                                              const glm::dvec3& reflected,
                                              const glm::dvec3& withoutCosine) {
  return {{withoutReflected, own},
          {"what the point itself emits is left out", reflected},
          {"the estimate is not divided by the density 1/(2 pi): the factor 2 pi is missing",
           own + reflected / (2.0 * kPiD)},
          {"the BRDF is a/pi: its factor 1/pi is missing", own + kPiD * reflected},
          {"the cosine n . omega is missing", own + withoutCosine},
          {"the factor 2 is missing", own + 0.5 * reflected}};
}

}  // namespace

Finding oneBounceInEvenRoom(CheckRun& run) {
  Random random(run.seed);
  std::vector<std::function<Finding(CheckRun&)>> questions;
  const glm::dvec3 emitted(EvenRoom::kEmission),
      reflected = emitted * glm::dvec3(EvenRoom::kColour);
  const double sizes[4] = {1.0, 3e-6, 1e3, 0.5};
  for (std::size_t face = 0; face < 4; ++face)
    questions.emplace_back([&, face](CheckRun& own) {
      const EvenRoom room(random, sizes[face]);
      const Point x = room.pointOn(face);
      const AddCall add = [&](Calls& calls, std::uint32_t, uvec2 seed) {
        calls.add(x, face, seed);
      };
      return judgeRadiance(own,
                           {F::kComputeDirectIllumination, room.mesh.words(), add,
                            fmt::format("{}, at {}", room.where(), text(x)), 128},
                           emitted + reflected,
                           directSuspects(sizes[face] < 1e-3 ? kLongOffset : kNoBounce, emitted,
                                          reflected, 2.0 * reflected));
    });
  return judgeAll(run, questions);
}

namespace {

// A tilted light over a receiver, and in front of a part of the light a plate that does not shine.
struct LightAndBlocker {
  Setting setting;
  glm::dvec3 x;
  Plate light, blocker;
  glm::dvec3 colour{0.9, 0.5, 0.2}, emission;  // of the receiver
  MeshWords mesh;

  LightAndBlocker(Random& random, double size, bool lightUp, const glm::dvec3& emission_)
      : setting(random, size),
        x(setting.at(0.05, 0.0, -0.1)),
        light(setting.plate(setting.at(-2.3, 0.8, -2.2), setting.at(4.8, 0.3, 0.0),
                            setting.at(0.0, 0.2, 4.5), lightUp)),
        blocker(setting.plate(setting.at(-0.2, 0.5, -0.25), setting.at(0.3, 0.05, 0.0),
                              setting.at(0.0, 0.0, 0.35), lightUp)),
        emission(emission_) {
    light.emission = {1.0, 2.0, 0.5};
    light.colour = {0.1, 0.8, 0.6};
    blocker.colour = glm::dvec3(0.7);
    mesh.triangle(setting.at(-1, 0, -1), setting.at(0, 0, 1.2), setting.at(1, 0, -1), setting.up(),
                  Colour(colour), Colour(emission));
    mesh.plate(lightUp ? light : blocker);
    mesh.plate(lightUp ? blocker : light);
  }
  // Of what the light sends out, with a reflectance of 1.
  glm::dvec3 received(const BounceFactor& factor) const {
    return light.emission *
           (bounce(x, setting.up(), light, factor) - bounce(x, setting.up(), blocker, factor));
  }
};

}  // namespace

Finding oneBounceFromLight(CheckRun& run) {
  Random random(run.seed);
  std::vector<std::function<Finding(CheckRun&)>> questions;
  for (const bool lightUp : {false, true})
    questions.emplace_back([&random, lightUp](CheckRun& own) {
      const LightAndBlocker scene(
          random, lightUp ? 1.0 : 50.0, lightUp,
          lightUp ? glm::dvec3(0.3, 0.6, 0.05) : glm::dvec3(0.5, 0.4, 0.04));
      const glm::dvec3 received = scene.received(diffuseFactor);
      std::vector<SuspectedRadiance> suspects =
          directSuspects(lightUp ? kOneSided : kNoBounce, scene.emission, scene.colour * received,
                         scene.colour * scene.received([](double) { return 2.0; }));
      suspects.push_back(
          {"the colour of the triangle that is seen is used, not that of the point's "
           "own triangle",
           scene.emission + scene.light.colour * received});
      const Point x(scene.x);
      const AddCall add = [&](Calls& calls, std::uint32_t, uvec2 seed) { calls.add(x, 0, seed); };
      return judgeRadiance(
          own,
          {F::kComputeDirectIllumination, scene.mesh.words(), add,
           fmt::format(
               "a triangle of colour {} and emission {} under a light of emission {}, whose "
               "normal points {}, a part of it hidden",
               text(Colour(scene.colour)), text(Colour(scene.emission)),
               text(Colour(scene.light.emission)),
               lightUp ? "away: emission is two-sided" : "to the triangle"),
           1024},
          scene.emission + scene.colour * received, suspects);
    });
  return judgeAll(run, questions);
}

namespace {

// Sum of the first `hits` terms, each bounce with the colour times `factor`.
glm::dvec3 series(int hits, double factor = 1.0) {
  glm::dvec3 sum(0.0), throughput(1.0);
  for (int k = 0; k < hits; ++k) {
    sum += throughput * glm::dvec3(EvenRoom::kEmission);
    throughput *= factor * glm::dvec3(EvenRoom::kColour);
  }
  return sum;
}

constexpr const char* kOneShort = "the path has one hit too few: MAX_PATH_LENGTH counts hits";
constexpr const char* kOneLong = "the path has one hit too many: MAX_PATH_LENGTH counts hits";
constexpr const char* kOneHit = "only the first hit counts";
constexpr const char* kUpdatedFirst =
    "the throughput is updated before the emission of the hit is added";
constexpr const char* kNoTwoPi =
    "the throughput is not divided by the density 1/(2 pi): the factor 2 pi is missing";
constexpr const char* kNoPi = "the BRDF is a/pi: its factor 1/pi is missing in the throughput";
constexpr const char* kNoCosine = "the cosine n . omega is missing in the throughput";
constexpr const char* kNoTwo =
    "a factor 2 is missing in the throughput: a/pi 2 pi cos(theta) is 2 a cos(theta)";
constexpr const char* kNotUpdated = "the throughput is never updated";
constexpr const char* kAssigned =
    "the throughput is set to the factor of the last bounce, not multiplied by it";
constexpr const char* kLastOnly = "what a hit emits replaces the sum so far; it must be added";
constexpr const char* kFirstLost = "what the first hit emits is left out";

Finding pathInEvenRoom(CheckRun& run, double size) {
  Random random(run.seed);
  const EvenRoom room(random, size);
  const glm::dvec3 emission(EvenRoom::kEmission);
  Ray ray;
  const AddCall add = [&](Calls& calls, std::uint32_t m, uvec2 seed) {
    if (m == 0) ray = {room.inside(random), random.direction()};
    calls.add(ray, seed);
  };
  return judgeRadiance(run,
                       {F::kGetRayRadiance, room.mesh.words(), add,
                        room.where() + ", rays from everywhere in it", 512},
                       series(MAX_PATH_LENGTH),
                       {{kOneShort, series(MAX_PATH_LENGTH - 1)},
                        {kOneLong, series(MAX_PATH_LENGTH + 1)},
                        {size < 1.0 ? kLongOffset : kOneHit, series(1)},
                        {kUpdatedFirst, glm::dvec3(EvenRoom::kColour) * series(MAX_PATH_LENGTH)},
                        {kNoTwoPi, series(MAX_PATH_LENGTH, 0.5 / kPiD)},
                        {kNoPi, series(MAX_PATH_LENGTH, kPiD)},
                        {kNoCosine, series(MAX_PATH_LENGTH, 2.0)},
                        {kNoTwo, series(MAX_PATH_LENGTH, 0.5)},
                        {kAssigned, emission + (MAX_PATH_LENGTH - 1.0) * (series(2) - emission)},
                        {kLastOnly, series(MAX_PATH_LENGTH) - series(MAX_PATH_LENGTH - 1)},
                        {kFirstLost, series(MAX_PATH_LENGTH) - emission},
                        {kNotUpdated, static_cast<double>(MAX_PATH_LENGTH) * series(1)}});
}

}  // namespace

// In a small one after a large one, in which no fixed offset shows.
Finding pathInEvenRooms(CheckRun& run) {
  return judgeAll(run, {[](CheckRun& own) { return pathInEvenRoom(own, 100.0); },
                        [](CheckRun& own) { return pathInEvenRoom(own, 3e-6); }});
}

Finding pathBetweenPlates(CheckRun& run) {
  Random random(run.seed);
  const Setting setting(random, 100.0);
  Plate low = setting.plate(setting.at(-1, 0, -1), setting.at(2, 0, 0), setting.at(0, 0, 2), true);
  Plate high = setting.plate(setting.at(-1.2, 1.3, -0.9), setting.at(2.3, 0.3, 0.0),
                             setting.at(0.0, -0.2, 1.9), false);
  low.colour = {0.6, 0.4, 0.3};
  low.emission = {0.7, 1.0, 0.6};
  high.colour = {0.4, 0.7, 0.9};
  high.emission = {0.9, 0.25, 0.8};
  MeshWords mesh;
  mesh.plate(high);
  mesh.plate(low);
  const Point origin(setting.at(0.2, 0.6, -0.3));
  const AddCall add = [&](Calls& calls, std::uint32_t, uvec2 seed) {
    calls.add(origin, -Vector(setting.up()), seed);
  };
  const glm::dvec3 x = setting.at(0.2, 0.0, -0.3);
  const auto path = [&](int hits, const BounceFactor& factor) {
    return betweenPlates(x, low, high, hits, factor);
  };
  const auto constant = [](double factor) { return [factor](double) { return factor; }; };
  const int hits = MAX_PATH_LENGTH;
  std::vector<SuspectedRadiance> suspects{
      {kOneShort, path(hits - 1, diffuseFactor)},
      {kOneLong, path(hits + 1, diffuseFactor)},
      {kOneHit, low.emission},
      {kNoTwoPi, path(hits, [](double c) { return c / kPiD; })},
      {kNoPi, path(hits, [](double c) { return 2.0 * kPiD * c; })},
      {kNoCosine, path(hits, constant(2.0))},
      {kNoCosine, path(hits, constant(1.0))}};
  const glm::dvec3 expected = path(hits, diffuseFactor);
  low.emission *= low.colour;
  high.emission *= high.colour;
  suspects.push_back({kUpdatedFirst, path(hits, diffuseFactor)});
  return judgeRadiance(
      run,
      {F::kGetRayRadiance, mesh.words(), add,
       "a ray that hits one of two plates that face each other, of unequal colours and emissions",
       1024},
      expected, suspects);
}

}  // namespace pathmark::checks
