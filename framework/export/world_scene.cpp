#include "export/world_scene.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace pathmark {

namespace {

glm::dvec3 toDouble(const Float3& a) { return {a[0], a[1], a[2]}; }

double largest(const glm::dvec3& c) { return std::max({c.x, c.y, c.z}); }
double mean(const glm::dvec3& c) { return (c.x + c.y + c.z) / 3.0; }

// Back to the file's unit of length, but not to its place: far from the origin, the other
// renderers' floats would not tell the corners of a lamp apart.
class Undo {
 public:
  explicit Undo(const Normalisation& n) : n_(n) {}

  double length(double normalised) const { return normalised / n_.scale; }
  glm::dvec3 point(const glm::dvec3& p) const { return p / n_.scale; }

 private:
  const Normalisation& n_;
};

// The film is square to the axis through its middle.
WorldCamera cameraOf(const LoadedScene& scene, const Undo& undo) {
  const FlatCamera& flat = scene.flat.camera;
  const glm::dvec3 right = toDouble(flat.pixelRight), down = toDouble(flat.pixelDown);
  const glm::dvec3 middle =
      toDouble(flat.topLeft) + 0.5 * flat.width * right + 0.5 * flat.height * down;
  const glm::dvec3 eye = toDouble(flat.eye);
  const double distance =
      glm::length(glm::dvec3(scene.target[0], scene.target[1], scene.target[2]) - eye);
  WorldCamera camera;
  camera.eye = undo.point(eye);
  camera.target = undo.point(eye + distance * normalize(middle));
  camera.up = -normalize(down);
  camera.fieldOfView = 2.0 * std::atan(0.5 * flat.height * length(down) / length(middle)) * 180.0 /
                       glm::pi<double>();
  camera.width = static_cast<int>(flat.width);
  camera.height = static_cast<int>(flat.height);
  return camera;
}

class MeshMaker {
 public:
  MeshMaker(const FlatScene& scene, const Undo& undo, std::uint32_t shape)
      : scene_(scene), undo_(undo) {
    mesh_.shape = shape;
  }

  void add(const FlatTriangle& triangle) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = number(triangle.vertex[k]);
    const auto at = [&](std::size_t k) { return toDouble(scene_.vertices[triangle.vertex[k]]); };
    const glm::dvec3 normal = cross(at(1) - at(0), at(2) - at(0));
    if (dot(normal, toDouble(triangle.normal)) < 0.0) std::swap(corners[1], corners[2]);
    mesh_.triangles.push_back(corners);
  }
  WorldMesh take() { return std::move(mesh_); }

 private:
  std::uint32_t number(std::uint32_t vertex) {
    const auto [place, isNew] =
        numbers_.emplace(vertex, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (isNew) mesh_.vertices.push_back(undo_.point(toDouble(scene_.vertices[vertex])));
    return place->second;
  }

  const FlatScene& scene_;
  const Undo& undo_;
  WorldMesh mesh_;
  std::map<std::uint32_t, std::uint32_t> numbers_;
};

std::vector<WorldMesh> meshesOf(const FlatScene& scene, const Undo& undo) {
  std::map<std::uint32_t, MeshMaker> makers;
  for (const FlatTriangle& triangle : scene.triangles)
    makers.try_emplace(triangle.shape, scene, undo, triangle.shape).first->second.add(triangle);
  std::vector<WorldMesh> meshes;
  for (auto& [shape, maker] : makers) meshes.push_back(maker.take());
  return meshes;
}

}  // namespace

bool WorldScene::hasPhong() const {
  return std::any_of(materials.begin(), materials.end(),
                     [](const FlatMaterial& m) { return m.kind == FlatMaterialKind::kPhong; });
}

bool WorldScene::hasFrontOnly() const {
  return std::any_of(shapes.begin(), shapes.end(),
                     [](const FlatShape& s) { return s.frontOnly != 0; });
}

WorldScene worldScene(const LoadedScene& scene) {
  const Undo undo(scene.normalisation);
  WorldScene world;
  world.name = scene.name;
  world.caption = scene.caption;
  world.origin = scene.normalisation.shift;
  world.camera = cameraOf(scene, undo);
  world.maxBounces = static_cast<int>(scene.flat.maxBounces);
  world.materials = scene.flat.materials;
  world.shapes = scene.flat.shapes;
  world.meshes = meshesOf(scene.flat, undo);
  for (const FlatSphere& s : scene.flat.spheres)
    world.spheres.push_back({s.shape, undo.point(toDouble(s.centre)),
                             undo.length(static_cast<double>(s.radius)), s.inward != 0});
  return world;
}

double phongRoughness(double exponent) { return 1.0 / std::sqrt(1.0 + 2.0 * exponent); }

// In proportion to the mean reflectances, moved as far as keeps both materials' at most 1.
PhongMixture phongMixture(const FlatMaterial& material) {
  const glm::dvec3 kd = toDouble(material.kd), ks = toDouble(material.ks);
  PhongMixture mixture;
  if (mean(ks) == 0.0) {
    mixture.diffuse = kd;
    return mixture;
  }
  const double low = largest(ks), high = 1.0 - largest(kd);
  const double byMeans = mean(ks) / (mean(kd) + mean(ks));
  mixture.weight = low <= high ? std::clamp(byMeans, low, high) : low / (low + largest(kd));
  mixture.diffuse = mixture.weight < 1.0 ? kd / (1.0 - mixture.weight) : glm::dvec3(0.0);
  mixture.specular = ks / mixture.weight;
  constexpr double kRounding = 1e-6;
  mixture.clamped =
      largest(mixture.diffuse) > 1.0 + kRounding || largest(mixture.specular) > 1.0 + kRounding;
  mixture.diffuse = min(mixture.diffuse, 1.0);
  mixture.specular = min(mixture.specular, 1.0);
  return mixture;
}

}  // namespace pathmark
