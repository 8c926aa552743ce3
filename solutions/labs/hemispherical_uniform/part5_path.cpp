// Lab: the hemispherical form, uniform directions. Handout: handouts/labs.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// Uniform over the hemisphere around n: the height of such a direction is uniform.
DirectionSample sampleDirection(const Vector& n, Sampler& sampler) {
  const vec2 st = sampler.next2D();
  const vec2 circle = std::sqrt(1.0f - st.y * st.y) * onUnitCircle(st.x);
  return {normalize(Frame(n).toWorld({circle.x, st.y, circle.y})), 0.5f * kInvPi};
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
