// SceneDescription: a scene as its file says it, in double and in the file's coordinates.
//
//   CameraDescription, MaterialDescription, ShapeDescription   its parts
//   readScene fills it, validate checks it, normalise moves it, flatten turns it into arrays
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pathmark {

struct CameraDescription {
  glm::dvec3 eye{0.0};
  glm::dvec3 target{0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double fieldOfView = 45.0;  // vertical, degrees
};

enum class MaterialKind { kLambertian, kPhong };

struct MaterialDescription {
  std::string name;
  MaterialKind kind = MaterialKind::kLambertian;
  glm::dvec3 kd{0.0};
  glm::dvec3 ks{0.0};
  double exponent = 0.0;
};

enum class ShapeKind { kTriangle, kQuad, kRectangle, kPolygon, kSphere };

struct ShapeDescription {
  ShapeKind kind = ShapeKind::kTriangle;
  std::string name;                  // may be empty
  std::size_t material = 0;          // index into SceneDescription::materials
  glm::dvec3 emission{0.0};          // radiance of the front
  bool frontOnly = false;            // rays pass through its back
  std::vector<glm::dvec3> vertices;  // of anything but a sphere
  glm::dvec3 centre{0.0};            // of a sphere
  double radius = 1.0;
  bool inward = false;  // the front of the sphere is its inside
};

struct SceneDescription {
  std::string caption;
  CameraDescription camera;
  std::vector<MaterialDescription> materials;
  std::vector<ShapeDescription> shapes;
  // Whole numbers once they are validated.
  std::array<double, 2> size{256.0, 256.0};
  double maxBounces = 8.0;
  double raysPerPixel = 64.0;
  double exposure = 1.0;
};

}  // namespace pathmark
