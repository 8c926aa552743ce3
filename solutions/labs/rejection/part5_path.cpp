// Lab: uniform directions by rejection. Handout: handouts/labs.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// Uniform over the hemisphere around n, without a sine or a square root of a random number: points
// uniform in a cube are drawn until one lies in the unit ball, which 52 of 100 do, and its
// direction is mirrored to the side of n. Points next to the centre have no accurate direction.
DirectionSample sampleDirection(const Vector& n, Sampler& sampler) {
  for (;;) {
    const vec2 xy = sampler.next2D();
    const Vector point = 2.0f * Vector(xy.x, xy.y, sampler.next1D()) - Vector(1.0f);
    const float length2 = dot(point, point);
    if (length2 > 1.0f || length2 < 1e-6f) continue;
    const Vector wi = point / std::sqrt(length2);
    const float height = dot(wi, n);
    return {height < 0.0f ? normalize(wi - 2.0f * height * n) : wi, 0.5f * kInvPi};
  }
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
    radiance += throughput * directLighting(hit, wo, sampler);
    if (depth + 1 == maxBounces()) break;

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
