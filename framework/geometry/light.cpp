// Light: hands samples on to the function of part 2 that belongs to its shape, and tells how much
// light to expect.
#include "math/rounding.h"

#include <pathmark/lit_scene.h>

#include <limits>

namespace pathmark {

namespace {

constexpr float kNear = 1e-5f;  // above all rounding of cosines

constexpr float kLargestBelowOne = 0x1.fffffep-1f;

bool isParallelogram(const Polygon& polygon) {
  if (polygon.vertexCount() != 4) return false;
  // As far from a parallelogram as a scene's rectangles may be, and the rounding of corners.
  constexpr float kTolerance = 2e-5f;
  const Vector gap = (polygon.p(0) - polygon.p(1)) + (polygon.p(2) - polygon.p(3));
  const float extent =
      largestComponent(polygon.p(2) - polygon.p(0)) + largestComponent(polygon.p(3) - polygon.p(1));
  const float rounding = 8.0f * kUnitRoundoff * largestComponent(polygon.p(0));
  return largestComponent(gap) <= kTolerance * extent + rounding;
}

LightSample samplePolygon(const Light::Face& face, float s, float t) {
  return (face.polygon.*face.sample)(s, t);
}

// Chooses a face by area with s. Within the chosen face's share, s is again uniform.
LightSample sampleFaces(std::span<const Light::Face> faces, float s, float t) {
  if (faces.size() == 1) return samplePolygon(faces[0], s, t);
  const auto face =
      std::upper_bound(faces.begin(), faces.end() - 1, s,
                       [](float value, const Light::Face& f) { return value < f.cumulativeArea; });
  const float below = face == faces.begin() ? 0.0f : (face - 1)->cumulativeArea;
  const float share = face->cumulativeArea - below;
  const float reused = std::clamp((s - below) / share, 0.0f, kLargestBelowOne);
  LightSample sample = samplePolygon(*face, reused, t);
  sample.pdf *= share;
  return sample;
}

float areaOf(std::span<const Light::Face> faces) {
  float area = 0.0f;
  for (const Light::Face& face : faces)
    for (int k = 0; k < face.polygon.triangleCount(); ++k) {
      const auto [a, b, c] = face.polygon.triangle(k);
      area += 0.5f * length(cross(b - a, c - a));
    }
  return area;
}

// Around the box of all vertices.
Sphere sphereAround(std::span<const Light::Face> faces) {
  Point low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (const Light::Face& face : faces)
    for (int k = 0; k < face.polygon.vertexCount(); ++k) {
      low = glm::min(low, face.polygon.p(k));
      high = glm::max(high, face.polygon.p(k));
    }
  const float rounding =
      offsetForMagnitude(std::max(largestComponent(low), largestComponent(high)));
  return {0.5f * low + 0.5f * high, 0.5f * length(high - low) + rounding};
}

// The largest cosine of the angle between a vector and the directions of a cone, from the cosine
// to its axis and the squared sine of its half angle; 0 if all are beyond 90 degrees. Rounded up,
// so that it is not 0 where one is below.
float largestCosine(float cosine, float sine2) {
  if (cosine >= 0.0f && 1.0f - cosine * cosine <= sine2) return 1.0f;
  const float away = std::sqrt(std::max(1.0f - cosine * cosine, 0.0f));
  const float largest = cosine * std::sqrt(1.0f - sine2) + away * std::sqrt(sine2);
  return std::clamp(largest + kNear, 0.0f, 1.0f);
}

// Which side of the sphere a point is on, by more than the rounding error of a point on it.
enum class Side { kInside, kOn, kOutside };

Side sideOf(const Sphere& sphere, const Point& x) {
  const glm::dvec3 fromCentre = glm::dvec3(x) - glm::dvec3(sphere.centre());
  const double distance = glm::length(fromCentre);
  const auto tolerance = static_cast<double>(4.0f * kUnitRoundoff *
                                             (largestComponent(sphere.centre()) + sphere.radius()));
  if (distance > static_cast<double>(sphere.radius()) + tolerance) return Side::kOutside;
  if (distance < static_cast<double>(sphere.radius()) - tolerance) return Side::kInside;
  return Side::kOn;
}

}  // namespace

Light::Face::Face(const Polygon& face, float cumulative)
    : polygon(face),
      cumulativeArea(cumulative),
      sample(face.vertexCount() == 3 ? &Polygon::TriangularSampling
             : isParallelogram(face) ? &Polygon::RectangularSampling
                                     : &Polygon::PolygonSampling) {}

Light::Light(std::span<const Face> faces, const Colour& emission)
    : faces_(faces),
      sphere_(sphereAround(faces)),
      projectedArea_(areaOf(faces)),
      normal_(faces.size() == 1 ? faces[0].polygon.normal() : Vector(0.0f)),
      emission_(emission) {}

Light::Light(const Sphere& sphere, bool inward, const Colour& emission)
    : sphere_(sphere),
      inward_(inward),
      projectedArea_(kPi * sphere.radius() * sphere.radius()),
      emission_(emission) {}

// Close to the light the irradiance is that of a hemisphere full of it, at most.
float Light::roughIrradiance(const Point& x, const Vector& n) const {
  const float radiance = (emission_.r + emission_.g + emission_.b) / 3.0f;
  const Vector toLight = sphere_.centre() - x;
  const float distance2 = dot(toLight, toLight), radius2 = sphere_.radius() * sphere_.radius();
  if (distance2 <= radius2 * (1.0f + kNear)) return kPi * radiance;
  const Vector wi = toLight / std::sqrt(distance2);
  const float sine2 = radius2 / distance2;  // of the angle that the sphere fills around wi
  const float cosX = largestCosine(dot(n, wi), sine2);
  const float cosY = normal_ == Vector(0.0f) ? 1.0f : largestCosine(-dot(normal_, wi), sine2);
  return radiance * std::min(projectedArea_ / distance2, kPi) * cosX * cosY;
}

// A sphere shines to one side only, and a point of its own surface may be rounded to either side:
// whether the sphere can light `from` at all is decided here.
LightSample Light::sample(const Point& from, float s, float t) const {
  if (!faces_.empty()) return sampleFaces(faces_, s, t);
  const Side side = sideOf(sphere_, from);
  const bool lit = inward_ ? side != Side::kOutside : side == Side::kOutside;
  if (!lit) return {sphere_.centre() + Vector(sphere_.radius(), 0, 0), Vector(1, 0, 0), 0.0f};
  if (!inward_) return sphere_.sample(from, s, t);
  const Point inside = side == Side::kOn ? 0.5f * (from + sphere_.centre()) : from;
  LightSample sample = sphere_.sample(inside, s, t);
  sample.n = -sample.n;
  return sample;
}

}  // namespace pathmark
