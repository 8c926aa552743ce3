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
  double cpuSeconds = 0.0;   // of the worker, on whatever machine
};

// Root mean square over tiles and channels of (a - b) / size, less what noise adds to it, over that
// of b / size: 0.02 is that of a picture of which everything is 2 % too bright, 1 that of a black
// one. Size is that of b in the tile, or its mean over the whole channel where the tile is darker.
// Pixels count by a factor so small that b is nowhere brighter than four times its median, lamps
// that are seen least: half a pixel of their edge would count for more than all the rest.
record::Estimate tileBias(const Image& a, const Image& b);

// (mean of a - mean of b) / mean of b; 0 in a channel in which b is black.
std::array<record::Estimate, 3> meanErrors(const Image& a, const Image& b);

// Variances are taken relative to the reference's brightness, as eyes see noise, and summed over
// the picture; the interval comes from the differences between tiles (jackknife).
record::Estimate efficiencyOver(const Measured& a, const Measured& b);

// Of Welch's test of each pixel and channel that is not black in both.
std::vector<std::uint32_t> pValueHistogram(const Measured& a, const Measured& b);

}  // namespace pathmark::marking
