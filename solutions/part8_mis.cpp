// Part 8, bonus: multiple importance sampling. Handout: handouts/part8_mis.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

// Which lights a hit takes its light samples from: few are all sampled, and of many one is chosen
// in proportion to what it could contribute, as in part 2. Here the probability is also asked for a
// light that the path has met by itself.
class LightChoice {
 public:
  LightChoice() = default;
  LightChoice(std::span<const Light> lights, const Hit& hit) : x_(hit.p), n_(hit.n) {
    constexpr std::size_t kFew = 2;
    if (lights.size() <= kFew) return;
    one_ = true;
    for (const Light& light : lights) total_ += light.roughIrradiance(x_, n_);
  }

  bool takesOne() const { return one_; }

  float probability(const Light& light) const {
    if (!one_) return 1.0f;
    return total_ > 0.0f ? light.roughIrradiance(x_, n_) / total_ : 0.0f;
  }

  // Null if no light can contribute.
  const Light* choose(std::span<const Light> lights, float u) const {
    const Light* last = nullptr;
    float target = u * total_;
    for (const Light& light : lights) {
      const float share = light.roughIrradiance(x_, n_);
      if (share == 0.0f) continue;
      last = &light;
      if (target < share) break;
      target -= share;
    }
    return last;
  }

 private:
  Point x_{0.0f};
  Vector n_{0.0f};
  bool one_ = false;
  float total_ = 0.0f;
};

// What one point of a light contributes to the radiance from `hit` towards wo, weighted against the
// BRDF's finding it.
Colour lightFrom(const Light& light, float probability, const LitScene& scene, const Hit& hit,
                 const Vector& wo, const vec2& st) {
  const LightSample y = light.sample(hit.p, st.x, st.y);
  const float density = probability * solidAnglePdf(hit.p, y);
  if (density == 0.0f) return Colour(0.0f);
  const Vector wi = normalize(y.p - hit.p);
  const float cosX = dot(hit.n, wi);
  if (cosX <= 0.0f || !scene.visible(hit, y)) return Colour(0.0f);
  const float weight = powerHeuristic(density, hit.brdf->pdf(wo, wi, hit.n));
  return light.emission() * hit.brdf->brdf(wo, wi, hit.n) * (cosX * weight / density);
}

Colour weightedLight(const LightChoice& choice, const LitScene& scene, const Hit& hit,
                     const Vector& wo, Sampler& sampler) {
  const std::span<const Light> lights = scene.lights();
  if (choice.takesOne()) {
    const Light* light = choice.choose(lights, sampler.next1D());
    const vec2 st = sampler.next2D();
    if (light == nullptr) return Colour(0.0f);
    return lightFrom(*light, choice.probability(*light), scene, hit, wo, st);
  }
  Colour radiance(0.0f);
  for (const Light& light : lights)
    radiance += lightFrom(light, 1.0f, scene, hit, wo, sampler.next2D());
  return radiance;
}

}  // namespace

// By the ratio of the densities, whose square may overflow to infinity and then says the same.
float powerHeuristic(float a, float b) {
  if (a == 0.0f) return 0.0f;
  const float ratio = a == b ? 1.0f : b / a;
  return 1.0f / (1.0f + ratio * ratio);
}

float solidAnglePdf(const Point& from, const LightSample& y) {
  const Vector back = from - y.p;
  const float distance2 = dot(back, back), height = dot(y.n, back);
  if (!(height > 0.0f)) return 0.0f;
  return y.pdf * distance2 * (std::sqrt(distance2) / height);
}

// A light that the path meets was direct light of the hit before, whose samples could have found it
// too.
Colour LitScene::tracePathMIS(const Ray& cameraRay, Sampler& sampler) const {
  Colour radiance(0.0f), throughput(1.0f);
  Ray ray = cameraRay;
  Hit hit;
  Point before(0.0f);      // the hit before, where the ray's direction was drawn,
  float density = 0.0f;    // with this density per unit solid angle,
  LightChoice fromBefore;  // and these lights were sampled
  for (int depth = 0; intersect(ray, hit); ++depth) {
    const Vector wo = -ray.direction;

    if (const Colour emitted = hit.emitted(wo); emitted != Colour(0.0f)) {
      float weight = 1.0f;
      if (depth > 0) {
        const LightSample y{hit.p, hit.n, hit.light->pdf(before, hit)};
        weight =
            powerHeuristic(density, fromBefore.probability(*hit.light) * solidAnglePdf(before, y));
      }
      radiance += throughput * emitted * weight;
    }
    if (depth == maxBounces()) break;
    fromBefore = LightChoice(lights(), hit);
    radiance += throughput * weightedLight(fromBefore, *this, hit, wo, sampler);

    const vec2 st = sampler.next2D();
    const DirectionSample next = hit.brdf->reflection(wo, hit.n, st.x, st.y, sampler.next1D());
    if (next.pdf == 0.0f) break;
    throughput *= hit.brdf->brdf(wo, next.wi, hit.n) * (dot(hit.n, next.wi) / next.pdf);

    const Roulette roulette = RussianRoulette(throughput, depth + 1, sampler.next1D());
    if (!roulette.survives) break;
    throughput *= roulette.weight;
    before = hit.p;
    density = next.pdf;
    ray = hit.spawnRay(next.wi);
  }
  return radiance;
}

}  // namespace pathmark
