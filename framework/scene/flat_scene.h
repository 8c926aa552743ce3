// The scene as the host hands it to a worker: plain arrays in one block of memory.
//
//   FlatScene       the arrays, owned; made by the host from a checked and normalised scene
//   FlatSceneView   the same arrays in a block of memory, not owned; what a worker reads
//   packScene       FlatScene -> block, at once or in pieces;  viewScene: block -> FlatSceneView
//   viewOf          the view of a FlatScene itself
//
// Lengths are in the normalised coordinates of the scene (see normalise.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace pathmark {

using Float3 = std::array<float, 3>;

enum class FlatMaterialKind : std::uint32_t { kLambertian = 0, kPhong = 1 };

struct FlatMaterial {
  FlatMaterialKind kind = FlatMaterialKind::kLambertian;
  Float3 kd{};
  Float3 ks{};
  float exponent = 0.0f;
};

// What all primitives of one shape of the scene file have in common.
struct FlatShape {
  std::uint32_t material = 0;
  std::uint32_t frontOnly = 0;  // 1: rays pass through its back
  Float3 emission{};            // of the front
};

struct FlatTriangle {
  std::array<std::uint32_t, 3> vertex{};  // into the scene's vertices, which triangles may share
  std::uint32_t shape = 0;
  Float3 normal{};  // unit, of the front
};

struct FlatSphere {
  Float3 centre{};
  float radius = 1.0f;
  std::uint32_t shape = 0;
  std::uint32_t inward = 0;  // 1: the front is the inside
};

// A face of a light; its vertices and triangles are ranges of lightVertices and lightTriangles,
// the triangles' indices counting from its first vertex.
struct FlatFace {
  std::uint32_t firstVertex = 0, vertexCount = 0;
  std::uint32_t firstTriangle = 0, triangleCount = 0;
  Float3 normal{};
  float cumulativeArea = 1.0f;  // share of the light's area up to and including this face
};

// How points on lights are chosen.
enum class LightSampling : std::uint32_t {
  kByArea = 0,        // part 2; spheres by the solid angle that they fill
  kBySolidAngle = 1,  // part 9 for lights that are one triangle or rectangle, else as above
};

// A light is a sphere, or a range of faces among which a point is chosen by area.
struct FlatLight {
  static constexpr std::uint32_t kNoSphere = 0xffffffffu;
  std::uint32_t sphere = kNoSphere;
  std::uint32_t firstFace = 0, faceCount = 0;
  Float3 emission{};
};

struct FlatCamera {
  Float3 eye{};
  Float3 topLeft{};     // from the eye to the film's top left corner
  Float3 pixelRight{};  // from one pixel to the next in its row
  Float3 pixelDown{};   // from one pixel to the next in its column
  std::uint32_t width = 1, height = 1;
};

struct FlatScene {
  FlatCamera camera;
  std::uint32_t maxBounces = 8;
  LightSampling lightSampling = LightSampling::kByArea;
  std::vector<FlatMaterial> materials;
  std::vector<FlatShape> shapes;
  std::vector<Float3> vertices;
  std::vector<FlatTriangle> triangles;
  std::vector<FlatSphere> spheres;
  std::vector<FlatLight> lights;
  std::vector<FlatFace> faces;
  std::vector<Float3> lightVertices;
  std::vector<std::array<std::uint32_t, 3>> lightTriangles;

  // Appends a triangle with vertices of its own.
  void addTriangle(const std::array<Float3, 3>& corners, const Float3& normal, std::uint32_t shape);
};

struct FlatSceneView {
  FlatCamera camera;
  std::uint32_t maxBounces = 8;
  LightSampling lightSampling = LightSampling::kByArea;
  std::span<const FlatMaterial> materials;
  std::span<const FlatShape> shapes;
  std::span<const Float3> vertices;
  std::span<const FlatTriangle> triangles;
  std::span<const FlatSphere> spheres;
  std::span<const FlatLight> lights;
  std::span<const FlatFace> faces;
  std::span<const Float3> lightVertices;
  std::span<const std::array<std::uint32_t, 3>> lightTriangles;

  std::array<Float3, 3> corners(const FlatTriangle& t) const {
    return {vertices[t.vertex[0]], vertices[t.vertex[1]], vertices[t.vertex[2]]};
  }
  bool frontOnly(const FlatTriangle& t) const { return shapes[t.shape].frontOnly != 0; }
  bool anyFrontOnly() const {
    return std::any_of(triangles.begin(), triangles.end(),
                       [this](const FlatTriangle& t) { return frontOnly(t); });
  }
};

FlatSceneView viewOf(const FlatScene& scene);

std::vector<std::byte> packScene(const FlatScene& scene);

// The same block in pieces, one after another: large scenes then need no second copy.
using TakeBytes = std::function<void(std::span<const std::byte>)>;
void packScene(const FlatScene& scene, const TakeBytes& take);

// The block must be aligned to 16 bytes and must outlive the view. Returns nothing if the block
// is too short for what its header says, was written by another version, or has an index that
// points outside its array.
std::optional<FlatSceneView> viewScene(std::span<const std::byte> block);

}  // namespace pathmark
