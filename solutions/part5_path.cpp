// Part 5: the path tracer. Handout: handouts/part5_path.md
#include <pathmark/coursework.h>

namespace pathmark {

Colour LitScene::tracePath(const Ray& cameraRay, Sampler& sampler) const {
  Colour radiance(0.0f), throughput(1.0f);
  Ray ray = cameraRay;
  Hit hit;
  for (int depth = 0; intersect(ray, hit); ++depth) {
    const Vector wo = -ray.direction;

    // Further along the path, direct lighting has already counted what lights emit.
    if (depth == 0) radiance += hit.emitted(wo);
    if (depth == maxBounces()) break;
    radiance += throughput * directLighting(hit, wo, sampler);
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
