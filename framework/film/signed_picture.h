// Pictures of signed numbers: white is 0, red above, blue below.
//
//   largestOfChannels    one number for each pixel of a difference
//   fullColour           the size that colours such numbers fully
//   signedColour         of one number
//   encodeSignedPng      the picture
//   differenceImage      a - b as an image, for files of numbers
//   tileScores           z-scores of tiles, for each pixel
#pragma once

#include "film/compare.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pathmark {

// a - b with the sum of the variances if both have some; pixels are invalid that are so in either.
Image differenceImage(const Image& a, const Image& b);

// Of each pixel the channel that is furthest from 0: a mean of the channels would hide a change of
// hue. NaN where there is no usable value.
std::vector<float> largestOfChannels(const Image& difference, const UsablePixels& pixels);

// The 99th percentile of the sizes, so that single fireflies do not make the rest white; the
// largest where that is 0, and 1 where there is nothing but 0.
double fullColour(std::span<const float> values);

// Red above 0, blue below, fully from `scale` on; NaN is magenta, as invalid pixels of renders are.
std::array<std::uint8_t, 3> signedColour(double value, double scale);

std::string encodeSignedPng(int width, int height, std::span<const float> values, double scale);

// Of the three channels the largest by size; NaN outside of all tiles.
std::vector<float> tileScores(int width, int height, const Comparison& comparison);

}  // namespace pathmark
