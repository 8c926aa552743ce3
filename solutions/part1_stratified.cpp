// Part 1: stratified camera rays. Handout: handouts/part1_stratified.md
#include <pathmark/coursework.h>

namespace pathmark {

Ray SimpleCamera::StratifiedRandomRay(int i, int j, int k, int l, int n, float s, float t) const {
  const auto strata = static_cast<float>(n);
  const float x = static_cast<float>(i) + (static_cast<float>(k) + s) / strata;
  const float y = static_cast<float>(j) + (static_cast<float>(l) + t) / strata;
  return {eye(), normalize(topLeft() + x * pixelRight() + y * pixelDown())};
}

Colour LitScene::renderPixel(int i, int j, const SimpleCamera& camera, int nRaysPerPixel,
                             Sampler& sampler) const {
  const int n = static_cast<int>(std::sqrt(static_cast<double>(nRaysPerPixel)));
  glm::dvec3 sum(0.0);
  for (int m = 0; m < nRaysPerPixel; ++m) {
    sampler.startRay(m);
    const vec2 jitter = sampler.next2D();
    const bool inStratum = m < n * n;
    const Ray ray = inStratum
                        ? camera.StratifiedRandomRay(i, j, m % n, m / n, n, jitter.x, jitter.y)
                        : camera.StratifiedRandomRay(i, j, 0, 0, 1, jitter.x, jitter.y);
    sum += tracePath(ray, sampler);
  }
  return sum / static_cast<double>(nRaysPerPixel);
}

}  // namespace pathmark
