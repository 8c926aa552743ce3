// Outline: a planar polygon with its triangulation, as the judge knows it, in double.
//
//   words, text            as an argument of a call, and to a reader
//   area, condition        and how much a rounding of the coordinates changes the area
//   distance               of a point from the polygon
//   uniformMeans, add      moments and cells of points that are uniform by area
#pragma once

#include "checks/calls.h"
#include "checks/means.h"

#include <pathmark/shapes.h>

#include <span>
#include <string>
#include <vector>

namespace pathmark::checks {

class Outline {
 public:
  using Indices = Polygon::TriangleIndices;

  // Counter-clockwise seen from the front. Without triangles: those between the first vertex and
  // each edge, which cover a convex polygon.
  explicit Outline(std::vector<Point> vertices, std::vector<Indices> triangles = {});

  Words words() const;
  std::string text() const;

  const std::vector<Point>& vertices() const { return vertices_; }
  std::size_t triangleCount() const { return triangles_.size(); }
  std::array<glm::dvec3, 3> triangle(std::size_t k) const;
  const Vector& normal() const { return normal_; }

  double area() const { return area_; }
  double areaOf(std::size_t k) const;
  double condition() const { return magnitude_ * longest_ / area_; }
  double magnitude() const { return magnitude_; }  // the largest coordinate

  double distance(const Point& p) const;

  // Means of the two coordinates along p1 - p0 and along the edge from p0 to the last vertex, of
  // their products, and the shares of congruent parts of the triangles.
  std::vector<Mean> uniformMeans() const;

  // What these means would be with other probabilities of the triangles, and points uniform on
  // each of them.
  std::vector<double> meansWith(const std::vector<double>& probabilities) const;

  // Adds the weight times what a point contributes to each of the means.
  void add(const Point& p, double weight, std::span<double> sums) const;

 private:
  static constexpr std::size_t kMoments = 5;

  std::size_t cellCount() const { return triangles_.size() * split_ * split_; }
  std::size_t cellOf(const glm::dvec3& p) const;
  std::array<double, kMoments> moments(const glm::dvec3& p) const;

  std::vector<Point> vertices_;
  std::vector<Indices> triangles_;
  Vector normal_;
  double area_ = 0.0, magnitude_ = 0.0, longest_ = 0.0;
  std::size_t split_;
};

}  // namespace pathmark::checks
