#include "preview/compare/known_noise.h"

#include <cmath>
#include <vector>

namespace pathmark::preview {

namespace {

bool marked(const Image& image, std::size_t pixel) {
  return !image.invalid.empty() && image.invalid[pixel] != 0;
}

bool isTooEarly(const Picture& picture) {
  return picture.replicates < 2 || picture.image.variance.empty() ||
         picture.raysPerPixel < kRaysOfReplicate * picture.replicates;
}

std::vector<std::size_t> pixelsWithoutVariance(const Image& image) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
    const float* v = &image.variance[3 * i];
    const bool known = std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
    if (!known && !marked(image, i)) pixels.push_back(i);
  }
  return pixels;
}

}  // namespace

std::shared_ptr<const Image> imageWithKnownNoise(const std::shared_ptr<const Picture>& picture) {
  const Image& image = picture->image;
  if (isTooEarly(*picture)) return nullptr;
  const std::vector<std::size_t> without = pixelsWithoutVariance(image);
  if (without.empty()) return {picture, &image};
  if (picture->invalid.count() == 0 || without.size() > image.rgb.size() / 3 / 2) return nullptr;
  const auto copy = std::make_shared<Image>(image);
  copy->invalid.resize(image.rgb.size() / 3);
  for (const std::size_t pixel : without) copy->invalid[pixel] = 1;
  return copy;
}

}  // namespace pathmark::preview
