// What is asked of part 1: the rays of a pixel, as a tracePath sees them that records them.
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/film_point.h"
#include "checks/means.h"
#include "checks/part1_checks.h"
#include "checks/pixel_question.h"
#include "checks/points.h"
#include "checks/strata_matching.h"
#include "worker/pixel_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr std::array kRayCounts{1, 4, 9, 16, 64, 2, 3, 5, 8, 17, 24, 63, 255, 256, 1000};

bool isInPixel(const glm::dvec2& place, double tolerance) {
  return place.x >= -tolerance && place.y >= -tolerance && place.x <= 1.0 + tolerance &&
         place.y <= 1.0 + tolerance;
}

PixelQuestion somePixel(std::size_t camera, int rays, std::uint64_t seed) {
  return {.camera = filmCameras()[camera], .i = 5, .j = 2, .rays = rays, .seed = seed};
}

std::string times(std::uint32_t n) { return n == 1 ? "once" : fmt::format("{} times", n); }

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

constexpr const char* kRoundedUp = "n is rounded up: it is the largest n with n * n <= N";

// Of rays that are not started as they should be.
std::string likelyCause(const RecordedPixel& pixel, int rays) {
  const auto all = [&](const auto& holds) {
    for (std::size_t m = 0; m < pixel.rays.size(); ++m)
      if (!holds(pixel.rays[m], static_cast<int>(m))) return false;
    return !pixel.rays.empty();
  };
  const RecordPixelReply& counts = pixel.counts;
  const int n = strataPerSide(rays);
  if (counts.traced != static_cast<std::uint32_t>(rays))
    return counts.traced == static_cast<std::uint32_t>(n * n)
               ? "the N - n * n remaining rays are missing"
           : n * n < rays && counts.traced == static_cast<std::uint32_t>((n + 1) * (n + 1))
               ? kRoundedUp
               : "";
  if (counts.started == 0) return "startRay is never called";
  if (all([](const RecordedRay& r, int m) { return r.startRay == m + 1; }))
    return "the rays are counted from 1; the first one is m = 0";
  if (rays > 1 && counts.started == 1)
    return "startRay is called once for the pixel; it belongs before every ray";
  if (counts.strayNumbers > 0 && all([](const RecordedRay& r, int) { return r.numbers < 2; }))
    return "s and t are taken from the sampler before startRay is called for the ray";
  if (all([](const RecordedRay& r, int) { return r.numbers == 0; }))
    return "the rays are not jittered";
  if (all([](const RecordedRay& r, int) { return r.numbers == 1; }))
    return "one number is used for both s and t";
  return "";
}

// What startRay is given, in the pixels so far: of a single one more than one mistake may be true.
struct StartedWith {
  bool sameNumber = true, again = true;

  void see(const RecordedPixel& pixel, int rays) {
    const int strata = strataPerSide(rays) * strataPerSide(rays);
    for (std::size_t m = 0; m < pixel.rays.size(); ++m) {
      const int number = pixel.rays[m].startRay;
      if (number != pixel.rays[0].startRay) sameNumber = false;
      if (number != static_cast<int>(m) % strata) again = false;
    }
  }

  std::string cause() const {
    if (sameNumber)
      return "startRay is called with the same number for every ray, so that all of them get the "
             "same random numbers";
    if (again)
      return "startRay begins again at 0 for the remaining rays, so that they get the random "
             "numbers of the first ones once more";
    return "";
  }
};

Finding raysAreStartedInOrder(CheckRun& run) {
  Exact exact;
  StartedWith startedWith;
  bool calledForEach = true;
  std::string cause;
  for (const int rays : kRayCounts) {
    const PixelQuestion question = somePixel(0, rays, run.seed);
    const RecordedPixel pixel = question.ask(run.worker);
    exact.count(1);
    exact.holds(
        pixel.counts.traced == static_cast<std::uint32_t>(rays),
        fmt::format("tracePath called {}", times(static_cast<std::uint32_t>(rays))),
        [&] { return fmt::format("tracePath called {}", times(pixel.counts.traced)); },
        [&] { return question.text(); });
    for (std::size_t m = 0; m < pixel.rays.size(); ++m) {
      const RecordedRay& ray = pixel.rays[m];
      const auto where = [&] { return fmt::format("{}, ray m = {}", question.text(), m); };
      exact.holds(
          ray.startedBefore == m + 1 && ray.startRay == static_cast<int>(m),
          fmt::format("startRay({}) before the ray, once", m),
          [&] {
            return ray.startedBefore == 0
                       ? std::string("startRay has not been called")
                       : fmt::format("startRay({}); it was called {} for {} rays so far",
                                     ray.startRay, times(ray.startedBefore), m + 1);
          },
          where);
      exact.holds(
          ray.numbers >= 2, "two numbers taken from the sampler after startRay, for s and t",
          [&] { return ray.numbers == 0 ? "none" : "one"; }, where);
    }
    calledForEach = calledForEach && pixel.counts.traced == static_cast<std::uint32_t>(rays) &&
                    pixel.counts.started == pixel.counts.traced;
    startedWith.see(pixel, rays);
    if (exact.failed() && cause.empty()) cause = likelyCause(pixel, rays);
  }
  Finding finding = exact.finding();
  if (!finding.passed()) finding.cause = cause;
  if (!finding.passed() && calledForEach && !startedWith.cause().empty())
    finding.cause = startedWith.cause();
  return finding;
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

// Whether so many rays go through the same point of their stratum, from (0, 0) to (1, 1).
bool goThrough(double point, const PixelQuestion& question, const RecordedPixel& pixel, int n) {
  const auto isThere = [&](const RecordedRay& ray) {
    const glm::dvec2 off = question.placeOf(ray) * double(n) - point;
    const glm::dvec2 fromNearest = glm::abs(off - glm::round(off));
    return std::max(fromNearest.x, fromNearest.y) <= question.tolerance() * n;
  };
  return std::ranges::count_if(pixel.rays, isThere) >= n * n;
}

// With random numbers, of which no ray would be at such a point.
std::string causeOfUnevenRays(const PixelQuestion& question, const RecordedPixel& pixel, int n) {
  for (const auto& [point, name] : {std::pair{0.5, "middle"}, {0.0, "corner"}})
    if (goThrough(point, question, pixel, n))
      return fmt::format(
          "no jitter: each ray of the strata goes through the {} of its stratum; s and t must be "
          "random numbers of the sampler",
          name);
  return {};
}

// Places within the strata, and within the pixel: both are uniform, for rays of the strata and for
// the remaining ones alike.
Finding raysAreSpreadEvenly(CheckRun& run, const int rays) {
  constexpr int kTogether = 512, kSide = 4;
  const int strata = strataPerSide(rays), pixels = kTogether / rays;
  const auto momentsOf = [](const glm::dvec2& p) {
    return std::array{p.x, p.y, p.x * p.x, p.y * p.y, p.x * p.y};
  };
  std::vector<Mean> means;
  for (const char* of : {"stratum", "pixel"}) {
    const double expected[] = {0.5, 0.5, 1.0 / 3.0, 1.0 / 3.0, 0.25};
    const char* const names[] = {"x", "y", "x^2", "y^2", "x y"};
    for (std::size_t k = 0; k < 5; ++k)
      means.push_back(
          {fmt::format("mean of {} within its {}, from 0 to 1", names[k], of), expected[k]});
  }
  const std::size_t cells = means.size();
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      means.push_back(
          {fmt::format("share of the rays in column {}, row {} of {} x {} cells of their "
                       "stratum",
                       column, row, kSide, kSide),
           1.0 / (kSide * kSide)});
  // Means over the pixel where the remaining rays are uniform in [0,x] x [0,y].
  const auto remainingIn = [&](double x, double y) {
    const double share = 1.0 - double(strata * strata) / rays;
    const double of[] = {0.5 * x, 0.5 * y, x * x / 3.0, y * y / 3.0, 0.25 * x * y};
    std::vector<double> result;
    for (const Mean& mean : means) result.push_back(mean.expected);
    for (std::size_t k = 0; k < 5; ++k) result[5 + k] += share * (of[k] - result[5 + k]);
    return result;
  };
  // And where one number u gives both the stratum, floor(u n), and the place in it.
  const auto remainingUsedTwice = [&] {
    constexpr int kSteps = 4096;
    double x = 0.0, x2 = 0.0;
    for (int k = 0; k < kSteps; ++k) {
      const double u = (k + 0.5) / kSteps, at = (std::floor(u * strata) + u) / strata;
      x += at / kSteps;
      x2 += at * at / kSteps;
    }
    const double share = 1.0 - double(strata * strata) / rays;
    const double of[] = {x, x, x2, x2, x * x};
    std::vector<double> result;
    for (const Mean& mean : means) result.push_back(mean.expected);
    for (std::size_t k = 0; k < 5; ++k) result[5 + k] += share * (of[k] - result[5 + k]);
    return result;
  };
  constexpr const char* kInStrata =
      "the remaining rays go through the first strata once more, and not anywhere in the pixel";
  const double few = 2.0 / strata, one = 1.0 / strata;
  std::vector<Suspicion> suspicions{{kInStrata, remainingIn(one, one)},
                                    {"a random number is used twice for a remaining ray: for its "
                                     "stratum, and for the place in it",
                                     remainingUsedTwice()}};
  if (few < 1.0) {
    suspicions.push_back({kInStrata, remainingIn(1.0, few)});
    suspicions.push_back({kInStrata, remainingIn(few, 1.0)});
  }
  std::uint64_t calls = 0;
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    for (std::uint32_t r = 0; r < count; ++r) {
      const std::span<double> sums = values.subspan(r * means.size(), means.size());
      std::ranges::fill(sums, 0.0);
      for (int pixel = 0; pixel < pixels; ++pixel) {
        const PixelQuestion question =
            somePixel(1, rays,
                      run.seed + (std::uint64_t{first} + r) * static_cast<std::uint64_t>(pixels) +
                          static_cast<std::uint64_t>(pixel));
        const RecordedPixel recorded = question.ask(run.worker);
        ++calls;
        const double share =
            1.0 / (pixels * std::max<double>(1.0, static_cast<double>(recorded.rays.size())));
        for (const RecordedRay& ray : recorded.rays) {
          const glm::dvec2 place = question.placeOf(ray);
          if (!isInPixel(place, question.tolerance())) continue;
          const glm::dvec2 inPixel = glm::clamp(place, 0.0, 1.0),
                           inStratum = glm::fract(inPixel * double(strata));
          for (std::size_t k = 0; k < 5; ++k) {
            sums[k] += share * momentsOf(inStratum)[k];
            sums[5 + k] += share * momentsOf(inPixel)[k];
          }
          const glm::dvec2 cell = glm::floor(inStratum * double{kSide});
          sums[cells + static_cast<std::size_t>(cell.y * kSide + cell.x)] += share;
        }
      }
    }
  };
  Finding finding =
      judgeMeans(run, means, measure,
                 fmt::format("{} rays, {} of them in strata", rays, strata * strata), suspicions);
  if (!finding.passed() && finding.cause.empty()) {
    const PixelQuestion question = somePixel(1, rays, run.seed);
    finding.cause = causeOfUnevenRays(question, question.ask(run.worker), strata);
  }
  finding.calls = calls;
  return finding;
}

// Where n is 1 as well, a single ray included: over many pixels every quarter of x and of y is hit.
// That right code leaves one out has a probability below 1e-30.
Finding singleRaysAreRandom(CheckRun& run) {
  constexpr int kPixels = 256, kQuarters = 4;
  Exact exact;
  std::string cause;
  for (const int rays : {1, 2, 3}) {
    std::array<std::array<int, kQuarters>, 2> hits{};
    std::string middle =
        "no jitter: where n is 1, s and t must be random numbers of the sampler too";
    for (int pixel = 0; pixel < kPixels; ++pixel) {
      const PixelQuestion question =
          somePixel(1, rays, run.seed + static_cast<std::uint64_t>(pixel));
      const RecordedPixel recorded = question.ask(run.worker);
      if (!goThrough(0.5, question, recorded, 1)) middle.clear();
      for (const RecordedRay& ray : recorded.rays) {
        const glm::dvec2 place = question.placeOf(ray);
        for (std::size_t axis = 0; axis < 2; ++axis) {
          const double quarter = std::floor(place[static_cast<int>(axis)] * kQuarters);
          ++hits[axis][static_cast<std::size_t>(std::clamp(quarter, 0.0, kQuarters - 1.0))];
        }
      }
    }
    exact.count(kPixels);
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t quarter = 0; quarter < kQuarters; ++quarter)
        exact.holds(
            hits[axis][quarter] > 0,
            fmt::format("rays in each quarter of {}, so that the mean is that of the whole pixel",
                        axis == 0 ? "x" : "y"),
            [&] { return fmt::format("none in quarter {}", quarter + 1); },
            [&] {
              return fmt::format("{} pixels of {}", kPixels,
                                 rays == 1 ? "1 ray each" : fmt::format("{} rays each", rays));
            });
    if (exact.failed() && cause.empty()) cause = middle;
  }
  Finding finding = exact.finding();
  if (!finding.passed()) finding.cause = cause;
  return finding;
}

// Most of 255 rays are in strata; of 8 half of them are, and the others weigh as much.
Finding raysAreEven(CheckRun& run) {
  Finding worst;
  std::uint64_t calls = 0;
  const auto take = [&](const Finding& finding) {
    calls += finding.calls;
    if (worst.passed() && (!finding.passed() || finding.shown > worst.shown)) worst = finding;
  };
  for (const int rays : {255, 8})
    if (worst.passed()) take(raysAreSpreadEvenly(run, rays));
  if (worst.passed()) take(singleRaysAreRandom(run));
  worst.calls = calls;
  return worst;
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
       "random "
       "numbers taken after it",
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
