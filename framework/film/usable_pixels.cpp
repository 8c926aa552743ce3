#include "film/usable_pixels.h"

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

bool marked(const Image& image, std::size_t pixel) {
  return !image.invalid.empty() && image.invalid[pixel] != 0;
}

// Counts what is wrong with a pixel; returns whether nothing is.
bool check(const Image& image, std::size_t pixel, Flaws& flaws) {
  const std::span<const float> rgb(&image.rgb[3 * pixel], 3);
  const auto notANumber = [](float x) { return std::isnan(x); };
  const auto infinite = [](float x) { return std::isinf(x); };
  const auto noVariance = [](float v) { return !std::isfinite(v) || v < 0.0f; };
  std::uint64_t* kind = nullptr;
  if (marked(image, pixel))
    kind = &flaws.invalid;
  else if (std::any_of(rgb.begin(), rgb.end(), notANumber))
    kind = &flaws.nan;
  else if (std::any_of(rgb.begin(), rgb.end(), infinite))
    kind = &flaws.infinite;
  else if (!image.variance.empty() &&
           std::any_of(&image.variance[3 * pixel], &image.variance[3 * pixel] + 3, noVariance))
    kind = &flaws.noVariance;
  if (kind != nullptr) ++*kind;
  return kind == nullptr;
}

}  // namespace

UsablePixels findUsablePixels(const Image& a, const Image& b) {
  UsablePixels pixels;
  pixels.usable.resize(a.rgb.size() / 3);
  for (std::size_t i = 0; i < pixels.usable.size(); ++i) {
    const bool usableA = check(a, i, pixels.a), usableB = check(b, i, pixels.b);
    pixels.usable[i] = usableA && usableB ? 1 : 0;
    pixels.count += pixels.usable[i];
    pixels.sameMarks = pixels.sameMarks && marked(a, i) == marked(b, i);
  }
  return pixels;
}

}  // namespace pathmark
