// Camera rays. The probe's tracePath records those of renderPixel.
#include "checks/calls.h"
#include "checks/channels.h"
#include "checks/film_point.h"
#include "checks/part1_checks.h"
#include "checks/pixel_question.h"
#include "checks/points.h"
#include "diagnosis/probes.h"
#include "worker/pixel_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

Words wordsOf(const SimpleCamera& camera) {
  return Words().add(camera.eye(), camera.topLeft(), camera.pixelRight(), camera.pixelDown(),
                     camera.width(), camera.height());
}

enum Sum : std::size_t { kX, kY, kX2, kY2, kXy, kLength, kOrigin, kInvalid, kSums };

// Which number moves a ray which way is left open: both are uniform within the stratum.
Signature strata(const ProbeRun& run) {
  constexpr std::uint32_t kReplicates = 64, kPoints = 256;
  struct Stratum {
    int k, l, n;
  };
  Signature signature;
  const std::vector<SimpleCamera> cameras = filmCameras();
  for (const std::size_t which : {0u, 1u})
    for (const Stratum& in : {Stratum{0, 0, 1}, {1, 0, 2}, {2, 3, 5}}) {
      const SimpleCamera& camera = cameras[which];
      constexpr int i = 5, j = 2;
      Points points(run.seed, kPoints);
      Calls calls(F::kStratifiedRandomRay, wordsOf(camera));
      for (std::uint32_t r = 0; r < kReplicates; ++r) {
        points.start(r);
        for (std::uint32_t m = 0; m < kPoints; ++m) {
          points.point(m);
          calls.add(i, j, in.k, in.l, in.n, points.pair());
        }
      }
      const Results results = calls.run(run.worker);
      Replicates sums(kReplicates, kSums);
      for (std::size_t call = 0; call < results.count(); ++call) {
        const std::span<double> of = sums.of(static_cast<std::uint32_t>(call / kPoints));
        if (!results.finite(call)) {
          of[kInvalid] += 1.0;
          continue;
        }
        const Vector d = results.vector(call, 3);
        const glm::dvec2 place = filmPoint(camera, d) - glm::dvec2(i, j);
        const glm::dvec2 within = place * double(in.n) - glm::dvec2(in.k, in.l);
        of[kX] += within.x;
        of[kY] += within.y;
        of[kX2] += within.x * within.x;
        of[kY2] += within.y * within.y;
        of[kXy] += within.x * within.y;
        of[kLength] += std::min(glm::length(glm::dvec3(d)), 100.0);
        of[kOrigin] += glm::length(results.vector(call, 0) - camera.eye()) > 0.0f ? 1.0 : 0.0;
      }
      sums.divideBy(kPoints);
      const auto add = [&](const char* what, std::size_t k) {
        // A film point of the far camera is known to a few thousandths.
        sums.add(
            signature,
            fmt::format("{}, k = {}, l = {}, n = {}, camera {}", what, in.k, in.l, in.n, which + 1),
            k, 5.0);
      };
      add("mean of x within the stratum, from 0 to 1", kX);
      add("mean of y within the stratum, from 0 to 1", kY);
      add("mean of x^2 within the stratum", kX2);
      add("mean of y^2 within the stratum", kY2);
      add("mean of x y within the stratum", kXy);
      add("mean length of the direction", kLength);
      add("share of rays that do not begin at the eye", kOrigin);
      add("share of answers that are no numbers", kInvalid);
    }
  return signature;
}

PixelQuestion questionOf(const ProbeRun& run, const SimpleCamera& camera, int rays,
                         std::uint64_t seed) {
  return {.camera = camera, .i = 5, .j = 2, .rays = rays, .seed = run.seed + seed};
}

// What a pixel's rays add up to and how they are started; the order of the strata is left open.
void addCounts(const ProbeRun& run, const SimpleCamera& camera, int rays, Signature& signature) {
  const PixelQuestion question = questionOf(run, camera, rays, 1);
  const RecordedPixel pixel = question.ask(run.worker), again = question.ask(run.worker);
  const auto add = [&](const char* what, double value) {
    signature.add(fmt::format("{}, N = {}", what, rays), value);
  };
  double inOrder = 0.0, jittered = 0.0, same = 0.0;
  std::set<std::int32_t> started;
  std::set<std::pair<int, int>> cells;
  const int n = strataPerSide(rays);
  for (std::size_t m = 0; m < pixel.rays.size(); ++m) {
    const RecordedRay& ray = pixel.rays[m];
    inOrder += ray.startRay == static_cast<int>(m) ? 1.0 : 0.0;
    started.insert(ray.startRay);
    jittered += ray.numbers >= 2 ? 1.0 : 0.0;
    same += m < again.rays.size() && std::ranges::equal(ray.direction, again.rays[m].direction)
                ? 1.0
                : 0.0;
    const glm::dvec2 place = question.placeOf(ray);
    cells.emplace(static_cast<int>(std::floor(place.x * n)),
                  static_cast<int>(std::floor(place.y * n)));
  }
  add("calls of tracePath over N", pixel.counts.traced / double(rays));
  add("calls of startRay over N", pixel.counts.started / double(rays));
  add("share of rays that are started with their number", inOrder / rays);
  add("different numbers for startRay, over N", static_cast<double>(started.size()) / rays);
  add("numbers drawn before startRay, over N", pixel.counts.strayNumbers / double(rays));
  add("share of rays with two random numbers", jittered / rays);
  add("share of rays that are the same again", same / rays);
  for (int c = 0; c < 3; ++c) {
    double right = 0.0;
    for (int m = 0; m < rays; ++m)
      right += double{PixelRecorder::radianceOf(static_cast<std::uint32_t>(m))[c]} / rays;
    add(inChannel("colour over the mean of the rays' radiance", c).c_str(),
        pixel.counts.mean[c] / right);
  }
  add("the same pixel once more, over the first time",
      again.counts.mean[0] / double{pixel.counts.mean[0]});
  if (n * n == rays) add("strata with a ray, over n n", static_cast<double>(cells.size()) / rays);
}

// Places within the pixel, of all rays of many pixels.
void addPlaces(const ProbeRun& run, const SimpleCamera& camera, int rays, Signature& signature) {
  constexpr std::uint32_t kReplicates = 32, kPixels = 8;
  enum : std::size_t { kX, kY, kX2, kY2, kXy, kMiddle, kSums };
  Replicates sums(kReplicates, kSums);
  int n = 1;
  while ((n + 1) * (n + 1) <= rays) ++n;
  double inPixel = 0.0, swapped = 0.0, count = 0.0;
  for (std::uint32_t r = 0; r < kReplicates; ++r)
    for (std::uint32_t k = 0; k < kPixels; ++k) {
      const RecordedPixel pixel =
          questionOf(run, camera, rays, 100 + r * kPixels + k).ask(run.worker);
      const auto traced = static_cast<double>(pixel.rays.size()) * kPixels;
      for (const RecordedRay& ray : pixel.rays) {
        const glm::dvec2 film =
            filmPoint(camera, Vector(ray.direction[0], ray.direction[1], ray.direction[2]));
        const auto isIn = [&](double i, double j) {
          return film.x >= i - 1e-3 && film.x <= i + 1.001 && film.y >= j - 1e-3 &&
                 film.y <= j + 1.001;
        };
        inPixel += isIn(5, 2) ? 1.0 : 0.0;
        swapped += isIn(2, 5) ? 1.0 : 0.0;
        count += 1.0;
        const glm::dvec2 at = film - glm::floor(film);
        const glm::dvec2 within = at * double(n) - glm::floor(at * double(n));
        const std::span<double> of = sums.of(r);
        of[kX] += at.x / traced;
        of[kY] += at.y / traced;
        of[kX2] += at.x * at.x / traced;
        of[kY2] += at.y * at.y / traced;
        of[kXy] += at.x * at.y / traced;
        of[kMiddle] += glm::distance(within, glm::dvec2(0.5)) / traced;
      }
    }
  const auto add = [&](const char* what, std::size_t k) {
    sums.add(signature, fmt::format("{}, N = {}", what, rays), k, 2.0);
  };
  add("mean of x within the pixel", kX);
  add("mean of y within the pixel", kY);
  add("mean of x^2 within the pixel", kX2);
  add("mean of y^2 within the pixel", kY2);
  add("mean of x y within the pixel", kXy);
  add("mean distance from the middle of the stratum", kMiddle);
  signature.add(fmt::format("share of rays through the pixel, N = {}", rays), inPixel / count);
  signature.add(fmt::format("share of rays through column j and row i, N = {}", rays),
                swapped / count);
}

Signature pixels(const ProbeRun& run) {
  Signature signature;
  const SimpleCamera camera = filmCameras()[0];
  for (const int rays : {1, 4, 7, 16, 24}) addCounts(run, camera, rays, signature);
  for (const int rays : {1, 7, 24}) addPlaces(run, camera, rays, signature);
  return signature;
}

}  // namespace

Signature probePart1(const ProbeRun& run) {
  return run.function == F::kRenderPixel ? pixels(run) : strata(run);
}

}  // namespace pathmark::diagnosis
