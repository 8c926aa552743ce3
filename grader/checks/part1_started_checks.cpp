// What is asked of part 1: how the rays of a pixel are started, and the numbers that they take.
#include "checks/exact.h"
#include "checks/part1_pixels.h"

#include <fmt/format.h>

namespace pathmark::checks {

namespace {

std::string times(std::uint32_t n) { return n == 1 ? "once" : fmt::format("{} times", n); }

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

}  // namespace

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

}  // namespace pathmark::checks
