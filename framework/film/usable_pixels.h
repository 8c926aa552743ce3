// Which pixels of two images can be compared.
#pragma once

#include "film/image.h"

#include <cstdint>
#include <vector>

namespace pathmark {

// Pixels of one image; each is counted once, by the first of these that it is.
struct Flaws {
  std::uint64_t invalid = 0;  // marked: without a valid ray
  std::uint64_t nan = 0;      // in some channel
  std::uint64_t infinite = 0;
  std::uint64_t noVariance = 0;  // a variance that is NaN, infinite or negative

  // Marked pixels are what a render may have; the others are no images of anything.
  std::uint64_t broken() const { return nan + infinite + noVariance; }
};

struct UsablePixels {
  std::vector<std::uint8_t> usable;  // 1 where both images have a value, and a variance if any
  std::uint64_t count = 0;
  Flaws a, b;
  bool sameMarks = true;  // the same pixels are marked as invalid in both
};

// Two images of the same size.
UsablePixels findUsablePixels(const Image& a, const Image& b);

}  // namespace pathmark
