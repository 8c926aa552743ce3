#include "export/export_scene.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace pathmark {

namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
void append(std::string& text, const T& value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  text.append(bytes, sizeof value);
}

}  // namespace

std::string plyText(const WorldMesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
      "y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(), mesh.triangles.size());
  for (const glm::dvec3& v : mesh.vertices)
    for (const double coordinate : {v.x, v.y, v.z}) append(text, static_cast<float>(coordinate));
  for (const auto& triangle : mesh.triangles) {
    append(text, std::uint8_t{3});
    for (const std::uint32_t vertex : triangle) append(text, static_cast<std::int32_t>(vertex));
  }
  return text;
}

}  // namespace pathmark
