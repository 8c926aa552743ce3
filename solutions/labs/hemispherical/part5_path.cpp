// Lab: the hemispherical form, directions by the BRDF. Handout: handouts/labs.md
#include <pathmark/coursework.h>

namespace pathmark {

// The hemispherical form of the rendering equation: light is found where a path meets it, at every
// hit, and nothing is sampled on the lights.
Colour LitScene::tracePath(const Ray& cameraRay, Sampler& sampler) const {
  Colour radiance(0.0f), throughput(1.0f);
  Ray ray = cameraRay;
  Hit hit;
  for (int depth = 0; intersect(ray, hit); ++depth) {
    const Vector wo = -ray.direction;
    radiance += throughput * hit.emitted(wo);
    if (depth == maxBounces()) break;

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
