// What is asked of part 1: where in their strata, and in the pixel, rays are.
#include "checks/exact.h"
#include "checks/means.h"
#include "checks/part1_pixels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pathmark::checks {

namespace {

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

}  // namespace

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

}  // namespace pathmark::checks
