// What is asked of part 1: the ray through a stratum of a pixel.
#include "checks/calls.h"
#include "checks/exact.h"
#include "checks/film_point.h"
#include "checks/part1_checks.h"
#include "checks/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

struct RayInput {
  int i, j, k, l, n;
  float s, t;

  // Where on the film, in pixels.
  double x() const { return i + (k + double{s}) / n; }
  double y() const { return j + (l + double{t}) / n; }
  std::string text() const {
    return fmt::format("i = {}, j = {}, k = {}, l = {}, n = {}, s = {:.8g}, t = {:.8g}", i, j, k, l,
                       n, s, t);
  }
};

// Plain ones first.
std::vector<RayInput> rayInputs(const SimpleCamera& camera, Random& random) {
  std::vector<RayInput> inputs{{2, 3, 0, 0, 1, 0.5f, 0.5f},
                               {2, 3, 0, 0, 1, 0.25f, 0.75f},
                               {2, 3, 1, 0, 2, 0.5f, 0.5f},
                               {2, 3, 0, 1, 2, 0.5f, 0.25f}};
  const auto add = [&](int n, float s, float t) {
    const int i = random.below(camera.width()), j = random.below(camera.height()),
              k = random.below(n);
    inputs.push_back({i, j, k, random.below(n), n, s, t});
  };
  for (const int n : {1, 2, 3, 7, 16, 32}) {
    for (const float s : kEdgeNumbers)
      for (const float t : kEdgeNumbers) add(n, s, t);
    for (int trial = 0; trial < 100; ++trial) {
      const float s = random.uniform();
      add(n, s, random.uniform());
    }
  }
  return inputs;
}

glm::dvec3 towards(const SimpleCamera& camera, const RayInput& in) {
  return glm::dvec3(camera.topLeft()) + in.x() * glm::dvec3(camera.pixelRight()) +
         in.y() * glm::dvec3(camera.pixelDown());
}

Words cameraWords(const SimpleCamera& camera) {
  return Words().add(camera.eye(), camera.topLeft(), camera.pixelRight(), camera.pixelDown(),
                     camera.width(), camera.height());
}

// All inputs in order, and then again from the last to the first.
Results ask(CheckRun& run, const SimpleCamera& camera, const std::vector<RayInput>& inputs) {
  Calls calls(F::kStratifiedRandomRay, cameraWords(camera));
  const auto add = [&](const RayInput& in) { calls.add(in.i, in.j, in.k, in.l, in.n, in.s, in.t); };
  std::for_each(inputs.begin(), inputs.end(), add);
  std::for_each(inputs.rbegin(), inputs.rend(), add);
  return calls.run(run.worker);
}

Finding raysAreValid(CheckRun& run) {
  Random random(run.seed);
  Exact exact{"the direction is not normalised"};
  for (const SimpleCamera& camera : filmCameras()) {
    const std::vector<RayInput> inputs = rayInputs(camera, random);
    const Results results = ask(run, camera, inputs);
    exact.count(results.count());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto where = [&] { return fmt::format("{}; {}", inputs[i].text(), text(camera)); };
      const Point origin = results.vector(i, 0);
      const Vector d = results.vector(i, 3);
      exact.holds(
          results.finite(i), "finite numbers",
          [&] { return fmt::format("origin {}, direction {}", text(origin), text(d)); }, where);
      exact.holds(
          origin == camera.eye(), fmt::format("origin {}, the eye", text(camera.eye())),
          [&] { return fmt::format("origin {}", text(origin)); }, where);
      const glm::dvec3 there = towards(camera, inputs[i]);
      exact.value("length of the direction", glm::length(glm::dvec3(d)), 1.0, 8.0 * 0x1p-24, where,
                  {glm::length(there)});
      exact.holds(
          glm::dot(there, glm::dvec3(d)) > 0.0, "a direction to the film, not away from it",
          [&] { return fmt::format("direction {}", text(d)); }, where);
      const std::size_t again = 2 * inputs.size() - 1 - i;
      exact.holds(
          results.same(i, again), "the same ray again for the same numbers",
          [&] {
            return fmt::format("direction {} and then {}", text(d), text(results.vector(again, 3)));
          },
          where);
    }
  }
  return exact.finding();
}

// Whether all errors are no larger than the rounding of points at the eye's coordinates, and those
// of the directions alone are not enough.
class EyeRounds {
 public:
  void see(const glm::dvec2& off, double allowed, const SimpleCamera& camera, const RayInput& in) {
    const double error = std::max(std::abs(off.x), std::abs(off.y));
    if (!(error > allowed)) return;
    seen_ = true;
    const glm::dvec3 eye(camera.eye());
    const double coordinates =
        8.0 * 0x1p-24 * (glm::length(eye) + glm::length(towards(camera, in)));
    const double pixel = std::min(glm::length(glm::dvec3(camera.pixelRight())),
                                  glm::length(glm::dvec3(camera.pixelDown())));
    possible_ = possible_ && error <= allowed + coordinates / pixel;
  }
  bool explains() const { return seen_ && possible_; }

 private:
  bool seen_ = false, possible_ = true;
};

Finding filmPointIsRight(CheckRun& run) {
  Random random(run.seed);
  EyeRounds eyeRounds;
  Exact exact{
      "half a pixel is taken off: the pixel begins at (i, j), and the ray goes through the middle "
      "of its range by itself",
      "half a pixel is added: the ray goes through the middle of the pixel's range by itself",
      "k / n and l / n are divided as integers, which gives 0",
      "k / n is divided as integers, which gives 0",
      "l / n is divided as integers, which gives 0",
      "k, l and n are ignored: the ray goes anywhere in the pixel",
      "i and j are swapped: i is the column, counted along pixelRight",
      "x and y are swapped: i, k and s count along pixelRight, j, l and t along pixelDown",
      "k and l are swapped: k is the column of the stratum",
      "s is used for both axes",
      "t is used for both axes",
      "s and t are swapped",
      "s and t are not used: the ray goes through the middle of its stratum",
      "s and t are not used: the ray goes through the corner of its stratum",
      "s and t are not divided by n: the jitter leaves the stratum",
      "s and t are divided by n twice: the jitter does not fill the stratum",
      "the jitter fills the middle half of the stratum only",
      "eye() is added to the direction: topLeft is a vector from the eye already",
      "eye() is subtracted from the direction: topLeft is a vector from the eye already"};
  for (const SimpleCamera& camera : filmCameras()) {
    const std::vector<RayInput> inputs = rayInputs(camera, random);
    const Results results = ask(run, camera, inputs);
    exact.count(results.count());
    for (std::size_t m = 0; m < inputs.size(); ++m) {
      const RayInput& in = inputs[m];
      const auto where = [&] { return fmt::format("{}; {}", in.text(), text(camera)); };
      const glm::dvec2 film = filmPoint(camera, results.vector(m, 3));
      const double x = in.x(), y = in.y(), n = in.n, s = in.s, t = in.t, i = in.i, j = in.j,
                   k = in.k, l = in.l, allowed = filmTolerance(camera, x, y);
      const glm::dvec3 there = towards(camera, in), eye(camera.eye());
      const glm::dvec2 added = filmPoint(camera, Vector(glm::normalize(there + eye))),
                       taken = filmPoint(camera, Vector(glm::normalize(there - eye)));
      eyeRounds.see(film - glm::dvec2(x, y), allowed, camera, in);
      exact.value(
          "film x = i + (k + s)/n", film.x, x, allowed, where,
          {x - 0.5, x + 0.5, i + s / n, i + s / n, x, i + s, j + (k + s) / n, y, i + (l + s) / n, x,
           i + (k + t) / n, i + (k + t) / n, i + (k + 0.5) / n, i + k / n, i + k / n + s,
           i + (k + s / n) / n, i + (k + 0.25 + 0.5 * s) / n, added.x, taken.x});
      exact.value(
          "film y = j + (l + t)/n", film.y, y, allowed, where,
          {y - 0.5, y + 0.5, j + t / n, y, j + t / n, j + t, i + (l + t) / n, x, j + (k + t) / n,
           j + (l + s) / n, y, j + (l + s) / n, j + (l + 0.5) / n, j + l / n, j + l / n + t,
           j + (l + t / n) / n, j + (l + 0.25 + 0.5 * t) / n, added.y, taken.y});
    }
  }
  Finding finding = exact.finding();
  if (exact.failed() && eyeRounds.explains())
    finding.cause =
        "eye() is added and taken off again, and rounds the direction: topLeft, pixelRight and "
        "pixelDown are vectors from the eye already";
  return finding;
}

}  // namespace

std::vector<Check> part1RayChecks() {
  return {
      {"film-point", F::kStratifiedRandomRay,
       "the ray goes through the film point (i + (k + s)/n, j + (l + t)/n), to 8 roundings", 0.0,
       filmPointIsRight},
      {"valid", F::kStratifiedRandomRay,
       "the ray starts at the eye, its direction is a unit vector towards the film, and the same "
       "again for the same numbers",
       0.0, raysAreValid},
  };
}

}  // namespace pathmark::checks
