// How large a render may be: of scene files, options, checkpoints and images that are read.
#pragma once

#include <cstdint>

namespace pathmark {

inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;
inline constexpr std::uint64_t kMostRaysPerPixel = 1000000000;

}  // namespace pathmark
