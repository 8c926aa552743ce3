// Independent films of the same image: their common mean, and the variance that their differences
// tell.
//
//   PixelMoments           of a pixel's means, one from each replicate
//   ReplicateSums          what is kept of complete replicates, however many there are
//   addReplicate           takes a complete one in
//   imageFromReplicates    the picture, with variance
#pragma once

#include "film/image.h"
#include "render/render_job.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pathmark {

// By Welford's method (Technometrics 4, 1962), which does not cancel: sum(x^2) - n mean^2 would
// lose the variance of a bright pixel.
struct PixelMoments {
  double count = 0.0;                      // replicates that have a valid ray here
  double mean[3] = {0.0, 0.0, 0.0};        // of their means
  double deviations[3] = {0.0, 0.0, 0.0};  // sum of squared deviations from it
};

struct ReplicateSums {
  std::vector<FilmPixel> film;        // sums over the replicates; empty if there are none
  std::vector<PixelMoments> moments;  // of as many pixels
};

void addReplicate(ReplicateSums& sums, std::span<const FilmPixel> replicate);

// The mean of all rays, those of `unfinished` included. The variance is that of the mean of the
// complete replicates, brought to the number of rays in the picture: passes are independent of each
// other and, but for a shorter last one, equally distributed, so that the variance of their mean
// falls as one over their number. Infinite where fewer than two replicates have a valid ray; left
// out if that is so everywhere.
Image imageFromReplicates(int width, int height, const ReplicateSums& sums,
                          std::span<const FilmPixel> unfinished);

}  // namespace pathmark
