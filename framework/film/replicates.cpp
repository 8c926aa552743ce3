#include "film/replicates.h"

#include <algorithm>
#include <limits>

namespace pathmark {

namespace {

void add(FilmPixel& sum, const FilmPixel& pixel) {
  for (int c = 0; c < 3; ++c) sum.sum[c] += pixel.sum[c];
  sum.rays += pixel.rays;
}

// A replicate without a valid ray in the pixel has no mean there.
void add(PixelMoments& moments, const FilmPixel& pixel) {
  if (!(pixel.rays > 0.0)) return;
  moments.count += 1.0;
  for (int c = 0; c < 3; ++c) {
    const double x = pixel.sum[c] / pixel.rays, delta = x - moments.mean[c];
    moments.mean[c] += delta / moments.count;
    moments.deviations[c] += delta * (x - moments.mean[c]);
  }
}

// `share`: of the picture's rays, those of complete replicates.
float variance(const PixelMoments& moments, int channel, double share) {
  constexpr float kUnknown = std::numeric_limits<float>::infinity();
  if (moments.count < 2.0) return kUnknown;
  const double between = moments.deviations[channel] / (moments.count - 1.0);
  const double ofTheMean = between / moments.count * share;
  return ofTheMean <= std::numeric_limits<float>::max() ? static_cast<float>(ofTheMean) : kUnknown;
}

}  // namespace

void addReplicate(ReplicateSums& sums, std::span<const FilmPixel> replicate) {
  sums.film.resize(replicate.size());
  sums.moments.resize(replicate.size());
  for (std::size_t i = 0; i < replicate.size(); ++i) {
    add(sums.film[i], replicate[i]);
    add(sums.moments[i], replicate[i]);
  }
}

Image imageFromReplicates(int width, int height, const ReplicateSums& sums,
                          std::span<const FilmPixel> unfinished) {
  if (sums.film.empty()) return imageFromFilm(width, height, unfinished);
  std::vector<FilmPixel> all = sums.film;
  for (std::size_t i = 0; i < all.size(); ++i) add(all[i], unfinished[i]);
  Image image = imageFromFilm(width, height, all);
  const bool known = std::any_of(sums.moments.begin(), sums.moments.end(),
                                 [](const PixelMoments& m) { return m.count >= 2.0; });
  if (!known) return image;
  image.variance.reserve(image.rgb.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double share = all[i].rays > 0.0 ? sums.film[i].rays / all[i].rays : 1.0;
    for (int c = 0; c < 3; ++c) image.variance.push_back(variance(sums.moments[i], c, share));
  }
  return image;
}

}  // namespace pathmark
