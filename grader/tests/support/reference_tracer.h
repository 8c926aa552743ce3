// ReferenceTracer: the rendering equation solved by other means, in double.
//
//   hemispherical   uniform directions only, no direct lighting: one short estimator for all of
//                   the coursework's parts at once
//   gather          many rays at every vertex, lights sampled by area
//
// Shares no code with the coursework or with the framework's intersector: every primitive is
// asked in turn, and surfaces are left by a fixed step, which suits scenes of about unit size.
#pragma once

#include "scene/flat_scene.h"
#include "tests/support/uniforms.h"

#include <glm/glm.hpp>

namespace pathmark::testing {

class ReferenceTracer {
 public:
  using Vec = glm::dvec3;

  // The scene must outlive the tracer.
  explicit ReferenceTracer(const FlatScene& scene) : scene_(scene) {}

  // Radiance along a ray after at most `bounces` scattering events, by one path.
  Vec hemispherical(const Vec& origin, const Vec& direction, int bounces, Uniforms& random) const;

  // The same by branching: `rays` directions at each vertex.
  Vec gather(const Vec& origin, const Vec& direction, int bounces, int rays,
             Uniforms& random) const;

 private:
  struct Surfel {
    double t = 1e300;
    Vec p{0.0}, n{0.0};
    const FlatShape* shape = nullptr;
    Vec emitted(const Vec& wo) const;
  };

  bool intersect(const Vec& origin, const Vec& direction, Surfel& hit) const;
  bool unoccluded(const Vec& a, const Vec& b) const;
  Vec brdf(const Surfel& x, const Vec& wo, const Vec& wi) const;
  Vec direct(const Surfel& x, const Vec& wo, Uniforms& random) const;
  Vec reflected(const Surfel& x, const Vec& wo, int bounces, int rays, Uniforms& random) const;

  const FlatScene& scene_;
};

}  // namespace pathmark::testing
