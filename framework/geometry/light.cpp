// Light: hands samples on to the function of part 2 that belongs to its shape, and tells how much
// light to expect.
#include "geometry/face_kind.h"
#include "math/rounding.h"

#include <pathmark/lit_scene.h>

#include <limits>

namespace pathmark {

namespace {

constexpr float kLargestBelowOne = 0x1.fffffep-1f;

LightSample samplePolygon(const Light::Face& face, const Point& from, float s, float t) {
  if (face.sampleFrom != nullptr) return (face.polygon.*face.sampleFrom)(from, s, t);
  return (face.polygon.*face.sample)(s, t);
}

// Chooses a face by area with s. Within the chosen face's share, s is again uniform.
LightSample sampleFaces(std::span<const Light::Face> faces, const Point& from, float s, float t) {
  if (faces.size() == 1) return samplePolygon(faces[0], from, s, t);
  const auto face =
      std::upper_bound(faces.begin(), faces.end() - 1, s,
                       [](float value, const Light::Face& f) { return value < f.cumulativeArea; });
  const float below = face == faces.begin() ? 0.0f : (face - 1)->cumulativeArea;
  const float share = face->cumulativeArea - below;
  const float reused = std::clamp((s - below) / share, 0.0f, kLargestBelowOne);
  LightSample sample = samplePolygon(*face, from, reused, t);
  sample.pdf *= share;
  return sample;
}

float mean(const Colour& c) { return (c.r + c.g + c.b) / 3.0f; }

float areaOf(std::span<const Light::Face> faces) {
  float area = 0.0f;
  for (const Light::Face& face : faces)
    for (int k = 0; k < face.polygon.triangleCount(); ++k) {
      const auto [a, b, c] = face.polygon.triangle(k);
      area += 0.5f * length(cross(b - a, c - a));
    }
  return area;
}

auto samplingOf(const Polygon& face) {
  switch (faceKind(face)) {
    case FaceKind::kTriangle:
      return &Polygon::TriangularSampling;
    case FaceKind::kParallelogram:
      return &Polygon::RectangularSampling;
    case FaceKind::kPolygon:
      break;
  }
  return &Polygon::PolygonSampling;
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

// From outside, the inside shines through a back that rays pass through.
bool isLit(Side side, bool inward, bool seenThrough) {
  return inward ? seenThrough || side != Side::kOutside : side == Side::kOutside;
}

// `from`, or for another point one that is surely inside, from where all of the sphere is seen.
Point inside(const Sphere& sphere, const Point& from, Side side) {
  switch (side) {
    case Side::kInside:
      return from;
    case Side::kOn:
      return 0.5f * (from + sphere.centre());
    case Side::kOutside:
      break;
  }
  return sphere.centre();
}

}  // namespace

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

Light::Face::Face(const Polygon& face, float cumulative, bool bySolidAngle)
    : polygon(face), cumulativeArea(cumulative), sample(samplingOf(face)) {
  if (!bySolidAngle) return;
  if (faceKind(face) == FaceKind::kTriangle) {
    sampleFrom = &Polygon::SphericalTriangleSampling;
    pdfFrom = &Polygon::SphericalTrianglePdf;
  } else if (isRectangle(face)) {
    sampleFrom = &Polygon::SphericalRectangleSampling;
    pdfFrom = &Polygon::SphericalRectanglePdf;
  }
}

Light::Light(std::span<const Face> faces, const Colour& emission)
    : faces_(faces),
      sphere_(sphereAround(faces)),
      emission_(emission),
      meanEmission_(mean(emission)),
      area_(areaOf(faces)),
      hasNormal_(faces.size() == 1),
      normal_(faces.front().polygon.normal()) {}

Light::Light(const Sphere& sphere, bool inward, bool seenThrough, const Colour& emission)
    : sphere_(sphere),
      inward_(inward),
      seenThrough_(seenThrough),
      emission_(emission),
      meanEmission_(mean(emission)),
      area_(kPi * sphere.radius() * sphere.radius()) {}

// For cosines stand the heights of the highest point of the sphere around the light over the
// surface, and of x over the light, by the distance: that costs no angles, and is 0 only where the
// sphere is below the horizon or behind the light. Close to it the irradiance is that of a
// hemisphere full of light, at most.
float Light::roughIrradiance(const Point& x, const Vector& n) const {
  const Vector toLight = sphere_.centre() - x;
  const float radius = sphere_.radius();
  const float distance2 = std::max(dot(toLight, toLight), radius * radius);
  const float heightX = std::max(dot(n, toLight) + radius, 0.0f);
  if (!hasNormal_)
    return meanEmission_ * std::min(area_ * heightX / (distance2 * std::sqrt(distance2)), kPi);
  const float heightY = std::max(radius - dot(normal_, toLight), 0.0f);
  return meanEmission_ * std::min(area_ * heightX * heightY / (distance2 * distance2), kPi);
}

// A sphere shines to one side only, and a point of its own surface may be rounded to either side:
// whether the sphere can light `from` at all is decided here.
LightSample Light::sample(const Point& from, float s, float t) const {
  if (!faces_.empty()) return sampleFaces(faces_, from, s, t);
  const Side side = sideOf(sphere_, from);
  if (!isLit(side, inward_, seenThrough_))
    return {sphere_.centre() + Vector(sphere_.radius(), 0, 0), Vector(1, 0, 0), 0.0f};
  if (!inward_) return sphere_.sample(from, s, t);
  LightSample sample = sphere_.sample(inside(sphere_, from, side), s, t);
  sample.n = -sample.n;
  return sample;
}

// Faces are chosen by area, so that the density is that of all of them together.
float Light::pdf(const Point& from, const Hit& at) const {
  if (!faces_.empty()) {
    const Face& face = faces_.front();
    return face.pdfFrom != nullptr ? (face.polygon.*face.pdfFrom)(from, at.p) : 1.0f / area_;
  }
  const Side side = sideOf(sphere_, from);
  if (!isLit(side, inward_, seenThrough_)) return 0.0f;
  if (!inward_) return sphere_.pdf(from, at.p, at.n);
  return sphere_.pdf(inside(sphere_, from, side), at.p, -at.n);
}

}  // namespace pathmark
