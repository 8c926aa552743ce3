// Any text is a mesh, with indices that point at its vertices, or refused with a sentence.
#include "fuzz/fuzz_target.h"
#include "scene/load_scene.h"
#include "scene/obj_mesh.h"

#include <cmath>
#include <cstdlib>

using namespace pathmark;

namespace {

bool holdsTogether(const Mesh& mesh) {
  for (const TriangleIndices& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      if (v >= mesh.vertices.size()) return false;
    }
  }
  for (const glm::dvec3& v : mesh.vertices) {
    if (!std::isfinite(v.x + v.y + v.z)) return false;
  }
  return !mesh.triangles.empty();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Mesh mesh = readObj({"m.obj", std::string(reinterpret_cast<const char*>(data), size)});
    if (!holdsTogether(mesh)) std::abort();
  } catch (const SceneError& error) {
    if (std::string(error.what()).find("m.obj") == std::string::npos) std::abort();
  }
  return 0;
}
