// Stands in for part 2 where a path tracer is checked. Light is looked for in a direction that is
// uniform on the hemisphere, so that no light is ever sampled, except by bonus part 8: of a
// parallelogram and of a large sphere (sampled_sphere.h) it gets points, and of all other
// lights "no sample".
#include "checks/standins/sampled_sphere.h"
#include "checks/standins/uniform_direction.h"

#include <pathmark/coursework.h>

namespace pathmark {

LightSample Polygon::TriangularSampling(float, float) const { return {}; }
LightSample Polygon::RectangularSampling(float s, float t) const {
  LightSample y{p(0), normal(), 0.0f};
  y.p += t * (p(1) - p(0));
  y.p += s * (p(3) - p(0));
  y.pdf = 1.0f / (length(p(1) - p(0)) * length(p(3) - p(0)));
  return y;
}
LightSample Polygon::PolygonSampling(float, float) const { return {}; }
LightSample Sphere::sample(const Point&, float s, float t) const {
  if (!isSampled(*this)) return {};
  const float z = 1.0f - 2.0f * t, across = std::sqrt(std::max(1.0f - z * z, 0.0f));
  const Vector n(across * std::cos(2.0f * kPi * s), z, across * std::sin(2.0f * kPi * s));
  return {centre() + radius() * n, n, 0.25f * kInvPi / (radius() * radius())};
}
float Sphere::pdf(const Point&, const Point&, const Vector&) const {
  return isSampled(*this) ? 0.25f * kInvPi / (radius() * radius()) : 0.0f;
}

Colour LitScene::directLighting(const Hit& hit, const Vector& wo, Sampler& sampler) const {
  const vec2 uniform = sampler.next2D();
  const Vector wi = uniformDirection(hit.n, uniform.x, uniform.y);
  Hit seen;
  if (!intersect(hit.spawnRay(wi), seen)) return Colour(0.0f);
  return seen.emitted(-wi) * hit.brdf->brdf(wo, wi, hit.n) * (dot(hit.n, wi) / kUniformDensity);
}

}  // namespace pathmark
