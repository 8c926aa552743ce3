// Part 0: a path tracer for a triangle mesh. Handout: handouts/part0_warmup.md
#include <pathmark/coursework.h>

namespace pathmark {

// Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997: solves
// origin + t direction = p0 + b1 e1 + b2 e2 by Cramer's rule.
bool ray_triangle_intersection(float& t, const Ray& ray, const Triangle& triangle) {
  const vec3 e1 = triangle.positions[1] - triangle.positions[0];
  const vec3 e2 = triangle.positions[2] - triangle.positions[0];
  const vec3 q = cross(ray.direction, e2);
  const float determinant = dot(e1, q);
  if (determinant == 0.0f) return false;  // parallel to the plane, or no area
  const vec3 s = ray.origin - triangle.positions[0];
  const vec3 r = cross(s, e1);
  const float b1 = dot(s, q) / determinant;
  const float b2 = dot(ray.direction, r) / determinant;
  const float distance = dot(e2, r) / determinant;
  if (!(b1 >= 0.0f && b2 >= 0.0f && b1 + b2 <= 1.0f && distance > 0.0f)) return false;
  t = distance;
  return true;
}

bool ray_mesh_intersection(float& t, Triangle& triangle, const Ray& ray, const Mesh& mesh) {
  bool found = false;
  for (const Triangle& candidate : mesh.triangles) {
    float distance = 0.0f;
    if (ray_triangle_intersection(distance, ray, candidate) && (!found || distance < t)) {
      t = distance;
      triangle = candidate;
      found = true;
    }
  }
  return found;
}

// Only the upper 24 bits become the number: 32 bits times 2^-32 can round to exactly 1 in float.
vec2 get_random_numbers(uvec2& seed) {
  seed = 1664525u * seed + 1013904223u;
  seed.x += 1664525u * seed.y;
  seed.y += 1664525u * seed.x;
  seed ^= seed >> 16u;
  seed.x += 1664525u * seed.y;
  seed.y += 1664525u * seed.x;
  seed ^= seed >> 16u;
  return vec2(seed >> 8u) * 0x1p-24f;
}

// The radius of the circle at height z is sqrt(1 - z^2) = 2 sqrt(u (1 - u)), which does not
// cancel next to the poles.
vec3 sample_sphere(vec2 u) {
  const float z = 2.0f * u.y - 1.0f;
  const float radius = 2.0f * std::sqrt(u.y * (1.0f - u.y));
  const float azimuth = 2.0f * kPi * u.x;
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

// A direction below the plane is mirrored in it.
vec3 sample_hemisphere(vec2 u, vec3 n) {
  const vec3 omega = sample_sphere(u);
  const float height = dot(n, omega);
  return height < 0.0f ? omega - 2.0f * height * n : omega;
}

vec3 compute_direct_illumination(vec3 point, const Triangle& triangle, const Mesh& mesh,
                                 uvec2& seed) {
  vec3 radiance = triangle.emission;
  const vec3 omega = sample_hemisphere(get_random_numbers(seed), triangle.normal);
  float t = 0.0f;
  Triangle seen;
  if (ray_mesh_intersection(t, seen, spawn_ray(point, triangle, omega), mesh))
    radiance += 2.0f * triangle.colour * seen.emission * dot(triangle.normal, omega);
  return radiance;
}

vec3 get_ray_radiance(vec3 origin, vec3 direction, const Mesh& mesh, uvec2& seed) {
  vec3 radiance(0.0f), throughput(1.0f);
  Ray ray{origin, direction};
  for (int hits = 0; hits < MAX_PATH_LENGTH; ++hits) {
    float t = 0.0f;
    Triangle triangle;
    if (!ray_mesh_intersection(t, triangle, ray, mesh)) break;
    radiance += throughput * triangle.emission;
    const vec3 omega = sample_hemisphere(get_random_numbers(seed), triangle.normal);
    throughput *= 2.0f * triangle.colour * dot(triangle.normal, omega);
    ray = spawn_ray(ray.origin + t * ray.direction, triangle, omega);
  }
  return radiance;
}

}  // namespace pathmark
