// What is asked of 2.1, 2.2 and 2.3: points on triangles, rectangles and polygons.
#include "checks/calls.h"
#include "checks/exact.h"
#include "checks/outline.h"
#include "checks/part2_checks.h"
#include "checks/points.h"
#include "checks/polygon_maps.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr double kRoundoff = 0x1p-24;

Outline parallelogram(const glm::dvec3& a, const glm::dvec3& v1, const glm::dvec3& v2) {
  return Outline({Point(a), Point(a + v1), Point(a + v1 + v2), Point(a + v2)});
}

// Two directions in a plane at random, at a right angle.
std::pair<glm::dvec3, glm::dvec3> randomPlane(Random& random) {
  const DoubleFrame frame{glm::dvec3(random.direction())};
  const double turn = random.between(0.0, 6.28);
  return {std::cos(turn) * frame.u + std::sin(turn) * frame.v,
          std::cos(turn) * frame.v - std::sin(turn) * frame.u};
}

glm::dvec3 randomPlace(Random& random, double size) {
  return size * random.between(0.0, 5.0) * glm::dvec3(random.direction());
}

std::vector<Outline> triangles(Random& random) {
  std::vector<Outline> all;
  all.emplace_back(std::vector<Point>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}});
  all.emplace_back(std::vector<Point>{{1, 2, 3}, {4, 2, 1}, {0, 5, 2}});
  for (const double size : {1.0, 1e-6, 1e6}) {
    const auto [u, v] = randomPlane(random);
    const glm::dvec3 a = randomPlace(random, 0.1 * size);
    const glm::dvec3 b = a + size * random.between(0.3, 0.9) * u;
    const glm::dvec3 c = a + size * (random.between(-0.5, 0.9) * u + random.between(0.3, 0.9) * v);
    all.emplace_back(std::vector<Point>{Point(a), Point(b), Point(c)});
  }
  all.emplace_back(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0.3f, 1e-4f, 0}});
  all.emplace_back(std::vector<Point>{{1000, 2000, 3000}, {1001, 2000, 3000}, {1000, 2001, 3001}});
  return all;
}

std::vector<Outline> parallelograms(Random& random) {
  std::vector<Outline> all{parallelogram({0, 2, 0}, {2, 0, 0}, {0, 0, 3}),
                           parallelogram({0, 0, 0}, {2, 0, 0}, {1, 2, 0})};
  for (const double size : {1.0, 1e-6, 1e6}) {
    const auto [u, v] = randomPlane(random);
    all.push_back(
        parallelogram(randomPlace(random, 0.1 * size), size * random.between(0.3, 0.9) * u,
                      size * (random.between(-0.5, 0.5) * u + random.between(0.3, 0.9) * v)));
  }
  all.push_back(parallelogram({0, 0, 0}, {1e4, 0, 0}, {0, 1, 0}));
  all.push_back(parallelogram({1000, 2000, 3000}, {1, 0, 0}, {0, 1, 1}));
  return all;
}

// Convex, its vertices on an ellipse.
Outline rounded(Random& random, int vertices, double size) {
  const auto [u, v] = randomPlane(random);
  const glm::dvec3 centre = randomPlace(random, 0.1 * size);
  std::vector<Point> points;
  for (int k = 0; k < vertices; ++k) {
    const double angle =
        2.0 * std::numbers::pi * (k + random.between(0.2, 0.8)) / static_cast<double>(vertices);
    points.emplace_back(centre + size * (std::cos(angle) * u + 0.4 * std::sin(angle) * v));
  }
  return Outline(std::move(points));
}

std::vector<Outline> polygons(Random& random) {
  std::vector<Outline> all;
  // A trapezium; an L; an L from next to its dent on; an arrow; one triangle that is nearly all.
  all.emplace_back(std::vector<Point>{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  all.emplace_back(
      std::vector<Point>{{0, 0, 2}, {5, 0, 2}, {5, 1, 2}, {1, 1, 2}, {1, 3, 2}, {0, 3, 2}},
      std::vector<Outline::Indices>{{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {0, 4, 5}});
  all.emplace_back(
      std::vector<Point>{{5, 1, 2}, {1, 1, 2}, {1, 3, 2}, {0, 3, 2}, {0, 0, 2}, {5, 0, 2}},
      std::vector<Outline::Indices>{{4, 5, 1}, {5, 0, 1}, {4, 1, 2}, {4, 2, 3}});
  all.emplace_back(std::vector<Point>{{0, 0, 0}, {2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}},
                   std::vector<Outline::Indices>{{0, 1, 2}, {0, 2, 3}});
  all.emplace_back(std::vector<Point>{{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {999.5f, 1000, 0}});
  all.emplace_back(std::vector<Point>{{0, 0, 1}, {2, 0, 1}, {0, 3, 1}});
  all.push_back(rounded(random, 5, 1.0));
  all.push_back(rounded(random, 7, 1e-6));
  all.push_back(rounded(random, 7, 1e6));
  all.push_back(rounded(random, 24, 3.0));
  return all;
}

template <F kFunction>
std::vector<Outline> outlines(std::uint64_t seed) {
  Random random(seed);
  if constexpr (kFunction == F::kTriangularSampling) return triangles(random);
  if constexpr (kFunction == F::kRectangularSampling) return parallelograms(random);
  return polygons(random);
}

template <F kFunction>
Finding densityIsOneOverArea(CheckRun& run) {
  constexpr bool kPolygon = kFunction == F::kPolygonSampling;
  Exact exact{"the area of the parallelogram of the edges is twice that of the triangle",
              kPolygon ? "the density on one triangle, and not on the whole polygon"
                       : "half of the area: that of a triangle of these edges",
              "the area itself, and not one over it",
              "always 1: the density is one over the area",
              "the product of the lengths of the edges is the area only if the angle is right",
              "triangles between p0 and each edge stick out of a polygon with a dent: triangle(k) "
              "does not"};
  Random random(run.seed + 1);
  for (const Outline& outline : outlines<kFunction>(run.seed)) {
    Calls calls(kFunction, outline.words());
    std::vector<vec2> points{{0.5f, 0.5f}, {0.0f, 0.0f}, {1.0f - 0x1p-24f, 1.0f - 0x1p-24f}};
    for (int k = 0; k < 61; ++k) points.emplace_back(random.uniform(), random.uniform());
    for (const vec2& st : points) calls.add(st);
    const Results results = calls.run(run.worker);
    exact.count(results.count());
    const auto& v = outline.vertices();
    const double expected = 1.0 / outline.area(),
                 edges = glm::length(glm::dvec3(v[1]) - glm::dvec3(v[0])) *
                         glm::length(glm::dvec3(v.back()) - glm::dvec3(v[0]));
    for (std::size_t i = 0; i < points.size(); ++i)
      exact.value("pdf", results.number(i, 6), expected,
                  relativeTolerance(outline.condition()) * expected,
                  [&] {
                    return fmt::format("{}, s = {:.8g}, t = {:.8g}", outline.text(), points[i].x,
                                       points[i].y);
                  },
                  {0.5 * expected, kPolygon ? 1.0 / outline.areaOf(0) : 2.0 * expected,
                   outline.area(), 1.0, 1.0 / edges, 1.0 / Outline(v).area()});
  }
  return exact.finding();
}

template <F kFunction>
Finding pointsAreOfThePolygon(CheckRun& run) {
  Random random(run.seed + 1);
  for (const Outline& outline : outlines<kFunction>(run.seed)) {
    std::vector<vec2> points{{0.5f, 0.5f}, {0.75f, 0.25f}};
    for (int k = 0; k < 64; ++k) points.emplace_back(random.uniform(), random.uniform());
    for (const float s : kEdgeNumbers)
      for (const float t : kEdgeNumbers) points.emplace_back(s, t);
    Calls calls(kFunction, outline.words());
    for (const vec2& st : points) calls.add(st);
    for (std::size_t i = points.size(); i-- > 0;) calls.add(points[i]);
    const Results results = calls.run(run.worker);
    Exact exact;
    exact.count(results.count());
    const double allowed = 32.0 * kRoundoff * outline.magnitude();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t again = results.count() - 1 - i;
      const Point p = results.vector(i, 0);
      const Vector n = results.vector(i, 3);
      const auto where = [&] {
        return fmt::format("{}, s = {:.8g}, t = {:.8g}", outline.text(), points[i].x, points[i].y);
      };
      const auto got = [&] { return fmt::format("p = {}, n = {}", text(p), text(n)); };
      if (!exact.holds(results.finite(i), "finite numbers", got, where)) break;
      const double distance = outline.distance(p);
      exact.holds(
          distance <= allowed, "a point of the polygon",
          [&] {
            return fmt::format("p = {}, which is off the polygon by {:.3g}", text(p), distance);
          },
          where);
      exact.holds(
          glm::length(glm::dvec3(n) - glm::dvec3(outline.normal())) <=
              relativeTolerance(outline.condition()),
          fmt::format("n = normal() = {}", text(outline.normal())),
          [&] { return fmt::format("n = {}", text(n)); }, where);
      exact.holds(
          results.same(i, again), "the same point again for the same s and t",
          [&] {
            return fmt::format("p = {} and then {}", text(p), text(results.vector(again, 0)));
          },
          where);
    }
    if (!exact.failed()) continue;
    Finding finding = exact.finding();
    finding.cause = suspectedMap(run.worker, kFunction, outline);
    return finding;
  }
  return {};
}

std::vector<Suspicion> suspicionsAbout(const Outline& outline) {
  const auto count = outline.triangleCount();
  if (count == 1) return {};
  const std::vector<double> equal(count, 1.0 / static_cast<double>(count));
  return {
      {"all triangles are chosen with the same probability, and not in proportion to their area",
       outline.meansWith(equal)}};
}

template <F kFunction>
Finding judgeUniform(CheckRun& run, const Outline& outline, std::uint64_t seed) {
  // Many small shares need many points, or few replicates have one too many or too few.
  const std::uint32_t perReplicate = outline.triangleCount() > 4 ? 256 : 128;
  const std::vector<Mean> means = outline.uniformMeans();
  Points points(seed, perReplicate);
  std::uint64_t made = 0;
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    Calls calls(kFunction, outline.words());
    for (std::uint32_t r = first; r < first + count; ++r) {
      points.start(r);
      for (std::uint32_t m = 0; m < perReplicate; ++m) {
        points.point(m);
        calls.add(points.pair());
      }
    }
    const Results results = calls.run(run.worker);
    made += results.count();
    std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t i = 0; i < results.count(); ++i) {
      const auto sums = values.subspan(i / perReplicate * means.size(), means.size());
      if (results.finite(i))
        outline.add(results.vector(i, 0), 1.0 / perReplicate, sums);
      else
        sums[0] = std::numeric_limits<double>::quiet_NaN();
    }
  };
  Finding finding = judgeMeans(
      run, means, measure, outline.text(),
      kFunction == F::kPolygonSampling ? suspicionsAbout(outline) : std::vector<Suspicion>{});
  finding.calls = made;
  if (finding.status == Status::kFail && finding.cause.empty())
    finding.cause = suspectedMap(run.worker, kFunction, outline);
  return finding;
}

template <F kFunction>
Finding pointsAreUniform(CheckRun& run) {
  Finding worst;
  std::uint64_t calls = 0, seed = run.seed;
  for (const Outline& outline : outlines<kFunction>(run.seed)) {
    const Finding finding = judgeUniform<kFunction>(run, outline, ++seed);
    calls += finding.calls;
    if (worst.passed()) worst = finding;
    if (!finding.passed()) break;
  }
  worst.calls = calls;
  return worst;
}

template <F kFunction>
void addChecks(std::vector<Check>& all) {
  all.push_back({"density", kFunction, "the density is one over the area", 0.0,
                 densityIsOneOverArea<kFunction>});
  all.push_back({"points", kFunction,
                 "for all s and t, also at the ends, p is a point of the polygon and n its normal, "
                 "and the same again for the same numbers",
                 0.0, pointsAreOfThePolygon<kFunction>});
  all.push_back(
      {"uniform", kFunction, "the points are uniform by area", 0.01, pointsAreUniform<kFunction>});
}

}  // namespace

std::vector<Check> polygonChecks() {
  std::vector<Check> all;
  addChecks<F::kTriangularSampling>(all);
  addChecks<F::kRectangularSampling>(all);
  addChecks<F::kPolygonSampling>(all);
  return all;
}

}  // namespace pathmark::checks
