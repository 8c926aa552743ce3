// How large an image may be that a file claims to hold.
#pragma once

#include "film/image.h"
#include "scene/limits.h"

#include <fmt/format.h>

#include <cstdint>

namespace pathmark {

constexpr std::int64_t kMostPixelsPerSide = 65536;

// Before anything of that size is allocated. Throws ImageError.
inline void requireImageSize(std::int64_t width, std::int64_t height) {
  if (width >= 1 && height >= 1 && width <= kMostPixelsPerSide && height <= kMostPixelsPerSide &&
      static_cast<std::uint64_t>(width * height) <= kMostPixels)
    return;
  throw ImageError(
      fmt::format("its size is said to be {}x{}, and allowed is from 1 to {} pixels a side and at "
                  "most {} in all.",
                  width, height, kMostPixelsPerSide, kMostPixels));
}

}  // namespace pathmark
