// Part 9, bonus: lights by the solid angle that they fill. Handout: handouts/part9_solid_angle.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// A triangle as seen from a point x, which is the origin here. All that cancels for small and far
// triangles is made of their edges, which are exact, and not of differences of unit vectors.
struct SeenTriangle {
  Point p0;
  Vector edge1, edge2;  // from p0 to p1 and p2
  Vector d0, d1, d2;    // from x to the corners,
  float l0, l1, l2;     // and their lengths
  float height;         // of x over the plane; not above 0: the front is not seen

  // Of the unit vectors v0, v1, v2: their volume |v0 . (v1 x v2)|, (v0 + v1) . v2 and 1 + v0 . v1.
  float g0 = 0.0f, g1 = 0.0f, g2 = 0.0f;
  float solidAngle = 0.0f;

  SeenTriangle(const Point& a, const Point& b, const Point& c, const Point& x)
      : p0(a), edge1(b - a), edge2(c - a), d0(a - x), d1(b - x), d2(c - x) {
    const Vector normal = cross(edge1, edge2);
    const float volume = -dot(d0, normal);
    height = volume / length(normal);
    if (!(volume > 0.0f)) return;
    l0 = length(d0), l1 = length(d1), l2 = length(d2);
    g0 = volume / l0 / l1 / l2;
    g1 = (dot(d0, d2) / l0 + dot(d1, d2) / l1) / l2;
    g2 = 1.0f + dot(d0, d1) / l0 / l1;
    solidAngle = 2.0f * std::atan2(g0, g1 + g2);
  }

  // Per unit area, of a point at p that is chosen by the solid angle `whole`.
  float density(const Point& p, const Point& x, float whole) const {
    const Vector toPoint = p - x;
    const float distance2 = dot(toPoint, toPoint);
    return height / (distance2 * std::sqrt(distance2)) / whole;
  }

  // The point in a direction that is uniform in the spherical triangle. The plane through v1 that
  // cuts off the share s of it meets the edge from v0 to v2 at c; the direction lies between v1 and
  // c, where equal steps of t sweep equal areas (Arvo 1995, by the form of Peters 2021). It is
  // never put together: what counts are its shares of v0, v1 and v2.
  Point sample(float s, float t) const {
    const float half = 0.5f * s * solidAngle, sine = std::sin(half) / g0;
    // Halfway between v0 and c is alpha v0 + beta v2, but for its length.
    const float alpha = std::cos(half) - g1 * sine, beta = g2 * sine;
    const float difference = std::max(alpha - beta, 0.0f);
    const Vector v0 = d0 / l0;
    const Vector chord1 = (edge1 - v0 * (dot(edge1, d0 + d1) / (l0 + l1))) / l1;  // v1 - v0
    const Vector chord2 = (edge2 - v0 * (dot(edge2, d0 + d2) / (l0 + l2))) / l2;  // v2 - v0
    const float oneMinusCos = 0.5f * dot(chord2, chord2);  // of the angle between v0 and v2
    const float norm2 = difference * difference + 2.0f * alpha * beta * (2.0f - oneMinusCos);
    const float c0 = difference * (alpha + beta) / norm2;
    const float c2 = 2.0f * beta * (alpha + beta - beta * oneMinusCos) / norm2;

    const Vector chord =
        chord1 - c2 * chord2 - v0 * (2.0f * beta * difference * oneMinusCos / norm2);
    const float h1 = 0.5f * dot(chord, chord);  // 1 - cos of the angle between v1 and c
    const float h = t * h1;
    const float shareC = std::sqrt(t * (2.0f - h) / (2.0f - h1));
    const float share1 = std::max(1.0f - h - shareC * (1.0f - h1), 0.0f);

    const float b0 = shareC * c0 / l0, b1 = share1 / l1, b2 = shareC * c2 / l2;
    return p0 + (b1 / (b0 + b1 + b2)) * edge1 + (b2 / (b0 + b1 + b2)) * edge2;
  }
};

}  // namespace

LightSample Polygon::SphericalTriangleSampling(const Point& from, float s, float t) const {
  const SeenTriangle seen(p(0), p(1), p(2), from);
  if (!(seen.solidAngle > 0.0f)) return {p(0), normal(), 0.0f};
  const Point y = seen.sample(s, t);
  return {y, normal(), seen.density(y, from, seen.solidAngle)};
}

float Polygon::SphericalTrianglePdf(const Point& from, const Point& y) const {
  const SeenTriangle seen(p(0), p(1), p(2), from);
  return seen.solidAngle > 0.0f ? seen.density(y, from, seen.solidAngle) : 0.0f;
}

// As two triangles, of which s chooses one by its solid angle and is then used once more.
LightSample Polygon::SphericalRectangleSampling(const Point& from, float s, float t) const {
  const SeenTriangle first(p(0), p(1), p(2), from), second(p(0), p(2), p(3), from);
  const float whole = first.solidAngle + second.solidAngle;
  if (!(first.solidAngle > 0.0f && second.solidAngle > 0.0f)) return {p(0), normal(), 0.0f};
  const float target = s * whole;
  const Point y =
      target < first.solidAngle
          ? first.sample(target / first.solidAngle, t)
          : second.sample(std::min((target - first.solidAngle) / second.solidAngle, 1.0f), t);
  return {y, normal(), first.density(y, from, whole)};
}

float Polygon::SphericalRectanglePdf(const Point& from, const Point& y) const {
  const SeenTriangle first(p(0), p(1), p(2), from), second(p(0), p(2), p(3), from);
  if (!(first.solidAngle > 0.0f && second.solidAngle > 0.0f)) return 0.0f;
  return first.density(y, from, first.solidAngle + second.solidAngle);
}

}  // namespace pathmark
