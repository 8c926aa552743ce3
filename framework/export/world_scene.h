// A scene as other renderers are told it: in its file's unit of length, and about the origin.
//
//   WorldCamera, WorldMesh, WorldSphere   its parts
//   WorldScene                            all of it
//   worldScene                            undoes the scale of a loaded scene's normalisation
//   phongRoughness                        the microfacet lobe that is nearest to a Phong lobe
#pragma once

#include "scene/load_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pathmark {

struct WorldCamera {
  glm::dvec3 eye{0.0}, target{0.0}, up{0.0};
  double fieldOfView = 45.0;  // vertical, degrees
  int width = 1, height = 1;
};

// The triangles of a shape, counter-clockwise seen from the front.
struct WorldMesh {
  std::uint32_t shape = 0;
  std::vector<glm::dvec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct WorldSphere {
  std::uint32_t shape = 0;
  glm::dvec3 centre{0.0};
  double radius = 1.0;
  bool inward = false;
};

struct WorldScene {
  std::string name, caption;
  std::array<double, 3> origin{};  // the point of the file that is the origin here
  WorldCamera camera;
  int maxBounces = 8;
  std::vector<FlatMaterial> materials;
  std::vector<FlatShape> shapes;
  std::vector<WorldMesh> meshes;
  std::vector<WorldSphere> spheres;

  bool emits(std::uint32_t shape) const { return shapes[shape].emission != Float3{}; }
  bool hasPhong() const;
  bool hasFrontOnly() const;
  bool isMoved() const { return origin != std::array{0.0, 0.0, 0.0}; }
};

WorldScene worldScene(const LoadedScene& scene);

// The parameter alpha of a Beckmann or GGX distribution of normals whose lobe is about as wide as
// cos^m around the mirror direction: with the half vector at h from the normal, cos^m(2 h) is close
// to exp(-2 m h^2), and the Beckmann distribution to exp(-h^2 / alpha^2). The 1 keeps m = 0 finite.
double phongRoughness(double exponent);

// How a Phong material is divided: reflectances of a diffuse and of a mirroring material that are
// mixed with the weights 1 - weight and weight.
struct PhongMixture {
  double weight = 0.0;
  glm::dvec3 diffuse{0.0}, specular{0.0};
  bool clamped = false;  // a reflectance would have had to be above 1
};

PhongMixture phongMixture(const FlatMaterial& material);

}  // namespace pathmark
