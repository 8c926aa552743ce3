#include "bench/cycles_scene.h"

#include "film/atomic_file.h"

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

glm::dvec3 toDouble(const Float3& a) { return {a[0], a[1], a[2]}; }
Json vectorJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

template <class T>
std::string_view bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// The film is square to the axis through its middle.
Json cameraJson(const FlatCamera& camera) {
  const glm::dvec3 right = toDouble(camera.pixelRight), down = toDouble(camera.pixelDown);
  const glm::dvec3 middle =
      toDouble(camera.topLeft) + 0.5 * camera.width * right + 0.5 * camera.height * down;
  const double halfHeight = 0.5 * camera.height * length(down);
  return {{"eye", vectorJson(toDouble(camera.eye))},
          {"right", vectorJson(normalize(right))},
          {"up", vectorJson(-normalize(down))},
          {"back", vectorJson(-normalize(middle))},
          {"fieldOfView", 2.0 * std::atan(halfHeight / length(middle))},
          {"distance", length(toDouble(camera.eye))}};
}

Json materialJson(const FlatScene& scene, const FlatShape& shape) {
  const FlatMaterial& material = scene.materials[shape.material];
  if (material.kind != FlatMaterialKind::kLambertian)
    throw UsageError("--peer cycles: only scenes of Lambertian materials can be compared.");
  return {{"kd", material.kd}, {"emission", shape.emission}};
}

// The triangles of one shape, with the vertices that they use.
Json meshJson(const FlatScene& scene, std::size_t shape, const fs::path& folder) {
  std::vector<Float3> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> numbers(scene.vertices.size(), ~0u);
  for (const FlatTriangle& triangle : scene.triangles) {
    if (triangle.shape != shape) continue;
    for (const std::uint32_t vertex : triangle.vertex) {
      if (numbers[vertex] == ~0u) {
        numbers[vertex] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(scene.vertices[vertex]);
      }
      indices.push_back(numbers[vertex]);
    }
  }
  if (indices.empty()) return nullptr;
  const fs::path stem = folder / fmt::format("cycles_{}", shape);
  writeFileAtomically(stem.string() + ".vertices", bytesOf(vertices));
  writeFileAtomically(stem.string() + ".indices", bytesOf(indices));
  return {{"vertices", stem.string() + ".vertices"},
          {"indices", stem.string() + ".indices"},
          {"material", shape}};
}

}  // namespace

fs::path writeCyclesScene(const BenchScene& bench, const CyclesJob& job, const fs::path& folder) {
  const FlatScene& scene = bench.scene.flat;
  if (scene.maxBounces == 0)
    throw UsageError(
        "--peer cycles: Cycles has no paths without a scattering event, as the scene or "
        "--max-bounces asks for with 0 bounces; allowed are 1 and more.");
  Json json{{"camera", cameraJson(scene.camera)},
            {"size", {scene.camera.width, scene.camera.height}},
            {"maxBounces", scene.maxBounces},
            {"raysPerPixel", job.raysPerPixel},
            {"seed", job.seed},
            {"output", job.output.string()},
            {"scale", job.place.scale},
            {"shift", job.place.shift},
            {"materials", Json::array()},
            {"meshes", Json::array()},
            {"spheres", Json::array()}};
  for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
    json["materials"].push_back(materialJson(scene, scene.shapes[k]));
    if (Json mesh = meshJson(scene, k, folder); !mesh.is_null())
      json["meshes"].push_back(std::move(mesh));
  }
  for (const FlatSphere& sphere : scene.spheres)
    json["spheres"].push_back(
        {{"centre", sphere.centre}, {"radius", sphere.radius}, {"material", sphere.shape}});
  fs::path file = folder / "cycles.json";
  writeFileAtomically(file, json.dump());
  return file;
}

}  // namespace pathmark::bench
