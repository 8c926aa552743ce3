// SceneDescription: a scene as its file says it, in double and in the file's coordinates.
//
//   CameraDescription, MaterialDescription, ShapeDescription, TransformDescription   its parts
//   readScene fills it, validate checks it, makeGeometry makes boxes and meshes, normalise moves
//   it, flatten turns it into arrays
#pragma once

#include "scene/triangulate.h"

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

enum class ShapeKind { kTriangle, kQuad, kRectangle, kPolygon, kSphere, kBox, kMesh };

// Scales first, then rotates, then moves.
struct TransformDescription {
  glm::dvec3 scale{1.0};
  glm::dvec3 axis{0.0, 1.0, 0.0};  // of any length
  double angle = 0.0;              // degrees, counter-clockwise looking against the axis
  glm::dvec3 translate{0.0};
};

struct ShapeDescription {
  ShapeKind kind = ShapeKind::kTriangle;
  std::string name;                  // may be empty
  std::size_t material = 0;          // index into SceneDescription::materials
  glm::dvec3 emission{0.0};          // radiance of the front
  bool frontOnly = false;            // rays pass through its back
  std::vector<glm::dvec3> vertices;  // of anything but a sphere; of a box, see makeFaces
  glm::dvec3 centre{0.0};            // of a sphere
  double radius = 1.0;
  bool inward = false;  // the front of the sphere or box is its inside
  glm::dvec3 low{0.0};  // of a box before its transform, as high
  glm::dvec3 high{0.0};
  std::string file;                        // of a mesh, relative to the scene's folder
  std::string madeBy;                      // the command that makes that file; may be empty
  std::vector<TriangleIndices> triangles;  // of a mesh
  TransformDescription transform;          // of a box or a mesh
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
