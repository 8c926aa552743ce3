// Shapes that can be lights.
//
//   Polygon   TriangularSampling, RectangularSampling, PolygonSampling   (part 2)
//             SphericalTriangleSampling, SphericalTrianglePdf            (part 9, bonus)
//             SphericalRectangleSampling, SphericalRectanglePdf          (part 9, bonus)
//   Sphere    sample, pdf                                                (part 2)
//
// s, t in [0,1). All densities are per unit area. A polygon's front is the side from which its
// vertices run counter-clockwise; a sphere's normal points outwards.
#pragma once

#include <pathmark/types.h>

#include <array>
#include <span>

namespace pathmark {

// A simple planar polygon, convex or not, with at least three vertices. The vertices and the
// triangulation belong to the scene; a Polygon only looks at them. `normal` has unit length and
// points to the side from which the vertices run counter-clockwise.
class Polygon {
 public:
  using TriangleIndices = std::array<unsigned, 3>;

  Polygon(std::span<const Point> vertices, std::span<const TriangleIndices> triangles,
          const Vector& normal)
      : vertices_(vertices), triangles_(triangles), normal_(normal) {}

  int vertexCount() const { return static_cast<int>(vertices_.size()); }
  // 0 <= i < vertexCount().
  const Point& p(int i) const { return vertices_[static_cast<std::size_t>(i)]; }

  // Unit normal of the front.
  const Vector& normal() const { return normal_; }

  // Triangles that cover the polygon exactly once, each with the polygon's orientation; at least
  // one, 0 <= k < triangleCount().
  int triangleCount() const { return static_cast<int>(triangles_.size()); }
  std::array<Point, 3> triangle(int k) const {
    const TriangleIndices& t = triangles_[static_cast<std::size_t>(k)];
    return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
  }

  // Part 2. A point uniform by area on the triangle p0 p1 p2 (the first three vertices), and its
  // density 2 / |(p1 - p0) x (p2 - p0)|. Shirley, Wang & Zimmerman 1996, section 3.3.
  LightSample TriangularSampling(float s, float t) const;

  // Part 2. The point p0 + s v1 + t v2 of the parallelogram with edges v1 = p1 - p0 and
  // v2 = p3 - p0 (p2 - p1 for the fourth side), and its density 1 / |v1 x v2|, of a polygon with
  // four vertices. Ibid.
  LightSample RectangularSampling(float s, float t) const;

  // Part 2. A point uniform by area on the whole polygon, and its density 1 / area.
  LightSample PolygonSampling(float s, float t) const;

  // Part 9, bonus. A point of the triangle p0 p1 p2, uniform over the solid angle omega that the
  // triangle fills as seen from `from`; density per unit area, cos(theta') / (omega |p - from|^2),
  // theta' the angle at p between the normal and the direction to `from`. Where omega is below
  // 1e-3 sr any density will do that is above 0 on the whole triangle. The density is 0 where
  // `from` lies behind the triangle or in its plane. Arvo 1995; Peters 2021.
  LightSample SphericalTriangleSampling(const Point& from, float s, float t) const;

  // Part 9, bonus. The density per unit area with which SphericalTriangleSampling(from, ...)
  // returns the point p of the triangle: 0 where `from` lies behind it or in its plane.
  float SphericalTrianglePdf(const Point& from, const Point& p) const;

  // Part 9, bonus. The same for the rectangle with the edges v1 = p1 - p0 and v2 = p3 - p0, at
  // right angles. Urena, Fajardo & King 2013.
  LightSample SphericalRectangleSampling(const Point& from, float s, float t) const;
  float SphericalRectanglePdf(const Point& from, const Point& p) const;

 private:
  std::span<const Point> vertices_;
  std::span<const TriangleIndices> triangles_;
  Vector normal_;
};

class Sphere {
 public:
  // radius > 0.
  Sphere(const Point& centre, float radius) : centre_(centre), radius_(radius) {}

  const Point& centre() const { return centre_; }
  float radius() const { return radius_; }

  // Part 2. A point of the sphere that `from` can see, uniform over the solid angle that the
  // sphere fills as seen from there; `n` is the outward normal; density per unit area
  //   cos(theta') / (2 pi |x' - x|^2 (1 - sqrt(1 - (r / |x - c|)^2))).
  // Shirley, Wang & Zimmerman 1996, section 3.2. With `from` inside or on the sphere: uniform
  // over its whole area, density 1 / (4 pi r^2).
  LightSample sample(const Point& from, float s, float t) const;

  // Part 2. The density with which `sample(from, ...)` returns the point p with outward normal n;
  // 0 where it never does. p = c + r n up to rounding.
  float pdf(const Point& from, const Point& p, const Vector& n) const;

 private:
  Point centre_;
  float radius_;
};

}  // namespace pathmark
