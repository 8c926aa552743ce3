// Part 9, bonus: lights by the solid angle that they fill. Handout: handouts/part9_solid_angle.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

using Double3 = glm::dvec3;

// A triangle as seen from a point x, which is the origin here. All that cancels for small and far
// triangles is made of their edges, which are exact, and not of differences of unit vectors. Close
// to its plane the arcs of `sample` end within some 1e-7 of each other, which is all that float can
// tell apart: hence double.
struct SeenTriangle {
  Double3 p0;
  Double3 edge1, edge2;  // from p0 to p1 and p2
  Double3 d0, d1, d2;    // from x to the corners,
  double l0, l1, l2;     // and their lengths
  double height;         // of x over the plane; not above 0: the front is not seen

  // Of the unit vectors v0, v1, v2: their volume |v0 . (v1 x v2)|, (v0 + v1) . v2 and 1 + v0 . v1.
  double g0 = 0.0, g1 = 0.0, g2 = 0.0;
  double solidAngle = 0.0;

  SeenTriangle(const Point& a, const Point& b, const Point& c, const Point& from)
      : p0(a), edge1(Double3(b) - p0), edge2(Double3(c) - p0) {
    const Double3 x(from), normal = cross(edge1, edge2);
    d0 = p0 - x, d1 = Double3(b) - x, d2 = Double3(c) - x;
    const double volume = -dot(d0, normal);
    height = volume / length(normal);
    if (!(height > roundingOf(from))) return;
    l0 = length(d0), l1 = length(d1), l2 = length(d2);
    g0 = volume / l0 / l1 / l2;
    g1 = (dot(d0, d2) / l0 + dot(d1, d2) / l1) / l2;
    g2 = 1.0 + dot(d0, d1) / l0 / l1;
    solidAngle = 2.0 * std::atan2(g0, g1 + g2);
  }

  // A point in the plane is rounded to one that may be this far above it. It sees nothing.
  double roundingOf(const Point& x) const {
    constexpr double kRoundoffs = 4.0, kUnitRoundoff = 0x1p-24;
    const Double3 size = abs(Double3(x)) + abs(p0) + abs(edge1) + abs(edge2);
    return kRoundoffs * kUnitRoundoff * std::max({size.x, size.y, size.z});
  }

  // Per unit area, of a point at p that is chosen by the solid angle `whole`.
  float density(const Point& p, const Point& x, double whole) const {
    const Double3 toPoint = Double3(p) - Double3(x);
    const double distance2 = dot(toPoint, toPoint);
    return static_cast<float>(height / (distance2 * std::sqrt(distance2)) / whole);
  }

  // The point in a direction that is uniform in the spherical triangle. The plane through v1 that
  // cuts off the share s of it meets the edge from v0 to v2 at c; the direction lies between v1 and
  // c, where equal steps of t sweep equal areas (Arvo 1995, by the form of Peters 2021). It is
  // never put together: what counts are its shares of v0, v1 and v2.
  Point sample(double s, double t) const {
    const double half = 0.5 * s * solidAngle, sine = std::sin(half) / g0;
    // Halfway between v0 and c is alpha v0 + beta v2, but for its length.
    const double alpha = std::cos(half) - g1 * sine, beta = g2 * sine;
    const double difference = std::max(alpha - beta, 0.0);
    const Double3 v0 = d0 / l0;
    const Double3 chord1 = (edge1 - v0 * (dot(edge1, d0 + d1) / (l0 + l1))) / l1;  // v1 - v0
    const Double3 chord2 = (edge2 - v0 * (dot(edge2, d0 + d2) / (l0 + l2))) / l2;  // v2 - v0
    const double oneMinusCos = 0.5 * dot(chord2, chord2);  // of the angle between v0 and v2
    const double norm2 = difference * difference + 2.0 * alpha * beta * (2.0 - oneMinusCos);
    const double c0 = difference * (alpha + beta) / norm2;
    const double c2 = 2.0 * beta * (alpha + beta - beta * oneMinusCos) / norm2;

    const Double3 chord =
        chord1 - c2 * chord2 - v0 * (2.0 * beta * difference * oneMinusCos / norm2);
    constexpr double kSmallest = 0x1p-52;       // of 2 - h1, where the arc ends opposite of v1
    const double h1 = 0.5 * dot(chord, chord);  // 1 - cos of the angle between v1 and c
    const double h = t * h1;
    const double shareC = std::sqrt(t * (2.0 - h) / std::max(2.0 - h1, kSmallest));
    const double share1 = std::max(1.0 - h - shareC * (1.0 - h1), 0.0);

    const double b0 = shareC * c0 / l0, b1 = share1 / l1, b2 = shareC * c2 / l2;
    return Point(p0 + (b1 / (b0 + b1 + b2)) * edge1 + (b2 / (b0 + b1 + b2)) * edge2);
  }
};

}  // namespace

LightSample Polygon::SphericalTriangleSampling(const Point& from, float s, float t) const {
  const SeenTriangle seen(p(0), p(1), p(2), from);
  if (!(seen.solidAngle > 0.0)) return {p(0), normal(), 0.0f};
  const Point y = seen.sample(s, t);
  return {y, normal(), seen.density(y, from, seen.solidAngle)};
}

float Polygon::SphericalTrianglePdf(const Point& from, const Point& y) const {
  const SeenTriangle seen(p(0), p(1), p(2), from);
  return seen.solidAngle > 0.0 ? seen.density(y, from, seen.solidAngle) : 0.0f;
}

// As two triangles, of which s chooses one by its solid angle and is then used once more.
LightSample Polygon::SphericalRectangleSampling(const Point& from, float s, float t) const {
  const SeenTriangle first(p(0), p(1), p(2), from), second(p(0), p(2), p(3), from);
  const double whole = first.solidAngle + second.solidAngle;
  if (!(first.solidAngle > 0.0 && second.solidAngle > 0.0)) return {p(0), normal(), 0.0f};
  const double target = s * whole;
  const Point y =
      target < first.solidAngle
          ? first.sample(target / first.solidAngle, t)
          : second.sample(std::min((target - first.solidAngle) / second.solidAngle, 1.0), t);
  return {y, normal(), first.density(y, from, whole)};
}

float Polygon::SphericalRectanglePdf(const Point& from, const Point& y) const {
  const SeenTriangle first(p(0), p(1), p(2), from), second(p(0), p(2), p(3), from);
  if (!(first.solidAngle > 0.0 && second.solidAngle > 0.0)) return 0.0f;
  return first.density(y, from, first.solidAngle + second.solidAngle);
}

}  // namespace pathmark
