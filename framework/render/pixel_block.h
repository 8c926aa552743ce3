// PixelBlock: neighbouring pixels that are rendered together, numbered row by row.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pathmark {

struct PixelBlock {
  int left = 0, top = 0;
  int width = 1, height = 1;

  std::size_t count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  int column(std::size_t k) const { return left + static_cast<int>(k) % width; }
  int row(std::size_t k) const { return top + static_cast<int>(k) / width; }
};

// The first block of so many pixels, a power of two: a square, or two.
inline PixelBlock blockOf(std::uint32_t pixels) {
  PixelBlock block;
  while (static_cast<std::uint32_t>(block.width * block.height) < pixels)
    (block.width <= block.height ? block.width : block.height) *= 2;
  return block;
}

}  // namespace pathmark
