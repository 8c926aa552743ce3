// Part 0: a path tracer for a triangle mesh, from nothing. Handout: handouts/part0_warmup.md
//
// See what you made:  ./pathmark render cornell_box --warm-up
// What is written:    ./pathmark status
#include <pathmark/coursework.h>

namespace pathmark {

// Part 0.1 (handout section 0.1): where does a ray meet a triangle?
//
// Solve  origin + t direction = p0 + b1 (p1 - p0) + b2 (p2 - p0)  for t, b1 and b2, for instance
// by Cramer's rule (Moeller & Trumbore 1997). It is a hit if b1 >= 0, b2 >= 0, b1 + b2 <= 1 and
// t > 0, from whichever side the ray comes.
//
//   ray        origin and unit direction
//   triangle   its corners are triangle.positions[0], [1], [2]; its normal may be to either side
//   t          set to the distance along the ray, in scene units, if there is a hit
//
// Returns whether there is a hit. A triangle without area is never hit.
bool ray_triangle_intersection(float& /*t*/, const Ray& /*ray*/, const Triangle& /*triangle*/) {
  PATHMARK_UNIMPLEMENTED("part0_warmup.cpp", "ray_triangle_intersection");
  return false;
}

// Part 0.2 (handout section 0.2): which triangle of the mesh does a ray meet first?
//
// Ask every triangle of mesh.triangles and keep the hit with the smallest t > 0.
//
//   t          set to the distance to that hit
//   triangle   set to a copy of the triangle that was hit
//
// Returns whether there is a hit at all.
bool ray_mesh_intersection(float& /*t*/, Triangle& /*triangle*/, const Ray& /*ray*/,
                           const Mesh& /*mesh*/) {
  PATHMARK_UNIMPLEMENTED("part0_warmup.cpp", "ray_mesh_intersection");
  return false;
}

// Part 0.3 (handout section 0.3): random numbers from a hash, PCG2D (Jarzynski & Olano 2020).
//
//   v = 1664525 v + 1013904223                     (both components, unsigned 32-bit arithmetic)
//   v.x += 1664525 v.y;  v.y += 1664525 v.x;  v ^= v >> 16
//   v.x += 1664525 v.y;  v.y += 1664525 v.x;  v ^= v >> 16
//
// The new v is the new seed, and the two numbers are v.x / 2^32 and v.y / 2^32, to six digits. They
// must lie in [0,1): take care that none rounds to 1, which 32 bits times 2^-32 in float can do.
//
//   seed   read, and set to the new v; from (0,0) it becomes (0x18e431a7, 0x055df4d1)
//
// Returns two numbers, uniform in [0,1).
vec2 get_random_numbers(uvec2& /*seed*/) {
  PATHMARK_UNIMPLEMENTED("part0_warmup.cpp", "get_random_numbers");
  return {0.5f, 0.5f};
}

// Part 0.4 (handout section 0.4): a direction that is uniform on the unit sphere.
//
// By Archimedes, the height z of such a direction is uniform in [-1,1]:
//   z = 2 u.y - 1,  azimuth = 2 pi u.x,  x = sqrt(1 - z^2) cos(azimuth),  y = ... sin(azimuth)
//
//   u   two numbers, uniform in [0,1)
//
// Returns a unit vector; its density is 1/(4 pi) per unit solid angle.
vec3 sample_sphere(vec2 /*u*/) {
  PATHMARK_UNIMPLEMENTED("part0_warmup.cpp", "sample_sphere");
  return {0.0f, 0.0f, 1.0f};
}

// Part 0.5 (handout section 0.5): a direction that is uniform on the hemisphere around n.
//
// Take a direction omega of the sphere; if it lies below the surface (n . omega < 0), mirror it:
//   omega - 2 (n . omega) n
//
//   u   two numbers, uniform in [0,1)
//   n   unit normal
//
// Returns a unit vector; its density is 1/(2 pi) per unit solid angle.
vec3 sample_hemisphere(vec2 /*u*/, vec3 n) {
  PATHMARK_UNIMPLEMENTED("part0_warmup.cpp", "sample_hemisphere");
  return n;
}

// Part 0.6 (handout section 0.6): the light that leaves a point after at most one bounce.
//
//   L = Le(x) + a/pi * 2 pi * Le(y) (n . omega)
//
// with one direction omega from sample_hemisphere around the triangle's normal n; y is where the
// ray from x towards omega first meets the mesh (Le(y) = 0 if it meets nothing), a the
// triangle's colour, Le a triangle's emission. 2 pi is one over the density of omega.
//
//   point      x, on `triangle`
//   seed       for get_random_numbers: call it once
//
// Start the ray with spawn_ray(point, triangle, omega). Returns a radiance.
vec3 compute_direct_illumination(vec3 /*point*/, const Triangle& /*triangle*/, const Mesh& /*mesh*/,
                                 uvec2& /*seed*/) {
  PATHMARK_UNIMPLEMENTED("part0_warmup.cpp", "compute_direct_illumination");
  return {0.0f, 0.0f, 0.0f};
}

// Part 0.7 (handout section 0.7): the light that comes back along a ray, by one whole path.
//
// Start with L = 0 and throughput T = 1. At each hit, at most MAX_PATH_LENGTH of them:
//   L += T Le(hit);  omega = a direction of the hemisphere;  T *= a/pi * 2 pi * (n . omega)
// and go on with the ray from the hit towards omega, by spawn_ray. Stop when the ray meets nothing.
// n is the triangle's own normal and is never turned: after a hit from behind the path goes on
// through the triangle.
//
//   origin, direction   the ray; unit direction
//   seed                for get_random_numbers: one call at each hit, of `seed` itself and no copy
//
// Returns a radiance.
vec3 get_ray_radiance(vec3 /*origin*/, vec3 /*direction*/, const Mesh& /*mesh*/, uvec2& /*seed*/) {
  PATHMARK_UNIMPLEMENTED("part0_warmup.cpp", "get_ray_radiance");
  return {0.0f, 0.0f, 0.0f};
}

}  // namespace pathmark
