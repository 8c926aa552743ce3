// Light::sample: hands the sample on to the function of part 2 that belongs to the light's shape.
#include "math/rounding.h"

#include <pathmark/lit_scene.h>

namespace pathmark {

namespace {

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
