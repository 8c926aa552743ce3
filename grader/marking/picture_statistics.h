// How a picture differs from its reference, with intervals of 99 %. Both have variances; their
// noise is independent.
//
//   tileBias          the size of what is wrong, over coarse tiles
//   meanErrors        of the whole picture, channel by channel
//   efficiencyOver    1 / (variance x rays), over that of the reference
//   pValueHistogram   of single pixels
#pragma once

#include "film/image.h"
#include "record/record.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pathmark::marking {

// A picture, and what it took.
struct Measured {
  Image image;               // with variances
  double rays = 0.0;         // of all kinds
  std::uint32_t replicates;  // that the variances come from
};

// Root mean square over tiles and channels of (a - b) / mean of b in that channel, less what noise
// adds to it: 0.02 means that the picture is off by 2 % of its brightness. Nothing is larger than
// it is for a picture of the same size that is black where b is not.
record::Estimate tileBias(const Image& a, const Image& b);

// (mean of a - mean of b) / mean of b; 0 in a channel in which b is black.
std::array<record::Estimate, 3> meanErrors(const Image& a, const Image& b);

// Variances are taken relative to the reference's brightness, as eyes see noise, and summed over
// the picture; the interval comes from the differences between tiles (jackknife).
record::Estimate efficiencyOver(const Measured& a, const Measured& b);

// Of Welch's test of each pixel and channel that is not black in both.
std::vector<std::uint32_t> pValueHistogram(const Measured& a, const Measured& b);

}  // namespace pathmark::marking
