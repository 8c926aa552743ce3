// Lab: a point on every light at each hit, however many there are. Handout: handouts/labs.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// What one light contributes, estimated with one point of it.
Colour lightFrom(const Light& light, const LitScene& scene, const Hit& hit, const Vector& wo,
                 Sampler& sampler) {
  const vec2 st = sampler.next2D();
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

Colour allLights(const LitScene& scene, const Hit& hit, const Vector& wo, Sampler& sampler) {
  Colour radiance(0.0f);
  for (const Light& light : scene.lights()) radiance += lightFrom(light, scene, hit, wo, sampler);
  return radiance;
}

}  // namespace

Colour LitScene::tracePath(const Ray& cameraRay, Sampler& sampler) const {
  Colour radiance(0.0f), throughput(1.0f);
  Ray ray = cameraRay;
  Hit hit;
  for (int depth = 0; intersect(ray, hit); ++depth) {
    const Vector wo = -ray.direction;
    if (depth == 0) radiance += hit.emitted(wo);
    if (depth == maxBounces()) break;
    radiance += throughput * allLights(*this, hit, wo, sampler);
    if (depth + 1 == maxBounces()) break;

    const vec2 st = sampler.next2D();
    const DirectionSample next = hit.brdf->reflection(wo, hit.n, st.x, st.y, sampler.next1D());
    if (next.pdf == 0.0f) break;
    throughput *= hit.brdf->brdf(wo, next.wi, hit.n) * (dot(hit.n, next.wi) / next.pdf);

    const Roulette roulette = RussianRoulette(throughput, depth + 1, sampler.next1D());
    if (!roulette.survives) break;
    throughput *= roulette.weight;
    ray = hit.spawnRay(next.wi);
  }
  return radiance;
}

}  // namespace pathmark
