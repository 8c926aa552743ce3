// What is asked of part 1: the rays of a pixel, as a tracePath sees them that records them.
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/part1_pixels.h"
#include "checks/points.h"
#include "checks/strata_matching.h"
#include "worker/pixel_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

// What is kept between calls (a sum, a generator) shows when other pixels come between.
Finding pixelsAreRepeatable(CheckRun& run) {
  std::vector<PixelQuestion> questions;
  for (std::size_t camera = 0; camera < filmCameras().size(); ++camera)
    for (const int rays : {1, 4, 17}) questions.push_back(somePixel(camera, rays, run.seed));
  std::vector<RecordedPixel> first, second;
  for (const PixelQuestion& q : questions) first.push_back(q.ask(run.worker));
  for (std::size_t k = questions.size(); k-- > 0;) second.push_back(questions[k].ask(run.worker));
  std::reverse(second.begin(), second.end());
  Exact exact;
  exact.count(first.size() + second.size());
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const auto where = [&] { return questions[k].text(); };
    const RecordedPixel &a = first[k], &b = second[k];
    const auto colour = [](const RecordedPixel& p) {
      return text(vec3(p.counts.mean[0], p.counts.mean[1], p.counts.mean[2]));
    };
    exact.holds(
        std::ranges::equal(a.counts.mean, b.counts.mean),
        "the same colour when the same pixel is asked for again",
        [&] {
          return fmt::format(
              "{} and then {}: something is kept between the calls (a static or global "
              "variable, or one without a first value?)",
              colour(a), colour(b));
        },
        where);
    const auto sameRay = [](const RecordedRay& x, const RecordedRay& y) {
      return std::ranges::equal(x.direction, y.direction);
    };
    exact.holds(
        std::ranges::equal(a.rays, b.rays, sameRay),
        "the same rays when the same pixel is asked for again",
        [] { return "other rays: random numbers must come from the sampler that is handed over"; },
        where);
  }
  return exact.finding();
}

// All numbers alike, at the ends and between them; and random ones.
std::vector<PixelQuestion> strataQuestions(std::uint64_t seed) {
  std::vector<PixelQuestion> questions;
  Random random(seed);
  for (std::size_t camera = 0; camera < filmCameras().size(); ++camera)
    for (const int rays : kRayCounts) {
      PixelQuestion q = somePixel(camera, rays, seed + questions.size());
      q.i = random.below(q.camera.width());
      q.j = random.below(q.camera.height());
      questions.push_back(q);
      q.numbers = RecordedNumbers::kConstant;
      for (const double constant : {0.5, random.between(0.01, 0.99), 0.0, 0x1p-24, 1.0 - 0x1p-24}) {
        q.constant = static_cast<float>(constant);
        questions.push_back(q);
      }
    }
  return questions;
}

// The one that a ray goes through; kSwapped: that in column j and row i.
enum class Pixel { kRight, kSwapped, kOther };

std::string causeOfEmptyStrata(const PixelQuestion& question,
                               const std::vector<glm::dvec2>& places) {
  const bool onePlace = std::ranges::all_of(places, [&](const glm::dvec2& place) {
    return glm::distance(place, places.front()) <= question.tolerance();
  });
  if (!onePlace) return "";
  return question.numbers == RecordedNumbers::kRandom
             ? "a single ray is made, and traced again and again"
             : "every ray is made with the same k, l and n";
}

// Whether each ray has a stratum of its own where n is larger by 1 than it must be.
bool fitsRoundedUp(const std::vector<glm::dvec2>& places, int n) {
  std::set<std::pair<int, int>> strata;
  for (const glm::dvec2& place : places) {
    const glm::ivec2 stratum(glm::floor(place * double(n + 1)));
    strata.emplace(stratum.x, stratum.y);
  }
  return strata.size() == places.size();
}

// The rays come from the coursework's StratifiedRandomRay, which has been found right.
Finding strataAreHit(CheckRun& run) {
  Exact exact{"i and j are swapped: i is the column, j is the row"};
  std::string cause;
  bool roundedUp = true;
  for (const PixelQuestion& question : strataQuestions(run.seed)) {
    const RecordedPixel pixel = question.ask(run.worker);
    exact.count(1);
    const double tolerance = question.tolerance();
    const glm::dvec2 swap(question.j - question.i, question.i - question.j);
    std::vector<glm::dvec2> places;
    for (const RecordedRay& ray : pixel.rays) {
      const glm::dvec2 place = places.emplace_back(question.placeOf(ray));
      const Pixel pixelHit = isInPixel(place, tolerance)          ? Pixel::kRight
                             : isInPixel(place - swap, tolerance) ? Pixel::kSwapped
                                                                  : Pixel::kOther;
      exact.answer(
          pixelHit, Pixel::kRight,
          fmt::format("a film point of the pixel: x from {} to {}, y from {} to {}", question.i,
                      question.i + 1, question.j, question.j + 1),
          [&] {
            return fmt::format("x = {:.6g}, y = {:.6g}", place.x + question.i,
                               place.y + question.j);
          },
          [&] { return question.text(); },
          {question.i == question.j ? Pixel::kRight : Pixel::kSwapped});
    }
    const bool allInside = std::ranges::all_of(
        places, [&](const glm::dvec2& place) { return isInPixel(place, tolerance); });
    if (!allInside) continue;
    const int n = strataPerSide(question.rays);
    StrataMatching matching(places, n, tolerance);
    const auto empty = matching.emptyStratum();
    exact.answer(
        !empty, true, fmt::format("a ray of its own in each of the {0} x {0} strata", n),
        [&] {
          return fmt::format("no ray for the stratum k = {}, l = {}",
                             *empty % static_cast<std::size_t>(n),
                             *empty / static_cast<std::size_t>(n));
        },
        [&] { return question.text(); }, {true});
    if (empty && cause.empty()) cause = causeOfEmptyStrata(question, places);
    if (question.numbers != RecordedNumbers::kRandom) continue;
    roundedUp = roundedUp && (n * n == question.rays ? !empty : fitsRoundedUp(places, n));
  }
  Finding finding = exact.finding();
  if (!finding.passed() && finding.cause.empty()) finding.cause = roundedUp ? kRoundedUp : cause;
  return finding;
}

// By the recorder every ray has a radiance of its own.
Finding meanIsOfAllRays(CheckRun& run) {
  Exact exact{"the sum is divided by n * n, not by N",
              "the sum is not divided by the number of rays",
              "the sum is divided by N + 1",
              "the last ray is left out",
              "the first ray is left out",
              "only the n * n rays of the strata are added",
              "the radiance of a ray is clamped to 1: what is too bright for the screen is not too "
              "bright for the mean",
              "the radiance of a ray replaces the sum so far; it must be added",
              "the colour is that of the last ray"};
  for (const int rays : kRayCounts) {
    const PixelQuestion question = somePixel(0, rays, run.seed);
    const RecordedPixel pixel = question.ask(run.worker);
    exact.count(1);
    const int strata = strataPerSide(rays) * strataPerSide(rays);
    glm::dvec3 sum(0.0), ofStrata(0.0), clamped(0.0);
    for (int m = 0; m < rays; ++m) {
      const glm::dvec3 radiance(PixelRecorder::radianceOf(static_cast<std::uint32_t>(m)));
      sum += radiance;
      if (m < strata) ofStrata += radiance;
      clamped += glm::min(radiance, 1.0);
    }
    const glm::dvec3 first(PixelRecorder::radianceOf(0)),
        last(PixelRecorder::radianceOf(static_cast<std::uint32_t>(rays - 1)));
    for (int c = 0; c < 3; ++c) {
      const double n = rays, mean = sum[c] / n;
      exact.value(inChannel("mean", c), pixel.counts.mean[c], mean, relativeTolerance() * mean,
                  [&] {
                    return fmt::format("{}, whose radiances are {}, {}, ...", question.text(),
                                       text(PixelRecorder::radianceOf(0)),
                                       text(PixelRecorder::radianceOf(1)));
                  },
                  {sum[c] / strata, sum[c], sum[c] / (n + 1.0), (sum[c] - last[c]) / n,
                   (sum[c] - first[c]) / n, ofStrata[c] / n, clamped[c] / n, last[c] / n, last[c]});
    }
  }
  return exact.finding();
}

}  // namespace

std::vector<Check> part1PixelChecks() {
  return {
      {"again",
       F::kRenderPixel,
       "the same pixel with the same random numbers has the same colour",
       0.0,
       pixelsAreRepeatable,
       {F::kStratifiedRandomRay}},
      {"rays",
       F::kRenderPixel,
       "exactly N rays are traced, with startRay(m) before the m-th, m = 0 to N - 1, and two "
       "random numbers taken after it",
       0.0,
       raysAreStartedInOrder,
       {F::kStratifiedRandomRay}},
      {"strata",
       F::kRenderPixel,
       "each of the n x n strata, n * n <= N, gets a ray of its own, and all rays go through the "
       "pixel",
       0.0,
       strataAreHit,
       {F::kStratifiedRandomRay}},
      {"mean",
       F::kRenderPixel,
       "the colour is the mean of the radiance of all N rays",
       0.0,
       meanIsOfAllRays,
       {F::kStratifiedRandomRay}},
      {"even",
       F::kRenderPixel,
       "rays are uniform within their strata, and those that remain within the pixel",
       0.01,
       raysAreEven,
       {F::kStratifiedRandomRay}},
  };
}

}  // namespace pathmark::checks
