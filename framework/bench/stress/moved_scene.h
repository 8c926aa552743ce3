// movedScene: a scene file in other units and at another place.
#pragma once

#include <filesystem>
#include <string>

namespace pathmark::bench {

struct Similarity {
  double scale = 1.0;
  double shift = 0.0;  // along each axis, in sizes of the scene
};

// The text of the scene in `file`, with every point moved by shift * size and then multiplied by
// scale; the size is the longest side of the box around its shapes and eye. Meshes get a transform.
std::string movedScene(const std::filesystem::path& file, const Similarity& similarity);

}  // namespace pathmark::bench
