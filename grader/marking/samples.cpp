#include "marking/samples.h"

#include "checks/calls.h"
#include "checks/double_frame.h"
#include "checks/outline.h"
#include "checks/points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace pathmark::marking {

namespace {

using checks::Calls;
using checks::DoubleFrame;
using checks::Outline;
using checks::Results;
using checks::Words;
using F = CourseworkFunction;
using record::SampleDomain;

constexpr std::uint32_t kShown = 1024;    // samples in the plot; a power of two
constexpr std::uint32_t kCounted = 8192;  // in the histograms
constexpr std::size_t kBins = 16;

struct Numbers {
  vec2 st;
  float u = 0.0f;
};

// A sampling function with inputs that show it. Places are in the coordinates of SampleRecord.
struct SampleCase {
  F function;
  SampleDomain domain;
  std::string inputs;
  Words object;
  std::function<void(Calls&, const Numbers&)> add;
  std::function<glm::dvec3(const vec3& answer)> place;
};

struct Axis {
  std::string name;
  double low, high;
  std::function<double(const glm::dvec3&)> of;
};

std::vector<Axis> axesOf(SampleDomain domain) {
  if (domain == SampleDomain::kPlane)
    return {{"x", 0.0, 1.0, [](const glm::dvec3& p) { return p.x; }},
            {"z", 0.0, 1.0, [](const glm::dvec3& p) { return p.z; }}};
  return {{"cos(theta)", domain == SampleDomain::kSphere ? -1.0 : 0.0, 1.0,
           [](const glm::dvec3& d) { return d.y; }},
          {"azimuth / 360 degrees", 0.0, 1.0, [](const glm::dvec3& d) {
             const double turn = std::atan2(d.z, d.x) / (2.0 * std::numbers::pi);
             return turn < 0.0 ? turn + 1.0 : turn;
           }}};
}

// With the normal to the record's y.
std::function<glm::dvec3(const vec3&)> seenFrom(const Vector& normal) {
  const DoubleFrame frame{glm::dvec3(normal)};
  return [frame](const vec3& answer) { return frame.local(glm::dvec3(answer)); };
}

SampleCase polygonCase(F function, const std::string& inputs, std::vector<Point> vertices) {
  Point low = vertices.front(), high = low;
  for (const Point& p : vertices) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {function,
          SampleDomain::kPlane,
          inputs,
          Outline(std::move(vertices)).words(),
          [](Calls& calls, const Numbers& x) { calls.add(x.st); },
          [low, high](const vec3& p) {
            return glm::dvec3(double{p.x - low.x} / double{high.x - low.x}, 0.0,
                              double{p.z - low.z} / double{high.z - low.z});
          }};
}

// The outlines lie in y = 0 with their fronts up.
std::vector<SampleCase> casesOfLights() {
  const Point centre(0.0f, 2.0f, 0.0f), from(0.0f);
  return {
      polygonCase(F::kTriangularSampling, "a triangle", {{0, 0, 0}, {0, 0, 2}, {3, 0, 1}}),
      polygonCase(F::kRectangularSampling, "a rectangle",
                  {{0, 0, 0}, {0, 0, 2}, {3, 0, 2}, {3, 0, 0}}),
      polygonCase(F::kPolygonSampling, "a polygon with triangles of unequal areas",
                  {{0, 0, 0}, {0, 0, 2}, {3, 0, 3}, {4, 0, 1}, {2, 0, 0}}),
      {F::kSphereSample, SampleDomain::kHemisphere,
       "a sphere of radius 1, 2 above the receiver: directions from there", Words(),
       [=](Calls& calls, const Numbers& x) { calls.add(centre, 1.0f, from, x.st); },
       [](const vec3& p) { return glm::normalize(glm::dvec3(p)); }},
  };
}

std::vector<SampleCase> casesOf(int part) {
  const Vector n = glm::normalize(Vector(1.0f, 2.0f, -1.0f));
  const DoubleFrame around{glm::dvec3(n)};
  const Vector wo(glm::normalize(std::cos(0.8) * around.n + std::sin(0.8) * around.u));
  switch (part) {
    case 0:
      return {{F::kSampleSphere, SampleDomain::kSphere, "", Words(),
               [](Calls& calls, const Numbers& x) { calls.add(x.st); },
               [](const vec3& d) { return glm::dvec3(d); }},
              {F::kSampleHemisphere, SampleDomain::kHemisphere, "a tilted normal", Words(),
               [n](Calls& calls, const Numbers& x) { calls.add(x.st, n); }, seenFrom(n)}};
    case 2:
      return casesOfLights();
    case 3:
      return {{F::kLambertianReflection, SampleDomain::kHemisphere, "a tilted normal",
               Words().add(Colour(0.5f)),
               [n](Calls& calls, const Numbers& x) { calls.add(n, n, x.st, x.u); }, seenFrom(n)}};
    case 4:
      return {{F::kPhongReflection, SampleDomain::kSphere,
               "a tilted normal, wo 46 degrees from it, Kd = 0.3, Ks = 0.5, exponent 20",
               Words().add(Colour(0.3f), Colour(0.5f), 20.0f),
               [n, wo](Calls& calls, const Numbers& x) { calls.add(wo, n, x.st, x.u); },
               seenFrom(n)}};
    default:
      return {};
  }
}

std::vector<glm::dvec3> placesOf(WorkerProcess& worker, const SampleCase& c) {
  Calls calls(c.function, c.object);
  constexpr std::uint64_t kSeed = 1;
  checks::Points points(kSeed, kCounted);
  points.start(0);
  for (std::uint32_t m = 0; m < kCounted; ++m) {
    points.point(m);
    const vec2 st = points.pair();
    c.add(calls, {st, points.single()});
  }
  const Results results = calls.run(worker);
  std::vector<glm::dvec3> places;
  for (std::size_t m = 0; m < results.count(); ++m) places.push_back(c.place(results.vector(m, 0)));
  return places;
}

bool isFinite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// What lies outside of the axis is in none of the bins.
std::vector<double> sharesOf(const std::vector<glm::dvec3>& places, const Axis& axis) {
  std::vector<double> shares(kBins, 0.0);
  for (const glm::dvec3& p : places) {
    const double x = isFinite(p) ? (axis.of(p) - axis.low) / (axis.high - axis.low) : -1.0;
    if (x < 0.0 || x > 1.0) continue;
    const auto bin = std::min(static_cast<std::size_t>(x * static_cast<double>(kBins)), kBins - 1);
    shares[bin] += 1.0 / static_cast<double>(places.size());
  }
  return shares;
}

record::SampleRecord recordOf(const SampleCase& c, const std::vector<glm::dvec3>& yours,
                              const std::vector<glm::dvec3>& solved) {
  const FunctionContract& f = contractOf(c.function);
  record::SampleRecord record{
      std::string(f.section), std::string(f.name), c.inputs, c.domain, {}, {}};
  for (std::uint32_t m = 0; m < kShown; ++m) {
    const glm::dvec3& p = yours[m];
    if (!isFinite(p)) continue;
    // Three digits are enough for a dot.
    const auto rounded = [](double x) {
      return static_cast<float>(std::round(std::clamp(x, -2.0, 2.0) * 1000.0) / 1000.0);
    };
    record.yours.push_back({rounded(p.x), rounded(p.y), rounded(p.z)});
  }
  for (const Axis& axis : axesOf(c.domain))
    record.histograms.push_back(
        {axis.name, axis.low, axis.high, sharesOf(yours, axis), sharesOf(solved, axis)});
  return record;
}

}  // namespace

std::vector<record::SampleRecord> drawSamples(WorkerProcess& worker, WorkerProcess& solutions,
                                              int part,
                                              std::span<const CourseworkFunction> leftOut) {
  std::vector<record::SampleRecord> records;
  for (const SampleCase& c : casesOf(part)) {
    if (std::find(leftOut.begin(), leftOut.end(), c.function) != leftOut.end()) continue;
    records.push_back(recordOf(c, placesOf(worker, c), placesOf(solutions, c)));
  }
  return records;
}

}  // namespace pathmark::marking
