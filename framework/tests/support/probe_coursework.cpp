// Coursework for tests of the framework's own functions: each sampling function answers with a
// density that names it.
#include "support/probe_coursework.h"

#include <pathmark/coursework.h>

namespace pathmark {

using namespace test;

bool ray_triangle_intersection(float&, const Ray&, const Triangle&) { return false; }
bool ray_mesh_intersection(float&, Triangle&, const Ray&, const Mesh&) { return false; }
vec2 get_random_numbers(uvec2&) { return vec2(0.5f); }
vec3 sample_sphere(vec2) { return vec3(0, 0, 1); }
vec3 sample_hemisphere(vec2, vec3 n) { return n; }
vec3 compute_direct_illumination(vec3, const Triangle&, const Mesh&, uvec2&) { return vec3(0); }
vec3 get_ray_radiance(vec3, vec3, const Mesh&, uvec2&) { return vec3(0); }

Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float, float) const { return {}; }
Colour LitScene::renderPixel(int, int, const SimpleCamera&, int, Sampler&) const {
  return Colour(0);
}

LightSample Polygon::TriangularSampling(float s, float t) const {
  return {Point(s, t, 0), normal(), kTriangularDensity};
}
LightSample Polygon::RectangularSampling(float s, float t) const {
  return {Point(s, t, 0), normal(), kRectangularDensity};
}
LightSample Polygon::PolygonSampling(float s, float t) const {
  return {Point(s, t, 0), normal(), kPolygonDensity};
}
LightSample Sphere::sample(const Point& from, float, float) const {
  return {from, Vector(0, 1, 0), kSphereDensity};
}
float Sphere::pdf(const Point&, const Point&, const Vector&) const { return kSphereDensity; }
Colour LitScene::directLighting(const Hit&, const Vector&, Sampler&) const { return Colour(0); }

Colour lambertianBRDF::brdf(const Vector&, const Vector&, const Vector&) const { return Kd; }
float lambertianBRDF::pdf(const Vector&, const Vector&, const Vector&) const { return 1; }
DirectionSample lambertianBRDF::reflection(const Vector&, const Vector& n, float, float,
                                           float) const {
  return {n, 1};
}
Colour phongBRDF::brdf(const Vector&, const Vector&, const Vector&) const { return Kd; }
float phongBRDF::pdf(const Vector&, const Vector&, const Vector&) const { return 1; }
DirectionSample phongBRDF::reflection(const Vector&, const Vector& n, float, float, float) const {
  return {n, 1};
}
Colour LitScene::tracePath(const Ray&, Sampler&) const { return Colour(0); }
Roulette LitScene::RussianRoulette(const Colour&, int, float) const { return {true, 1}; }

float powerHeuristic(float, float) { return 1; }
float solidAnglePdf(const Point&, const LightSample&) { return 1; }
Colour LitScene::tracePathMIS(const Ray&, Sampler&) const { return Colour(0); }

LightSample Polygon::SphericalTriangleSampling(const Point& from, float, float) const {
  return {from, normal(), kSphericalTriangleDensity};
}
float Polygon::SphericalTrianglePdf(const Point&, const Point&) const {
  return kSphericalTriangleDensity;
}
LightSample Polygon::SphericalRectangleSampling(const Point& from, float, float) const {
  return {from, normal(), kSphericalRectangleDensity};
}
float Polygon::SphericalRectanglePdf(const Point&, const Point&) const {
  return kSphericalRectangleDensity;
}

}  // namespace pathmark
