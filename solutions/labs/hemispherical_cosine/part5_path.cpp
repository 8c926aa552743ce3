// Lab: the hemispherical form, directions in proportion to the cosine. Handout: handouts/labs.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// In proportion to the cosine to n: uniform on the unit disc, lifted to the hemisphere.
DirectionSample sampleDirection(const Vector& n, Sampler& sampler) {
  const vec2 st = sampler.next2D();
  const vec2 onDisc = std::sqrt(1.0f - st.y) * onUnitCircle(st.x);
  const float cosTheta = std::sqrt(st.y);
  return {Frame(n).toWorld({onDisc.x, cosTheta, onDisc.y}), cosTheta * kInvPi};
}

}  // namespace

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

    const DirectionSample next = sampleDirection(hit.n, sampler);
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
