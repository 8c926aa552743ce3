// compareImages: how two images differ, and whether by more than their noise.
//
//   CompareSettings  what counts as a difference
//   Comparison       all numbers, and the verdict
#pragma once

#include "film/image_file.h"
#include "film/region_test.h"
#include "film/usable_pixels.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pathmark {

struct CompareSettings {
  int tile = 8;         // pixels along each side of a tile; those at the edges may be smaller
  double alpha = 1e-3;  // probability that two images that differ by noise only are said to differ
  // A relative difference of means that is accepted. In dark tiles it is relative to kDark times
  // the mean of all of B.
  std::optional<double> within{};
};

constexpr double kDark = 0.01;

// No standard error counts as smaller than this share of the mean of all of both images: in tiles
// that are nearly black a variance is too small for 32 bits, is stored as 0, and says nothing.
// Nobody sees a ten-millionth of an image's brightness.
constexpr double kLeastError = 1e-7;

struct Comparison {
  UsablePixels pixels;
  Replicates replicates;
  std::uint64_t differentValues = 0;
  double mse = 0.0;                 // mean over pixels and channels of (a - b)^2
  double relativeMse = 0.0;         // of (a - b)^2 / (b^2 + 0.01)
  std::vector<RegionResult> whole;  // three channels of the whole image
  std::vector<RegionResult> tiles;  // row by row, three channels each; none of unusable pixels
  double alphaOfWhole = 0.0, alphaOfTile = 0.0;  // of one test, where there are variances
  bool judged = false;  // by noise or by a tolerance, not by equality alone
  bool equal = false;   // in every value and every mark
  bool same = false;    // the verdict

  // Not the same, but for means alone, which one image's noise does not explain while that of the
  // other is unknown, and no tolerance was asked for: it may be noise.
  bool undecided = false;
};

// B is the reference. An image without variances counts as exact beside one with them.
//
// With variances, half of alpha is shared by the means of the whole image in three channels, and
// half by those of all tiles (Bonferroni: the rate of false alarms is at most alpha, whatever the
// tests have in common). Without them images are the same if they are equal, or if all these means
// agree to `within`. Images with NaN, infinite pixels or broken variances always differ.
// Throws ImageError if the sizes differ.
Comparison compareImages(const Image& a, const Image& b, const Replicates& replicates,
                         const CompareSettings& settings);

// The same, with the replicates that the files say, and two where an image has variances but does
// not say how many.
Comparison compareImages(const ImageFile& a, const ImageFile& b, const CompareSettings& settings);

}  // namespace pathmark
