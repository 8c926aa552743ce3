// LitScene: a scene with its lights, and the integrals that make a picture of it.
//
//   intersect, visible, lights, maxBounces   what the scene can tell           (given)
//   renderPixel                              the mean over a pixel's rays      (part 1)
//   directLighting                           light that comes from the lights  (part 2)
//   tracePath                                light that comes along a path     (part 5)
//   RussianRoulette                          when to end a path                (part 6)
//   tracePathMIS                             both ways to find the lights      (part 8, bonus)
//
//   Hit     where a ray meets a surface      Light   a shape that emits
//   powerHeuristic, solidAnglePdf            weights of samples, densities     (part 8, bonus)
#pragma once

#include <pathmark/brdf.h>
#include <pathmark/camera.h>
#include <pathmark/sampler.h>
#include <pathmark/shapes.h>
#include <pathmark/types.h>

#include <span>

namespace pathmark {

class Light;
class SceneCore;

// A point of a surface.
struct Hit {
  Point p{0.0f};
  Vector n{0.0f, 1.0f, 0.0f};  // unit geometric normal of the front, never flipped
  const BRDF* brdf = nullptr;  // never null after LitScene::intersect has returned true
  Colour emission{0.0f};       // radiance that the front emits, the same in all directions
  float error = 0.0f;          // bound on the rounding error of p, a length

  // What the surface emits with, if it is part of a light; null if it emits nothing.
  const Light* light = nullptr;

  // Radiance emitted towards wo: `emission` from the front, 0 from the back.
  Colour emitted(const Vector& wo) const { return dot(wo, n) > 0.0f ? emission : Colour(0.0f); }

  // The ray that leaves the surface here towards wi. Its origin is moved off the surface by a
  // little more than the rounding error of p (Waechter & Binder, Ray Tracing Gems, chapter 6),
  // so that it does not meet the same surface again: no epsilon is needed anywhere else. It starts
  // on the front where dot(wi, n) >= 0, and else on the back.
  Ray spawnRay(const Vector& wi) const;
};

class Light {
 public:
  // Radiance that leaves the front of the light, the same at all its points in all directions.
  const Colour& emission() const { return emission_; }

  // A point of the light chosen for lighting the point `from`, by the function of part 2 that
  // belongs to its shape; n is the normal of the emitting side; density per unit area. The
  // density 0 says that the light sends nothing to `from` by this sample. s, t in [0,1).
  LightSample sample(const Point& from, float s, float t) const;

  // The density per unit area with which `sample(from, ...)` returns the point at.p, where a ray
  // has met this light (at.light is it): 0 where it never does. For bonus part 8.
  float pdf(const Point& from, const Hit& at) const;

  // Roughly the irradiance (W m^-2) that the light causes at the point x of a surface with the unit
  // normal n, if nothing lies between: its emission, as a mean over the channels, times area and
  // cosines over the squared distance, seen as from its centre, and at most pi times the emission.
  // It is 0 only where the light causes none, so that lights may be chosen in proportion to it.
  float roughIrradiance(const Point& x, const Vector& n) const;

  struct Face {
    Polygon polygon;
    float cumulativeArea;  // share of the light's area in this face and those before it, (0,1]
    LightSample (Polygon::*sample)(float s, float t) const;  // of part 2, by the face's shape

    // Of part 9, in place of `sample` where they are not null.
    LightSample (Polygon::*sampleFrom)(const Point& from, float s, float t) const = nullptr;
    float (Polygon::*pdfFrom)(const Point& from, const Point& p) const = nullptr;

    Face(const Polygon& face, float cumulative, bool bySolidAngle);
  };

  // At least one face; they must outlive the light.
  Light(std::span<const Face> faces, const Colour& emission);
  // `inward`: the front is the inside. `seenThrough`: rays pass through the sphere's back.
  Light(const Sphere& sphere, bool inward, bool seenThrough, const Colour& emission);

 private:
  std::span<const Face> faces_;  // empty for a sphere
  Sphere sphere_;                // the light, or one around its faces
  bool inward_ = false, seenThrough_ = false;
  Colour emission_;
  float meanEmission_;
  float area_;              // of the faces, or of the disc as which the sphere is seen
  bool hasNormal_ = false;  // whether all points have the same
  Vector normal_{0.0f};
};

class LitScene {
 public:
  LitScene(const SceneCore& core, int maxBounces) : core_(&core), maxBounces_(maxBounces) {}

  // The nearest surface along the ray, whose direction has unit length: returns whether there is
  // one, and then sets `hit`. A ray that is not finite meets nothing.
  bool intersect(const Ray& ray, Hit& hit) const;

  // Whether nothing lies between `from` and the point `to` of a light, which it is looked at from
  // the side of to.n. `from` is as intersect has set it, to.n has unit length.
  bool visible(const Hit& from, const LightSample& to) const;

  // All lights, in the same order in all calls for a path; there may be none. They last as long as
  // the scene.
  std::span<const Light> lights() const;

  // The largest number of scattering events on a path, B >= 0: with 0 only the light that comes
  // straight from a light is seen, with 1 direct light, with 8 direct light and seven bounces.
  int maxBounces() const { return maxBounces_; }

  // Part 1. The mean radiance of exactly nRaysPerPixel rays through pixel (i, j), column i and
  // row j: with n = floor(sqrt(nRaysPerPixel)), one ray in each of the n x n strata and the rest
  // anywhere in the pixel. Calls sampler.startRay(m) before the m-th ray, m = 0, 1, 2, ...
  Colour renderPixel(int i, int j, const SimpleCamera& camera, int nRaysPerPixel,
                     Sampler& sampler) const;

  // Part 2. The radiance that leaves `hit` towards wo after exactly one scattering event: the sum
  // over the lights of an estimate of the integral of Le f V G over the light's area, with
  // G = cos(theta_x) cos(theta_y) / r^2. wo: unit length, away from the surface; 0 towards the
  // back.
  Colour directLighting(const Hit& hit, const Vector& wo, Sampler& sampler) const;

  // Part 5. The radiance that comes back along a camera ray: an unbiased estimate, with one
  // path, of all light with at most maxBounces() scattering events.
  Colour tracePath(const Ray& ray, Sampler& sampler) const;

  // Part 6. Whether a path with this throughput goes on after its `depth`-th scattering event
  // (depth = 1, 2, ...): it survives with a probability q that may depend on both, then its
  // weight is 1/q. u in [0,1).
  Roulette RussianRoulette(const Colour& throughput, int depth, float u) const;

  // Part 8, bonus. What tracePath returns in the mean, by multiple importance sampling: the
  // direct light of each vertex is looked for both in points of the lights and along the direction
  // that the path takes next, and what is found is weighted by powerHeuristic.
  Colour tracePathMIS(const Ray& ray, Sampler& sampler) const;

 private:
  const SceneCore* core_;
  int maxBounces_;
};

// Part 8, bonus. The weight a^2 / (a^2 + b^2) of a sample, in [0,1]: a is the density with which it
// was drawn, b that with which the other technique would have drawn it, both of the same measure,
// in [0, inf]. 0 for a = 0; where both are infinite, 1/2. Veach 1997, section 9.2.2, exponent 2.
float powerHeuristic(float a, float b);

// Part 8, bonus. The density of y per unit solid angle, as seen from the point `from`: y.pdf, which
// is per unit area, times r^2 / cos(theta_y), theta_y the angle at y between y.n and the direction
// to `from`. 0 where y.pdf is 0, where `from` does not see the front (cos(theta_y) <= 0), and where
// it is y itself. Veach 1997, section 8.2.2.2.
float solidAnglePdf(const Point& from, const LightSample& y);

}  // namespace pathmark
