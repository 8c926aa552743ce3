#include "scene/validate.h"

#include "scene/limits.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace pathmark {
namespace {

constexpr double kMostBounces = 1000.0;
constexpr double kLargestExponent = 1e6;
constexpr double kBrightest = 1e30;
constexpr double kDarkest = 1e-30;  // what is below underflows where it is divided and multiplied
// Kd + Ks may exceed 1 by this much, so that 0.9 + 0.1 is not refused for its rounding.
constexpr double kReflectanceSlack = 1e-9;
constexpr std::size_t kMostVertices = 1000;

bool isWhole(double value, double least, double most) {
  return value >= least && value <= most && value == std::floor(value);
}

void requireWhole(double value, double least, double most, std::string_view what,
                  const Place& place) {
  if (!isWhole(value, least, most)) {
    place.refuse(fmt::format("{}", value),
                 fmt::format("{} must be a whole number from {} to {}", what, least, most));
  }
}

void requireRange(const glm::dvec3& value, double least, double most, std::string_view what,
                  const Place& place) {
  for (int i = 0; i < 3; ++i) {
    if (value[i] >= least && value[i] <= most) continue;
    Place(place, static_cast<std::size_t>(i))
        .refuse(fmt::format("{}", value[i]),
                fmt::format("{} must be from {} to {}", what, least, most));
  }
}

void requireEmission(const glm::dvec3& emission, const Place& place) {
  requireRange(emission, 0.0, kBrightest, "an emitted radiance", place);
  for (int i = 0; i < 3; ++i) {
    if (emission[i] == 0.0 || emission[i] >= kDarkest) continue;
    Place(place, static_cast<std::size_t>(i))
        .refuse(
            fmt::format("{}", emission[i]),
            fmt::format("an emitted radiance must be 0, or from {} to {}", kDarkest, kBrightest));
  }
}

void requirePoint(const glm::dvec3& point, const Place& place) {
  requireRange(point, -kLargestCoordinate, kLargestCoordinate, "a coordinate", place);
}

void validateCamera(const CameraDescription& camera, const Place& place) {
  requirePoint(camera.eye, Place(place, "eye"));
  requirePoint(camera.target, Place(place, "target"));
  requirePoint(camera.up, Place(place, "up"));
  if (!(camera.fieldOfView > 0.0 && camera.fieldOfView < 180.0)) {
    Place(place, "fieldOfView")
        .refuse(fmt::format("{}", camera.fieldOfView),
                "the vertical field of view must be between 0 and 180 degrees");
  }
  if (camera.eye == camera.target) {
    Place(place, "target").refuse("the point of the eye", "the camera must look somewhere else");
  }
  if (camera.up == glm::dvec3(0.0)) {
    Place(place, "up").refuse("the zero vector", "this must be a direction");
  }
}

void validateMaterial(const MaterialDescription& material, const Place& place) {
  requireRange(material.kd, 0.0, 1.0, "a diffuse reflectance", Place(place, "Kd"));
  if (material.kind == MaterialKind::kLambertian) return;
  requireRange(material.ks, 0.0, 1.0, "a specular reflectance", Place(place, "Ks"));
  for (int i = 0; i < 3; ++i) {
    const double sum = material.kd[i] + material.ks[i];
    if (sum > 1.0 + kReflectanceSlack) {
      place.refuse(fmt::format("Kd + Ks = {} in channel {}", sum, i),
                   "a surface cannot reflect more light than it receives: at most 1");
    }
  }
  if (!(material.exponent >= 0.0 && material.exponent <= kLargestExponent)) {
    Place(place, "exponent")
        .refuse(fmt::format("{}", material.exponent),
                fmt::format("a Phong exponent must be from 0 to {}", kLargestExponent));
  }
}

void validateVertices(const ShapeDescription& shape, const Place& place) {
  const std::size_t count = shape.vertices.size();
  if (shape.kind == ShapeKind::kPolygon) {
    if (count < 3 || count > kMostVertices) {
      place.refuse(fmt::format("{} vertices", count),
                   fmt::format("a polygon must have from 3 to {}", kMostVertices));
    }
  } else {
    const std::size_t wanted = shape.kind == ShapeKind::kTriangle ? 3 : 4;
    if (count != wanted) {
      place.refuse(fmt::format("{} vertices", count),
                   fmt::format("a {} must have {}",
                               wanted == 3                           ? "triangle"
                               : shape.kind == ShapeKind::kRectangle ? "rectangle"
                                                                     : "quad",
                               wanted));
    }
  }
  for (std::size_t i = 0; i < count; ++i) requirePoint(shape.vertices[i], Place(place, i));
}

void validateTransform(const TransformDescription& transform, const Place& place) {
  requirePoint(transform.translate, Place(place, "translate"));
  requireRange(transform.scale, -kLargestCoordinate, kLargestCoordinate, "a scale",
               Place(place, "scale"));
  if (transform.scale.x == 0.0 || transform.scale.y == 0.0 || transform.scale.z == 0.0) {
    Place(place, "scale").refuse("the scale 0", "this would leave nothing of the shape");
  }
  const Place rotate(place, "rotate");
  requirePoint(transform.axis, Place(rotate, "axis"));
  if (transform.axis == glm::dvec3(0.0)) {
    Place(rotate, "axis").refuse("the zero vector", "this must be a direction");
  }
}

void validateBox(const ShapeDescription& box, const Place& place) {
  requirePoint(box.low, Place(place, "low"));
  requirePoint(box.high, Place(place, "high"));
  for (int i = 0; i < 3; ++i) {
    if (box.low[i] < box.high[i]) continue;
    const Place high(place, "high");
    Place(high, static_cast<std::size_t>(i))
        .refuse(
            fmt::format("{}", box.high[i]),
            fmt::format("the high corner of a box must be above its low one, here {}", box.low[i]));
  }
}

void validateSphere(const ShapeDescription& shape, const Place& place) {
  requirePoint(shape.centre, Place(place, "centre"));
  if (!(shape.radius > 0.0)) {
    Place(place, "radius").refuse(fmt::format("{}", shape.radius), "a radius must be above 0");
  }
  if (shape.radius < 1.0 / kLargestCoordinate || shape.radius > kLargestCoordinate) {
    Place(place, "radius")
        .refuse(fmt::format("{}", shape.radius),
                fmt::format("a radius must be from {} to {}", 1.0 / kLargestCoordinate,
                            kLargestCoordinate));
  }
}

void validateShape(const ShapeDescription& shape, const Place& place) {
  requireEmission(shape.emission, Place(place, "emission"));
  validateTransform(shape.transform, Place(place, "transform"));
  switch (shape.kind) {
    case ShapeKind::kSphere:
      validateSphere(shape, place);
      break;
    case ShapeKind::kBox:
      validateBox(shape, place);
      break;
    case ShapeKind::kMesh:
      break;
    default:
      validateVertices(shape, Place(place, "vertices"));
  }
}

}  // namespace

void validate(const SceneDescription& scene, const SceneSource& source) {
  const Place top(source);
  const Place size(top, "size");
  requireWhole(scene.size[0], 1.0, kLargestSide, "the width in pixels", Place(size, 0));
  requireWhole(scene.size[1], 1.0, kLargestSide, "the height in pixels", Place(size, 1));
  requireWhole(scene.maxBounces, 0.0, kMostBounces, "the number of bounces",
               Place(top, "maxBounces"));
  requireWhole(scene.raysPerPixel, 1.0, double{kMostRaysPerPixel}, "the number of rays",
               Place(top, "raysPerPixel"));
  if (!(scene.exposure > 0.0 && scene.exposure <= kBrightest)) {
    Place(top, "exposure")
        .refuse(fmt::format("{}", scene.exposure),
                fmt::format("the exposure must be above 0 and at most {}", kBrightest));
  }
  validateCamera(scene.camera, Place(top, "camera"));
  const Place materials(top, "materials");
  for (const MaterialDescription& m : scene.materials) {
    validateMaterial(m, Place(materials, m.name));
  }
  const Place shapes(top, "shapes");
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    validateShape(scene.shapes[i], Place(shapes, i));
  }
}

void applyOverrides(SceneDescription& scene, const SceneOverrides& overrides,
                    const std::filesystem::path& file) {
  if (overrides.size) {
    for (std::size_t i = 0; i < 2; ++i) {
      scene.size[i] = (*overrides.size)[i];
      if (isWhole(scene.size[i], 1.0, kLargestSide)) continue;
      throw SceneError(fmt::format(
          "{}: the image size {} x {} was asked for, but each side must be from 1 to {} pixels.",
          file.string(), (*overrides.size)[0], (*overrides.size)[1], kLargestSide));
    }
  }
  if (overrides.maxBounces) {
    scene.maxBounces = *overrides.maxBounces;
    if (!isWhole(scene.maxBounces, 0.0, kMostBounces)) {
      throw SceneError(fmt::format("{}: {} bounces were asked for, but from 0 to {} are allowed.",
                                   file.string(), *overrides.maxBounces, kMostBounces));
    }
  }
}

}  // namespace pathmark
