// Pictures of numbers: what the picture area can show besides pictures.
//
//   View           what it shows
//   ColourScale    which colour is which number
//   FalseColours   a picture of numbers
#pragma once

#include "film/compare.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pathmark::preview {

enum class View {
  kPicture,
  kReference,
  kSlider,  // the picture on the left, the reference on the right
  kError,   // the picture minus the reference
  kScores,  // z of each tile: that difference in standard errors
  kNoise    // relative standard error of each pixel
};

constexpr bool needsReference(View view) { return view != View::kPicture && view != View::kNoise; }
constexpr bool isFalseColour(View view) { return view >= View::kError; }

// Signed numbers from -to to `to`, in the colours of `pathmark compare`; otherwise positive ones,
// by their logarithm, in viridis (van der Walt & Smith, 2015), dark to bright, which the
// colour-blind can read too.
struct ColourScale {
  bool isSigned = true;
  double from = 0.0, to = 1.0;

  // NaN is magenta.
  std::array<std::uint8_t, 3> colour(double value) const;

  // Of a place on the scale, from 0 to 1.
  double valueAt(double place) const;
};

struct FalseColours {
  View view = View::kPicture;  // kPicture: there are none
  ColourScale scale;
  std::vector<std::uint8_t> rgba;
  std::vector<float> values;  // one for each pixel; NaN where there is none
};

FalseColours errorColours(const Image& picture, const Image& reference, const UsablePixels& pixels);

// Full colour from what is significant on.
FalseColours scoreColours(int width, int height, const Comparison& comparison);

// The root of the mean over the channels of variance / (value^2 + 0.01). The image must have
// variances.
FalseColours noiseColours(const Image& image);

}  // namespace pathmark::preview
