// makeBlobMesh: a lumpy ball of any number of triangles, for showing that many cost little.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pathmark {

// Watertight: every vertex is stored once, and every edge belongs to two triangles, which run
// along it in opposite directions. Triangles run counter-clockwise as seen from outside.
struct BlobMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of vertices, from 0
};

// The shipped scene's: a million triangles, 8 x 354^2.
inline constexpr int kBlobSubdivisions = 354;

// An octahedron whose edges are cut into n >= 1 parts, blown up to a ball around (0, 110, 0) of
// radius 100, with lumps of up to 12 %: 8 n^2 triangles and 4 n^2 + 2 vertices.
BlobMesh makeBlobMesh(int n);

}  // namespace pathmark
