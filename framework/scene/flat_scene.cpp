// The block: a header, then each array at the next multiple of 16 bytes, in the order of
// forEachArray.
#include "scene/flat_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace pathmark {
namespace {

constexpr std::uint64_t kMagic = 0x656e656373204d50;  // "PM scene" in memory
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kAlignment = 16;
constexpr std::size_t kArrays = 9;

struct alignas(kAlignment) Header {
  std::uint64_t magic = kMagic;
  std::uint64_t totalSize = 0;
  std::uint32_t version = kVersion;
  std::uint32_t headerSize = 0;
  std::uint32_t maxBounces = 0;
  std::array<std::uint32_t, kArrays> counts{};
  FlatCamera camera;
  LightSampling lightSampling = LightSampling::kByArea;
  std::uint32_t unused = 0;  // no padding: equal scenes are equal bytes
};
static_assert(sizeof(Header) == 28 + 4 * kArrays + sizeof(FlatCamera) + 8);

// The arrays of a FlatScene or of a FlatSceneView, always in the same order.
template <typename Scene, typename Visit>
void forEachArray(Scene& scene, Visit&& visit) {
  visit(scene.materials);
  visit(scene.shapes);
  visit(scene.vertices);
  visit(scene.triangles);
  visit(scene.spheres);
  visit(scene.lights);
  visit(scene.faces);
  visit(scene.lightVertices);
  visit(scene.lightTriangles);
}

template <typename Array>
using Element = std::remove_const_t<typename std::remove_reference_t<Array>::value_type>;

constexpr std::uint64_t aligned(std::uint64_t size) {
  return (size + kAlignment - 1) / kAlignment * kAlignment;
}

// first + count <= size, without overflow.
bool inRange(std::uint32_t first, std::uint32_t count, std::size_t size) {
  return first <= size && count <= size - first;
}

bool isValid(const FlatFace& face, const FlatSceneView& view) {
  if (face.vertexCount < 3 || face.triangleCount < 1) return false;
  if (!inRange(face.firstVertex, face.vertexCount, view.lightVertices.size())) return false;
  if (!inRange(face.firstTriangle, face.triangleCount, view.lightTriangles.size())) return false;
  const auto triangles = view.lightTriangles.subspan(face.firstTriangle, face.triangleCount);
  return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    return t[0] < face.vertexCount && t[1] < face.vertexCount && t[2] < face.vertexCount;
  });
}

bool isValid(const FlatLight& light, const FlatSceneView& view) {
  if (light.sphere != FlatLight::kNoSphere) return light.sphere < view.spheres.size();
  return light.faceCount > 0 && inRange(light.firstFace, light.faceCount, view.faces.size());
}

// Every index of the arrays points into its array.
bool isValid(const FlatSceneView& view) {
  const auto all = [](const auto& array, auto&& holds) {
    return std::all_of(array.begin(), array.end(), holds);
  };
  const std::size_t shapes = view.shapes.size(), vertices = view.vertices.size();
  return view.camera.width > 0 && view.camera.height > 0 &&
         view.lightSampling <= LightSampling::kBySolidAngle &&
         all(view.materials,
             [](const FlatMaterial& m) {
               return m.kind == FlatMaterialKind::kLambertian || m.kind == FlatMaterialKind::kPhong;
             }) &&
         all(view.shapes, [&](const FlatShape& s) { return s.material < view.materials.size(); }) &&
         all(view.triangles,
             [&](const FlatTriangle& t) {
               return t.shape < shapes && t.vertex[0] < vertices && t.vertex[1] < vertices &&
                      t.vertex[2] < vertices;
             }) &&
         all(view.spheres, [&](const FlatSphere& s) { return s.shape < shapes; }) &&
         all(view.faces, [&](const FlatFace& f) { return isValid(f, view); }) &&
         all(view.lights, [&](const FlatLight& l) { return isValid(l, view); });
}

}  // namespace

void FlatScene::addTriangle(const std::array<Float3, 3>& corners, const Float3& normal,
                            std::uint32_t shape) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), corners.begin(), corners.end());
  triangles.push_back({{first, first + 1, first + 2}, shape, normal});
}

FlatSceneView viewOf(const FlatScene& s) {
  return {s.camera, s.maxBounces, s.lightSampling, s.materials,
          s.shapes, s.vertices,   s.triangles,     s.spheres,
          s.lights, s.faces,      s.lightVertices, s.lightTriangles};
}

void packScene(const FlatScene& scene, const TakeBytes& take) {
  Header header;
  header.headerSize = sizeof(Header);
  header.maxBounces = scene.maxBounces;
  header.lightSampling = scene.lightSampling;
  header.camera = scene.camera;
  header.totalSize = sizeof(Header);
  std::size_t index = 0;
  forEachArray(scene, [&](const auto& array) {
    using T = Element<decltype(array)>;
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= kAlignment);
    header.counts[index++] = static_cast<std::uint32_t>(array.size());
    header.totalSize += aligned(array.size() * sizeof(T));
  });

  take(std::as_bytes(std::span(&header, 1)));
  constexpr std::array<std::byte, kAlignment> kGap{};
  forEachArray(scene, [&](const auto& array) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(array));
    if (!bytes.empty()) take(bytes);
    const std::size_t gap = aligned(bytes.size()) - bytes.size();
    if (gap > 0) take(std::span(kGap).first(gap));
  });
}

std::vector<std::byte> packScene(const FlatScene& scene) {
  std::vector<std::byte> block;
  packScene(scene, [&](std::span<const std::byte> bytes) {
    const std::size_t offset = block.size();
    block.resize(offset + bytes.size());
    std::memcpy(block.data() + offset, bytes.data(), bytes.size());
  });
  return block;
}

std::optional<FlatSceneView> viewScene(std::span<const std::byte> block) {
  if (block.size() < sizeof(Header)) return std::nullopt;
  if (reinterpret_cast<std::uintptr_t>(block.data()) % kAlignment != 0) return std::nullopt;
  Header header;
  std::memcpy(&header, block.data(), sizeof(Header));
  if (header.magic != kMagic || header.version != kVersion || header.headerSize != sizeof(Header) ||
      header.totalSize > block.size()) {
    return std::nullopt;
  }

  FlatSceneView view;
  view.camera = header.camera;
  view.maxBounces = header.maxBounces;
  view.lightSampling = header.lightSampling;
  // Cannot overflow: nine counts of 32 bits, elements of less than 128 bytes.
  std::uint64_t offset = sizeof(Header);
  bool fits = true;
  std::size_t index = 0;
  forEachArray(view, [&](auto& array) {
    using T = Element<decltype(array)>;
    static_assert(sizeof(T) < 128);
    const std::uint64_t count = header.counts[index++];
    const std::uint64_t end = offset + aligned(count * sizeof(T));
    fits = fits && end <= header.totalSize;
    if (fits) array = {reinterpret_cast<const T*>(block.data() + offset), count};
    offset = end;
  });
  if (!fits || offset != header.totalSize || !isValid(view)) return std::nullopt;
  return view;
}

}  // namespace pathmark
