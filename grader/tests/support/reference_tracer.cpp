#include "tests/support/reference_tracer.h"

#include "tests/support/quadrature.h"

#include <cmath>
#include <numbers>

namespace pathmark::testing {

namespace {

using Vec = ReferenceTracer::Vec;

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 1e-6;

Vec toVec(const Float3& a) { return {a[0], a[1], a[2]}; }

Vec uniformHemisphere(const Vec& n, Uniforms& random) {
  const double cosine = random.nextDouble();
  return DoubleFrame(n).direction(cosine, 2.0 * kPi * random.nextDouble());
}

}  // namespace

Vec ReferenceTracer::Surfel::emitted(const Vec& wo) const {
  return glm::dot(wo, n) > 0.0 ? toVec(shape->emission) : Vec(0.0);
}

bool ReferenceTracer::intersect(const Vec& origin, const Vec& direction, Surfel& hit) const {
  hit.t = 1e300;
  for (const FlatTriangle& triangle : scene_.triangles) {
    const auto corners = viewOf(scene_).corners(triangle);
    const Vec n = toVec(triangle.normal), a = toVec(corners[0]), b = toVec(corners[1]),
              c = toVec(corners[2]);
    const double t = glm::dot(n, a - origin) / glm::dot(n, direction);
    if (!(t > 0.0 && t < hit.t)) continue;
    const Vec p = origin + t * direction;
    if (glm::dot(glm::cross(b - a, p - a), n) < 0.0 ||
        glm::dot(glm::cross(c - b, p - b), n) < 0.0 || glm::dot(glm::cross(a - c, p - c), n) < 0.0)
      continue;
    hit = {t, p, n, &scene_.shapes[triangle.shape]};
  }
  for (const FlatSphere& sphere : scene_.spheres) {
    const Vec centre = toVec(sphere.centre), f = origin - centre;
    const double r = sphere.radius, b = glm::dot(f, direction);
    const double discriminant = b * b - glm::dot(f, f) + r * r;
    if (discriminant <= 0.0) continue;
    const double root = std::sqrt(discriminant);
    const double t = -b - root > 0.0 ? -b - root : -b + root;
    if (!(t > 0.0 && t < hit.t)) continue;
    const Vec p = origin + t * direction, outward = (p - centre) / r;
    hit = {t, p, sphere.inward != 0 ? -outward : outward, &scene_.shapes[sphere.shape]};
  }
  return hit.shape != nullptr && hit.t < 1e300;
}

bool ReferenceTracer::unoccluded(const Vec& a, const Vec& b) const {
  const double distance = glm::length(b - a);
  Surfel blocker;
  return !intersect(a, (b - a) / distance, blocker) || blocker.t > distance - 2.0 * kStep;
}

Vec ReferenceTracer::brdf(const Surfel& x, const Vec& wo, const Vec& wi) const {
  if (glm::dot(wo, x.n) <= 0.0 || glm::dot(wi, x.n) <= 0.0) return Vec(0.0);
  const FlatMaterial& m = scene_.materials[x.shape->material];
  Vec value = toVec(m.kd) / kPi;
  if (m.kind == FlatMaterialKind::kPhong) {
    const double cosine = glm::dot(wi, 2.0 * glm::dot(wo, x.n) * x.n - wo);
    if (cosine > 0.0)
      value += toVec(m.ks) * ((m.exponent + 2.0) / (2.0 * kPi) * std::pow(cosine, m.exponent));
  }
  return value;
}

Vec ReferenceTracer::hemispherical(const Vec& origin, const Vec& direction, int bounces,
                                   Uniforms& random) const {
  Surfel x;
  if (!intersect(origin, direction, x)) return Vec(0.0);
  Vec radiance = x.emitted(-direction);
  if (bounces == 0) return radiance;
  const Vec wi = uniformHemisphere(x.n, random);
  const Vec weight = 2.0 * kPi * glm::dot(wi, x.n) * brdf(x, -direction, wi);
  if (weight != Vec(0.0))
    radiance += weight * hemispherical(x.p + kStep * x.n, wi, bounces - 1, random);
  return radiance;
}

// Every light in turn, a point uniform over its area: triangles, or the whole sphere.
Vec ReferenceTracer::direct(const Surfel& x, const Vec& wo, Uniforms& random) const {
  Vec sum(0.0);
  const auto add = [&](const Vec& y, const Vec& n, double area, const Float3& emission) {
    const Vec w = y - x.p;
    const double distance2 = glm::dot(w, w);
    const Vec wi = w / std::sqrt(distance2);
    const double g = glm::dot(x.n, wi) * -glm::dot(n, wi);
    if (glm::dot(x.n, wi) <= 0.0 || glm::dot(n, wi) >= 0.0) return;
    if (!unoccluded(x.p + kStep * x.n, y + kStep * n)) return;
    sum += toVec(emission) * brdf(x, wo, wi) * (g / distance2 * area);
  };
  for (const FlatTriangle& triangle : scene_.triangles) {
    const Float3& emission = scene_.shapes[triangle.shape].emission;
    if (emission == Float3{}) continue;
    const auto corners = viewOf(scene_).corners(triangle);
    const Vec a = toVec(corners[0]), e1 = toVec(corners[1]) - a, e2 = toVec(corners[2]) - a;
    double s = random.nextDouble(), t = random.nextDouble();
    if (s + t > 1.0) s = 1.0 - s, t = 1.0 - t;
    add(a + s * e1 + t * e2, toVec(triangle.normal), 0.5 * glm::length(glm::cross(e1, e2)),
        emission);
  }
  for (const FlatSphere& sphere : scene_.spheres) {
    const Float3& emission = scene_.shapes[sphere.shape].emission;
    if (emission == Float3{}) continue;
    const double r = sphere.radius;
    const Vec outward = DoubleFrame(Vec(0, 0, 1))
                            .direction(random.between(-1.0, 1.0), random.between(0.0, 2.0 * kPi));
    add(toVec(sphere.centre) + r * outward, sphere.inward != 0 ? -outward : outward,
        4.0 * kPi * r * r, emission);
  }
  return sum;
}

Vec ReferenceTracer::reflected(const Surfel& x, const Vec& wo, int bounces, int rays,
                               Uniforms& random) const {
  if (bounces == 0) return Vec(0.0);
  Vec radiance = direct(x, wo, random);
  if (bounces == 1) return radiance;
  for (int k = 0; k < rays; ++k) {
    const Vec wi = uniformHemisphere(x.n, random);
    const Vec weight = 2.0 * kPi * glm::dot(wi, x.n) * brdf(x, wo, wi);
    Surfel next;
    if (weight != Vec(0.0) && intersect(x.p + kStep * x.n, wi, next))
      radiance +=
          weight * reflected(next, -wi, bounces - 1, rays, random) / static_cast<double>(rays);
  }
  return radiance;
}

Vec ReferenceTracer::gather(const Vec& origin, const Vec& direction, int bounces, int rays,
                            Uniforms& random) const {
  Surfel x;
  if (!intersect(origin, direction, x)) return Vec(0.0);
  return x.emitted(-direction) + reflected(x, -direction, bounces, rays, random);
}

}  // namespace pathmark::testing
