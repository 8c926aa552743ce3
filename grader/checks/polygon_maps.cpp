#include "checks/polygon_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;
using Corners = std::array<glm::dvec3, 3>;

constexpr int kSide = 8;

struct Grid {
  std::array<glm::dvec2, kSide * kSide> st;
  std::array<glm::dvec3, kSide * kSide> points;
};

Grid gridOf(WorkerProcess& worker, F sampling, const Outline& outline) {
  Grid grid;
  Calls calls(sampling, outline.words());
  for (std::size_t i = 0; i < grid.st.size(); ++i) {
    grid.st[i] = (glm::dvec2(i % kSide, i / kSide) + 0.5) / double{kSide};
    calls.add(vec2(grid.st[i]));
  }
  const Results results = calls.run(worker);
  for (std::size_t i = 0; i < grid.st.size(); ++i)
    grid.points[i] = glm::dvec3(results.vector(i, 0));
  return grid;
}

std::string unusedNumber(const Grid& grid) {
  bool ofS = false, ofT = false;  // whether the point depends on it
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    ofS = ofS || grid.points[i] != grid.points[i - i % kSide];
    ofT = ofT || grid.points[i] != grid.points[i % kSide];
  }
  if (!ofS && !ofT) return "always the same point: neither s nor t is used";
  if (!ofS) return "the point does not depend on s";
  return ofT ? "" : "the point does not depend on t";
}

glm::dvec3 at(const Corners& c, double b1, double b2) {
  return c[0] + b1 * (c[1] - c[0]) + b2 * (c[2] - c[0]);
}

// Whether all points are those of this map, with the corners in any order, and s and t too.
using TriangleMap = glm::dvec3 (*)(const Corners&, double s, double t);

bool follows(const Grid& grid, const Outline& outline, TriangleMap map,
             const std::function<Corners(double)>& corners) {
  const double allowed = 1e-5 * (outline.magnitude() + std::sqrt(outline.area()));
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (const bool swapped : {false, true}) {
      bool all = true;
      for (std::size_t i = 0; all && i < grid.st.size(); ++i) {
        const double s = swapped ? grid.st[i].y : grid.st[i].x;
        const double t = swapped ? grid.st[i].x : grid.st[i].y;
        const Corners c = corners(s);
        all = glm::length(map({c[order[0]], c[order[1]], c[order[2]]}, s, t) - grid.points[i]) <=
              allowed;
      }
      if (all) return true;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return false;
}

glm::dvec3 rootMap(const Corners& c, double s, double t) {
  return at(c, std::sqrt(s) * (1.0 - t), std::sqrt(s) * t);
}
glm::dvec3 withoutRoot(const Corners& c, double s, double t) { return at(c, s, (1.0 - s) * t); }
glm::dvec3 asTheyAre(const Corners& c, double s, double t) { return at(c, s, t); }
glm::dvec3 rootOfBoth(const Corners& c, double s, double t) {
  return at(c, std::sqrt(s), std::sqrt(t));
}

bool allOn(const Grid& grid, const Outline& part) {
  const double allowed = 1e-5 * (part.magnitude() + std::sqrt(part.area()));
  return std::all_of(grid.points.begin(), grid.points.end(),
                     [&](const glm::dvec3& p) { return part.distance(Point(p)) <= allowed; });
}

Outline firstThree(const Outline& outline) {
  return Outline({outline.vertices()[0], outline.vertices()[1], outline.vertices()[2]});
}

std::string ofTriangle(const Grid& grid, const Outline& outline) {
  const auto corners = [&](double) { return outline.triangle(0); };
  if (follows(grid, outline, withoutRoot, corners))
    return "barycentric coordinates like s and (1 - s) t: the points crowd at one corner";
  if (follows(grid, outline, asTheyAre, corners))
    return "s and t are used as barycentric coordinates as they are: half of the points lie "
           "outside the triangle";
  if (follows(grid, outline, rootOfBoth, corners))
    return "the square root of both numbers is taken";
  return {};
}

std::string ofRectangle(const Grid& grid, const Outline& outline) {
  const auto firstHalf = [&](double) { return firstThree(outline).triangle(0); };
  if (follows(grid, outline, asTheyAre, firstHalf))
    return "v2 = p2 - p0 is the diagonal: the neighbours of p0 are p1 and p3";
  if (allOn(grid, firstThree(outline)))
    return "only the triangle p0 p1 p2, half of the rectangle, gets points";
  return {};
}

std::string ofPolygon(const Grid& grid, const Outline& outline) {
  const std::size_t count = outline.triangleCount();
  if (count == 1) return {};
  const auto& v = outline.vertices();
  const auto firstCorner = [&](double) {
    return Corners{glm::dvec3(v[0]), glm::dvec3(v[1]), glm::dvec3(v.back())};
  };
  if (follows(grid, outline, asTheyAre, firstCorner))
    return "the polygon is taken for a parallelogram";
  if (allOn(grid, firstThree(outline))) return "only the first three vertices are used";
  const auto byArea = [&](double s) {
    std::size_t k = 0;
    for (double left = s * outline.area(); k + 1 < count && left >= outline.areaOf(k); ++k)
      left -= outline.areaOf(k);
    return outline.triangle(k);
  };
  if (follows(grid, outline, rootMap, byArea))
    return "the number that has chosen the triangle is used again as it is: within the triangle "
           "it is not uniform in [0,1) before it is rescaled";
  const Outline fan(v);
  double fanArea = fan.area();
  if (fanArea > 1.001 * outline.area() && allOn(grid, fan) && !allOn(grid, outline))
    return "triangles between p0 and each edge stick out of a polygon with a dent: triangle(k) "
           "does not";
  return {};
}

}  // namespace

std::string suspectedMap(WorkerProcess& worker, F sampling, const Outline& outline) {
  const Grid grid = gridOf(worker, sampling, outline);
  if (std::string unused = unusedNumber(grid); !unused.empty()) return unused;
  if (sampling == F::kTriangularSampling) return ofTriangle(grid, outline);
  return sampling == F::kRectangularSampling ? ofRectangle(grid, outline)
                                             : ofPolygon(grid, outline);
}

}  // namespace pathmark::checks
