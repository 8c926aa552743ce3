// Points of triangles, rectangles and polygons. Described are places within triangles, by functions
// of their barycentric coordinates that no exchange of corners changes: which corner a map begins
// at is left open.
#include "checks/outline.h"
#include "checks/points.h"
#include "diagnosis/light_probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

struct Case {
  const char* name;
  Outline outline;
};

Outline parallelogram(const Point& a, const Vector& v1, const Vector& v2) {
  return Outline({a, a + v1, a + v1 + v2, a + v2});
}

std::vector<Case> casesOf(F function) {
  if (function == F::kTriangularSampling)
    return {{"of a triangle", Outline({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}})},
            {"of a slanted triangle", Outline({{1, 2, 3}, {4, 2, 1}, {0, 5, 2}})}};
  if (function == F::kRectangularSampling)
    return {{"of a rectangle", parallelogram({0, 2, 0}, {2, 0, 0}, {0, 0, 3})},
            {"of a slanted parallelogram", parallelogram({1, 0, 2}, {2, 0, 0.5f}, {1, 2, 0})}};
  return {{"of a trapezium", Outline({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 1, 0}})},
          {"of an L", Outline({{5, 1, 2}, {1, 1, 2}, {1, 3, 2}, {0, 3, 2}, {0, 0, 2}, {5, 0, 2}},
                              {{4, 5, 1}, {5, 0, 1}, {4, 1, 2}, {4, 2, 3}})},
          {"of a pentagon", Outline({{0, 0, 1}, {2, 0, 1}, {3, 1, 1}, {2, 3, 1}, {0, 2, 1}})}};
}

glm::dvec3 barycentric(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t) {
  const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double twice = glm::dot(n, n);
  const double b1 = glm::dot(glm::cross(p - t[0], t[2] - t[0]), n) / twice,
               b2 = glm::dot(glm::cross(t[1] - t[0], p - t[0]), n) / twice;
  return {1.0 - b1 - b2, b1, b2};
}

double least(const glm::dvec3& b) { return std::min({b.x, b.y, b.z}); }

enum Sum : std::size_t {
  kInvalid,
  kOutside,
  kLeast,
  kProduct,
  kSquares,
  kPairs,
  kDensity,
  kNormal,
  kDistance2,
  kX,
  kY,
  kZ,
  kShares
};

void addPoint(const Outline& outline, const Point& at, std::span<double> sums) {
  const glm::dvec3 p(at);
  std::size_t in = 0;
  glm::dvec3 b(-1.0);
  for (std::size_t k = 0; k < outline.triangleCount(); ++k) {
    const glm::dvec3 of = barycentric(p, outline.triangle(k));
    if (k == 0 || least(of) > least(b)) {
      b = of;
      in = k;
    }
  }
  if (least(b) < -1e-5) sums[kOutside] += 1.0;
  sums[kShares + in] += 1.0;
  sums[kLeast] += least(b);
  sums[kProduct] += 27.0 * b.x * b.y * b.z;
  sums[kSquares] += glm::dot(b, b);
  sums[kPairs] += std::max({b.x, b.y, b.z}) * least(b);
  glm::dvec3 centre(0.0);
  for (std::size_t k = 0; k < outline.triangleCount(); ++k) {
    const auto [t0, t1, t2] = outline.triangle(k);
    centre += outline.areaOf(k) / outline.area() / 3.0 * (t0 + t1 + t2);
  }
  const glm::dvec3 off = (p - centre) / std::sqrt(outline.area());
  sums[kDistance2] += glm::dot(off, off);
  sums[kX] += off.x;
  sums[kY] += off.y;
  sums[kZ] += off.z;
}

}  // namespace

Signature probePolygon(const ProbeRun& run) {
  constexpr std::uint32_t kReplicates = 64, kPoints = 256;
  Signature signature;
  for (const Case& c : casesOf(run.function)) {
    const Outline& outline = c.outline;
    Points points(run.seed, kPoints);
    Calls calls(run.function, outline.words()), edges(run.function, outline.words());
    for (std::uint32_t r = 0; r < kReplicates; ++r) {
      points.start(r);
      for (std::uint32_t m = 0; m < kPoints; ++m) {
        points.point(m);
        calls.add(points.pair());
      }
    }
    for (const float s : kEdgeNumbers)
      for (const float t : kEdgeNumbers) edges.add(s, t);
    const Results results = calls.run(run.worker), atEdges = edges.run(run.worker);
    Replicates sums(kReplicates, kShares + outline.triangleCount());
    for (std::size_t i = 0; i < results.count(); ++i) {
      const auto of = sums.of(static_cast<std::uint32_t>(i / kPoints));
      if (!results.finite(i)) {
        of[kInvalid] += 1.0;
        continue;
      }
      addPoint(outline, results.vector(i, 0), of);
      const double density = results.number(i, 6), right = 1.0 / outline.area();
      of[kDensity] += density >= 0.0 ? density / (density + right) : -1.0;
      of[kNormal] += double{dot(results.vector(i, 3), outline.normal())};
    }
    sums.divideBy(kPoints);
    const auto add = [&](const char* what, std::size_t k) {
      sums.add(signature, fmt::format("{}, points {}", what, c.name), k);
    };
    add("density / (density + 1/area)", kDensity);
    add("share of the points outside", kOutside);
    add("mean of the least barycentric coordinate", kLeast);
    add("mean of 27 times the product of the barycentric coordinates", kProduct);
    add("mean sum of the squared barycentric coordinates", kSquares);
    add("mean of the least times the largest barycentric coordinate", kPairs);
    add("mean squared distance from the centroid, over the area", kDistance2);
    sums.addLength(signature,
                   fmt::format("mean of the points from the centroid, over the root of the area, "
                               "points {}",
                               c.name),
                   {kX, kY, kZ});
    for (std::size_t k = 0; k < outline.triangleCount(); ++k)
      add(fmt::format("share of triangle {}", k + 1).c_str(), kShares + k);
    add("cosine between n and the normal", kNormal);
    add("share of answers that are no numbers", kInvalid);
    double invalid = 0.0;
    for (std::size_t i = 0; i < atEdges.count(); ++i) invalid += atEdges.finite(i) ? 0.0 : 1.0;
    signature.add(
        fmt::format("answers that are no numbers where s and t are 0 or next to 1, {}", c.name),
        invalid);
  }
  return signature;
}

}  // namespace pathmark::diagnosis
