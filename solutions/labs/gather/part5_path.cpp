// Lab: gather rays instead of one path. Handout: handouts/labs.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// Rays that leave each hit. The tree of a camera ray has up to kGatherRays^(B - 1) ends.
constexpr int kGatherRays = 2;

// What leaves the hit at the start of `ray` after at least one scattering event: direct light, and
// the mean of what several rays bring from the next hits.
Colour gather(const LitScene& scene, const Ray& ray, const Hit& hit, int depth, Sampler& sampler) {
  const Vector wo = -ray.direction;
  Colour radiance = scene.directLighting(hit, wo, sampler);
  if (depth + 1 == scene.maxBounces()) return radiance;
  for (int k = 0; k < kGatherRays; ++k) {
    const vec2 st = sampler.next2D();
    const DirectionSample next = hit.brdf->reflection(wo, hit.n, st.x, st.y, sampler.next1D());
    if (next.pdf == 0.0f) continue;
    const Colour weight = hit.brdf->brdf(wo, next.wi, hit.n) * (dot(hit.n, next.wi) / next.pdf);
    if (weight == Colour(0.0f)) continue;
    const Ray nextRay = hit.spawnRay(next.wi);
    Hit nextHit;
    if (scene.intersect(nextRay, nextHit))
      radiance += weight * gather(scene, nextRay, nextHit, depth + 1, sampler) /
                  static_cast<float>(kGatherRays);
  }
  return radiance;
}

}  // namespace

Colour LitScene::tracePath(const Ray& ray, Sampler& sampler) const {
  Hit hit;
  if (!intersect(ray, hit)) return Colour(0.0f);
  const Colour emitted = hit.emitted(-ray.direction);
  return maxBounces() == 0 ? emitted : emitted + gather(*this, ray, hit, 0, sampler);
}

}  // namespace pathmark
