// blockDifference: how far two pictures of one scene are apart, as a whole and in places.
#pragma once

#include "film/image.h"

#include <vector>

namespace pathmark::bench {

// Sums of 8x8 pixels, all channels together; at the right and lower edge of fewer.
std::vector<double> blockSums(const Image& image);

struct BlockDifference {
  double mean = 0.0;   // of the whole picture, relative to the original
  double block = 0.0;  // the largest of a block's, relative to the block, or to a thousandth of the
                       // mean block where that is brighter
};

BlockDifference blockDifference(const std::vector<double>& sums,
                                const std::vector<double>& original);
BlockDifference blockDifference(const Image& image, const Image& original);

}  // namespace pathmark::bench
