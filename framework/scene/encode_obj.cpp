#include "scene/encode_obj.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>

namespace pathmark {

std::string encodeObj(const BlobMesh& mesh) {
  constexpr std::size_t kTypicalLine = 36;
  std::string text;
  text.reserve(kTypicalLine * mesh.vertices.size() + kTypicalLine / 2 * mesh.triangles.size());
  const auto end = std::back_inserter(text);
  for (const auto& [x, y, z] : mesh.vertices)
    fmt::format_to(end, FMT_COMPILE("v {} {} {}\n"), x, y, z);
  // OBJ counts from 1.
  for (const auto& [a, b, c] : mesh.triangles)
    fmt::format_to(end, FMT_COMPILE("f {} {} {}\n"), a + 1, b + 1, c + 1);
  return text;
}

}  // namespace pathmark
