// Stands in for part 2 where the path tracer is checked. Light is looked for in a direction that is
// uniform on the hemisphere, so that no light is ever sampled.
#include "checks/standins/uniform_direction.h"

#include <pathmark/coursework.h>

namespace pathmark {

LightSample Polygon::TriangularSampling(float, float) const { return {}; }
LightSample Polygon::RectangularSampling(float, float) const { return {}; }
LightSample Polygon::PolygonSampling(float, float) const { return {}; }
LightSample Sphere::sample(const Point&, float, float) const { return {}; }
float Sphere::pdf(const Point&, const Point&, const Vector&) const { return 0.0f; }

Colour LitScene::directLighting(const Hit& hit, const Vector& wo, Sampler& sampler) const {
  const vec2 uniform = sampler.next2D();
  const Vector wi = uniformDirection(hit.n, uniform.x, uniform.y);
  Hit seen;
  if (!intersect(hit.spawnRay(wi), seen)) return Colour(0.0f);
  return seen.emitted(-wi) * hit.brdf->brdf(wo, wi, hit.n) * (dot(hit.n, wi) / kUniformDensity);
}

}  // namespace pathmark
