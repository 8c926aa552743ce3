// Part 2: points on lights, and direct light. Handout: handouts/part2_lights.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// Uniform by area on the triangle p0 p1 p2: sqrt(s) scales the edge p1 p2 towards p0 so that
// equal steps of s sweep equal areas.
Point pointOnTriangle(const Point& p0, const Point& p1, const Point& p2, float s, float t) {
  const float root = std::sqrt(s);
  return p0 + root * (1.0f - t) * (p1 - p0) + root * t * (p2 - p0);
}

float twiceArea(const Point& p0, const Point& p1, const Point& p2) {
  return length(cross(p1 - p0, p2 - p0));
}

// The cone of directions from x in which a sphere is seen. Everything is derived from d - r and
// sin^2 so that nothing cancels for small and far spheres, where cos(thetaMax) rounds to 1.
struct SphereCone {
  Vector toViewer;  // unit, from the centre towards x
  float d, r;       // distance of x from the centre, radius
  float sinMax;     // sine of the angle between the axis and the limb
  float cosMax;
  float oneMinusCosMax;
  bool outside;  // x is strictly outside, so that there is a cone

  SphereCone(const Sphere& sphere, const Point& x)
      : toViewer(x - sphere.centre()), d(length(toViewer)), r(sphere.radius()), outside(d > r) {
    if (!outside) return;
    toViewer /= d;
    sinMax = r / d;
    cosMax = std::sqrt((d - r) * (d + r)) / d;
    oneMinusCosMax = sinMax * sinMax / (1.0f + cosMax);
  }
};

// What one light contributes to the radiance from `hit` towards wo, estimated with one point of it.
Colour lightFrom(const Light& light, const LitScene& scene, const Hit& hit, const Vector& wo,
                 const vec2& st) {
  const LightSample y = light.sample(hit.p, st.x, st.y);
  if (y.pdf == 0.0f) return Colour(0.0f);
  const Vector toLight = y.p - hit.p;
  const float distance2 = dot(toLight, toLight);
  if (distance2 == 0.0f) return Colour(0.0f);
  const Vector wi = toLight / std::sqrt(distance2);
  const float cosX = dot(hit.n, wi), cosY = -dot(y.n, wi);
  if (cosX <= 0.0f || cosY <= 0.0f || !scene.visible(hit, y)) return Colour(0.0f);
  return light.emission() * hit.brdf->brdf(wo, wi, hit.n) * (cosX * cosY / (distance2 * y.pdf));
}

struct LightChoice {
  const Light* light = nullptr;
  float probability = 0.0f;  // 0: no light can contribute
};

// In one walk along the lights: each takes the place of the choice so far with its share of the
// total so far. What u then says within the part that was decided for is again uniform, and is used
// for the next light (Chao, "A General Purpose Unequal Probability Sampling Plan", 1982).
LightChoice chooseLight(std::span<const Light> lights, const Hit& hit, float u) {
  float total = 0.0f, chosen = 0.0f;
  LightChoice choice;
  for (const Light& light : lights) {
    const float share = light.roughIrradiance(hit.p, hit.n);
    if (share == 0.0f) continue;
    total += share;
    const float position = u * total;
    if (position < share) {
      choice.light = &light;
      chosen = share;
      u = position / share;
    } else {
      u = (position - share) / (total - share);
    }
  }
  if (choice.light != nullptr) choice.probability = chosen / total;
  return choice;
}

}  // namespace

LightSample Polygon::TriangularSampling(float s, float t) const {
  return {pointOnTriangle(p(0), p(1), p(2), s, t), normal(), 2.0f / twiceArea(p(0), p(1), p(2))};
}

LightSample Polygon::RectangularSampling(float s, float t) const {
  const Vector v1 = p(1) - p(0), v2 = p(3) - p(0);
  return {p(0) + s * v1 + t * v2, normal(), 1.0f / length(cross(v1, v2))};
}

// A triangle of the triangulation is chosen by area with s; what s then says within the chosen
// triangle's share is again uniform, and is used once more.
LightSample Polygon::PolygonSampling(float s, float t) const {
  float total = 0.0f;
  for (int k = 0; k < triangleCount(); ++k) {
    const auto [a, b, c] = triangle(k);
    total += twiceArea(a, b, c);
  }
  float target = s * total;
  for (int k = 0;; ++k) {
    const auto [a, b, c] = triangle(k);
    const float share = twiceArea(a, b, c);
    if (target < share || k + 1 == triangleCount()) {
      const float reused = std::min(target / share, 1.0f);
      return {pointOnTriangle(a, b, c, reused, t), normal(), 2.0f / total};
    }
    target -= share;
  }
}

// With theta the angle at x between the axis and the direction to the sampled point x', theta'
// the angle at x' and alpha the angle at the centre: sin(theta') = sin(theta) / sinMax,
// alpha = theta' - theta. 1 - cos(theta) = s (1 - cosMax) is uniform over the cone.
LightSample Sphere::sample(const Point& from, float s, float t) const {
  const vec2 circle = onUnitCircle(t);
  const SphereCone cone(*this, from);
  if (!cone.outside) {
    const float z = 1.0f - 2.0f * s, radius = 2.0f * std::sqrt(s * (1.0f - s));
    const Vector n(radius * circle.x, radius * circle.y, z);
    return {centre() + cone.r * n, n, pdf(from, centre() + cone.r * n, n)};
  }
  const float h = s * cone.oneMinusCosMax;
  const float cosTheta = 1.0f - h, sinTheta = std::sqrt(h * (2.0f - h));
  const float cosAtPoint =
      std::sqrt((1.0f - s) * cone.oneMinusCosMax * (cosTheta + cone.cosMax)) / cone.sinMax;
  const float sinAtPoint = std::min(sinTheta / cone.sinMax, 1.0f);
  const float sinAlpha = std::max(sinAtPoint * cosTheta - cosAtPoint * sinTheta, 0.0f);
  const float cosAlpha = cosAtPoint * cosTheta + sinAtPoint * sinTheta;
  const Vector n =
      normalize(Frame(cone.toViewer).toWorld({sinAlpha * circle.x, cosAlpha, sinAlpha * circle.y}));
  const Point p = centre() + cone.r * n;
  return {p, n, pdf(from, p, n)};
}

// Judged at c + r n: the rounding of p, which is that of the centre's coordinates, stays out.
float Sphere::pdf(const Point& from, const Point&, const Vector& n) const {
  const SphereCone cone(*this, from);
  if (!cone.outside) return 1.0f / (4.0f * kPi * cone.r * cone.r);
  const Vector toFrom = cone.d * cone.toViewer - cone.r * n;
  const float distance2 = dot(toFrom, toFrom);
  const float cosAtPoint = dot(n, toFrom) / std::sqrt(distance2);
  if (!(cosAtPoint > 0.0f)) return 0.0f;
  return cosAtPoint / (2.0f * kPi * distance2 * cone.oneMinusCosMax);
}

// Few lights are all sampled. Of many one is chosen, in proportion to what it could contribute if
// nothing lay between, so that a path costs one shadow ray at each vertex and the lights that
// matter get most of them.
Colour LitScene::directLighting(const Hit& hit, const Vector& wo, Sampler& sampler) const {
  constexpr std::size_t kFew = 2;
  if (lights().size() > kFew) {
    const LightChoice choice = chooseLight(lights(), hit, sampler.next1D());
    if (choice.probability == 0.0f) return Colour(0.0f);
    return lightFrom(*choice.light, *this, hit, wo, sampler.next2D()) / choice.probability;
  }
  Colour radiance(0.0f);
  for (const Light& light : lights())
    radiance += lightFrom(light, *this, hit, wo, sampler.next2D());
  return radiance;
}

}  // namespace pathmark
