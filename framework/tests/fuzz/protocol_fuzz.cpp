// What comes over the wire, or out of a compiler, is what it should be or refused: scenes in a
// worker, records of paths and object files in the host. The first byte says which.
#include "fuzz/fuzz_target.h"
#include "host/object_file.h"
#include "host/object_symbols.h"
#include "host/recorded_paths.h"
#include "scene/flat_scene.h"

#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

using namespace pathmark;

namespace {

struct alignas(16) Block {
  std::byte bytes[16];
};

// Touches what its indices name.
void readAll(const FlatSceneView& scene) {
  float sum = 0.0f;
  for (const FlatTriangle& triangle : scene.triangles) {
    for (const Float3& corner : scene.corners(triangle)) sum += corner[0];
    sum += scene.materials[scene.shapes[triangle.shape].material].exponent;
  }
  for (const FlatSphere& sphere : scene.spheres)
    sum += scene.materials[scene.shapes[sphere.shape].material].exponent;
  for (const FlatFace& face : scene.faces) {
    for (const Float3& vertex : scene.lightVertices.subspan(face.firstVertex, face.vertexCount))
      sum += vertex[0];
    for (const auto& triangle :
         scene.lightTriangles.subspan(face.firstTriangle, face.triangleCount))
      for (const std::uint32_t k : triangle)
        sum += scene.lightVertices.subspan(face.firstVertex, face.vertexCount)[k][0];
  }
  [[maybe_unused]] volatile float kept = sum;
}

void viewAsScene(std::span<const std::byte> bytes) {
  std::vector<Block> blocks((bytes.size() + sizeof(Block) - 1) / sizeof(Block));
  if (!bytes.empty()) std::memcpy(blocks.data(), bytes.data(), bytes.size());
  if (const auto scene = viewScene(std::as_bytes(std::span(blocks)).first(bytes.size())))
    readAll(*scene);
}

void readAsObject(std::span<const std::byte> bytes) {
  if (const auto complaint = objectComplaint(bytes); complaint && complaint->empty()) std::abort();
  const ObjectSymbols symbols = symbolsOf(bytes);
  for (const auto* names : {&symbols.used, &symbols.offered})
    for (const std::string& name : *names)
      if (name.empty() || name.size() > bytes.size()) std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::vector<std::byte> copy(reinterpret_cast<const std::byte*>(data) + 1,
                                    reinterpret_cast<const std::byte*>(data) + size);
  switch (data[0] % 3) {
    case 0:
      viewAsScene(copy);
      break;
    case 1:
      if (const auto paths = readRecordedPaths(copy); paths && copy.empty()) std::abort();
      break;
    default:
      readAsObject(copy);
  }
  return 0;
}
