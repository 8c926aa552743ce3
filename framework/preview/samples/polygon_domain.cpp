#include "preview/samples/polygon_domain.h"

#include "preview/samples/direction_frame.h"
#include "preview/samples/flat_polygon.h"
#include "scene/triangulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pathmark::preview {

namespace {

using F = CourseworkFunction;

// Counter-clockwise in the plane; `shape` moves one corner.
std::vector<glm::dvec2> outlineOf(F function, double shape) {
  if (function == F::kTriangularSampling)
    return {{-0.9, -0.7}, {0.9, -0.5}, {1.6 * shape - 0.8, 0.9}};
  if (function == F::kRectangularSampling) {
    const glm::dvec2 corner(-0.7, -0.5), across(1.3, 0.0), up(0.8 * (shape - 0.25), 1.0);
    return {corner, corner + across, corner + across + up, corner + up};
  }
  return {{-1.0, -0.8}, {0.2, -0.8}, {1.0, -0.2}, {0.7, 0.8}, {0.1, 0.9 - 1.4 * shape},
          {-0.3, 0.7},  {-0.9, 0.5}};
}

class PolygonDomain final : public SampleDomain {
 public:
  PolygonDomain(F function, double shape) : function_(function) {
    for (const glm::dvec2& p : outlineOf(function, shape))
      vertices_.emplace_back(origin_ + p.x * plane_.u + p.y * plane_.v);
    for (const vec3& v : vertices_) corners_.push_back(inPlane(glm::dvec3(v)));
    const auto indices = triangulate(corners_);
    if (!indices) throw std::logic_error("the polygon of the sample view is not simple");
    indices_ = *indices;
    for (const TriangleIndices& t : indices_)
      triangles_.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
    for (const FlatTriangle& t : triangles_) area_ += areaOf(t);
  }

  CallWords object() const override {
    CallWords words;
    words.add(vertices_.size(), indices_.size(), vec3(plane_.n));
    for (const vec3& v : vertices_) words.add(v);
    for (const TriangleIndices& t : indices_) words.add(t[0], t[1], t[2]);
    return words;
  }
  void addCall(CallWords& calls, std::size_t, const CallNumbers& x) const override {
    calls.add(x.s, x.t);
  }
  Answer read(std::span<const std::uint32_t> answer) const override {
    return {vectorAt(answer, 0), numberAt(answer, 6)};
  }

  double density(const glm::dvec3& place) const override {
    const double offPlane = glm::dot(place - origin_, plane_.n);
    return std::abs(offPlane) < kRounding && triangleAt(place) < triangles_.size() ? 1.0 / area_
                                                                                   : 0.0;
  }
  std::string_view astray() const override { return "lie off the polygon"; }

  Cells cells(std::size_t about) const override {
    const double each = static_cast<double>(about) / static_cast<double>(triangles_.size());
    const auto side = std::max<std::size_t>(static_cast<std::size_t>(std::sqrt(each)), 1);
    Cells cells;
    for (const FlatTriangle& t : triangles_)
      cells.masses.insert(cells.masses.end(), side * side,
                          areaOf(t) / area_ / static_cast<double>(side * side));
    cells.cellOf = [=, this](const glm::dvec3& place) {
      const std::size_t k = std::min(triangleAt(place), triangles_.size() - 1);
      return k * side * side + partOf(barycentrics(triangles_[k], inPlane(place)), side);
    };
    return cells;
  }

  std::vector<Marginal> marginals() const override {
    switch (function_) {
      case F::kTriangularSampling:
        return {weightOf(1), weightOf(2)};
      case F::kRectangularSampling:
        return {along(0), along(1)};
      default:
        return {coordinate(0), coordinate(1)};
    }
  }

  Sketch sketch() const override {
    Sketch sketch;
    sketch.radius = 1.3;
    sketch.centre = origin_;
    for (const TriangleIndices& t : indices_)
      sketch.strokes.push_back(
          {StrokeKind::kFaint, closed({vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]})});
    sketch.strokes.push_back({StrokeKind::kEdge, closed(vertices_)});
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      sketch.captions.push_back(
          {origin_ + 1.08 * (glm::dvec3(vertices_[i]) - origin_), fmt::format("p{}", i)});
    return sketch;
  }

 private:
  static constexpr double kRounding = 1e-4;

  glm::dvec2 inPlane(const glm::dvec3& place) const {
    return {glm::dot(place - origin_, plane_.u), glm::dot(place - origin_, plane_.v)};
  }
  static std::vector<glm::dvec3> closed(const std::vector<vec3>& corners) {
    std::vector<glm::dvec3> points(corners.begin(), corners.end());
    points.push_back(points.front());
    return points;
  }

  // The number of triangles for a point that is in none of them.
  std::size_t triangleAt(const glm::dvec3& place) const {
    const glm::dvec2 point = inPlane(place);
    const auto holds = [&](const FlatTriangle& t) {
      const glm::dvec3 w = barycentrics(t, point);
      return w.x > -kRounding && w.y > -kRounding && w.z > -kRounding;
    };
    return static_cast<std::size_t>(std::find_if(triangles_.begin(), triangles_.end(), holds) -
                                    triangles_.begin());
  }

  // How much of corner p1 or p2 is in a point of the triangle: its density is 2 (1 - w).
  Marginal weightOf(int corner) const {
    const FlatTriangle t{corners_[0], corners_[1], corners_[2]};
    Marginal marginal;
    marginal.name = corner == 1 ? "share of p1 (barycentric)" : "share of p2 (barycentric)";
    marginal.coordinate = [=, this](const glm::dvec3& p) {
      return barycentrics(t, inPlane(p))[corner];
    };
    marginal.mass = [](double from, double to) {
      const auto above = [](double w) { return (1.0 - w) * (1.0 - w); };
      return above(from) - above(to);
    };
    return marginal;
  }

  // Along an edge of the parallelogram, in its length.
  Marginal along(int edge) const {
    const FlatTriangle t{corners_[0], corners_[1], corners_[3]};
    Marginal marginal;
    marginal.name = edge == 0 ? "along p1 - p0" : "along p3 - p0";
    marginal.coordinate = [=, this](const glm::dvec3& p) {
      return barycentrics(t, inPlane(p))[edge + 1];
    };
    marginal.mass = [](double from, double to) { return to - from; };
    return marginal;
  }

  Marginal coordinate(int axis) const {
    const auto less = [axis](const glm::dvec2& a, const glm::dvec2& b) {
      return a[axis] < b[axis];
    };
    const auto [lowest, highest] = std::minmax_element(corners_.begin(), corners_.end(), less);
    Marginal marginal;
    marginal.name = axis == 0 ? "x in the polygon's plane" : "y in the polygon's plane";
    marginal.low = (*lowest)[axis];
    marginal.high = (*highest)[axis];
    marginal.coordinate = [axis, this](const glm::dvec3& p) { return inPlane(p)[axis]; };
    marginal.mass = [this, axis](double from, double to) {
      double area = 0.0;
      for (const FlatTriangle& t : triangles_)
        area += areaBelow(t, axis, to) - areaBelow(t, axis, from);
      return area / area_;
    };
    return marginal;
  }

  // A plane that is none of the world's.
  glm::dvec3 origin_{0.1, 0.2, -0.1};
  DirectionFrame plane_{glm::dvec3(0.35, 0.45, 1.0)};

  F function_;
  std::vector<vec3> vertices_;
  std::vector<glm::dvec2> corners_;  // as rounded, in the plane
  std::vector<TriangleIndices> indices_;
  std::vector<FlatTriangle> triangles_;
  double area_ = 0.0;
};

}  // namespace

std::unique_ptr<SampleDomain> makePolygonDomain(const SampleSettings& settings) {
  return std::make_unique<PolygonDomain>(settings.function, settings.shape);
}

}  // namespace pathmark::preview
