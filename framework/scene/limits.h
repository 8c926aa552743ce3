// How large a render may be: of scene files, options, checkpoints and images that are read.
#pragma once

#include <cstdint>

namespace pathmark {

inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;
inline constexpr std::uint64_t kMostRaysPerPixel = 1000000000;

// Of all meshes of a scene together: a short file may name one large mesh again and again.
inline constexpr std::uint64_t kMostMeshTriangles = std::uint64_t{1} << 24;
inline constexpr std::uint64_t kMostMeshVertices = std::uint64_t{1} << 24;

}  // namespace pathmark
