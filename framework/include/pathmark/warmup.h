// Part 0, the warm-up: path tracing in a mesh of triangles, all by yourself.
//
//   Triangle, Mesh                  the scene
//   ray_triangle_intersection       where a ray hits one triangle        (you write it)
//   ray_mesh_intersection           nearest hit with all of them         (you write it)
//   get_random_numbers              PCG2D                                (you write it)
//   sample_sphere                   uniform on the sphere                (you write it)
//   sample_hemisphere               uniform on the hemisphere            (you write it)
//   compute_direct_illumination     one bounce                           (you write it)
//   get_ray_radiance                the path                             (you write it)
//   spawn_ray                       a ray that leaves a surface          (given)
//
// After Christoph Peters' path tracing workshop, whose names are kept. Emission is two-sided
// here, and only here.
#pragma once

#include <pathmark/types.h>

#include <span>

namespace pathmark {

struct Triangle {
  vec3 positions[3]{vec3(0.0f), vec3(0.0f), vec3(0.0f)};
  vec3 normal{0.0f};    // unit length, perpendicular to the triangle, to either side of it
  vec3 colour{0.0f};    // diffuse reflectance a, each channel in [0,1]
  vec3 emission{0.0f};  // radiance, the same to all directions on both sides
};

struct Mesh {
  std::span<const Triangle> triangles;
};

// A path has at most this many hits, so one bounce fewer.
inline constexpr int MAX_PATH_LENGTH = 5;

// The ray from `point` on `triangle` towards `direction`, its origin moved off the surface by a
// little more than the rounding error of `point`, so that it does not hit `triangle` again.
// `direction` has unit length.
Ray spawn_ray(const vec3& point, const Triangle& triangle, const vec3& direction);

// True if the ray hits the triangle from either side at some t > 0, and then `t` is set.
// Hits within a barycentric distance of 1e-5 of an edge may be reported or not.
bool ray_triangle_intersection(float& t, const Ray& ray, const Triangle& triangle);

// The closest of all hits, t > 0: sets `t` and `triangle` if it returns true.
bool ray_mesh_intersection(float& t, Triangle& triangle, const Ray& ray, const Mesh& mesh);

// A new seed, and two numbers in [0,1): its components over 2^32. PCG2D: Jarzynski & Olano, "Hash
// Functions for GPU Rendering", JCGT 9(3), 2020. From seed (0,0) the new seed is (0x18e431a7,
// 0x055df4d1).
vec2 get_random_numbers(uvec2& seed);

// A direction, uniform on the unit sphere: density 1/(4 pi) per unit solid angle.
// z = 2 u[1] - 1, azimuth 2 pi u[0]; u in [0,1)^2, here and below.
vec3 sample_sphere(vec2 u);

// A direction, uniform on the hemisphere around the unit vector n: density 1/(2 pi).
vec3 sample_hemisphere(vec2 u, vec3 n);

// The light that leaves `point` on `triangle` after at most one bounce (radiance), estimated
// with one uniform direction: Le(x) + a/pi * 2 pi * Le(y) (n . omega).
vec3 compute_direct_illumination(vec3 point, const Triangle& triangle, const Mesh& mesh,
                                 uvec2& seed);

// The light that comes back along a ray (radiance), estimated with one path of at most
// MAX_PATH_LENGTH hits: at each hit L += T Le, then T *= a/pi * 2 pi * (n . omega).
vec3 get_ray_radiance(vec3 origin, vec3 direction, const Mesh& mesh, uvec2& seed);

}  // namespace pathmark
