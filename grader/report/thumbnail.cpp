#include "report/thumbnail.h"

#include "film/image_formats.h"

#include <algorithm>

namespace pathmark::report {

namespace {

// Means of blocks of `block` x `block` pixels; smaller ones at the right and lower edges.
Image shrunk(const Image& image, int block) {
  Image small{(image.width + block - 1) / block, (image.height + block - 1) / block};
  for (int row = 0; row < small.height; ++row)
    for (int column = 0; column < small.width; ++column) {
      float sum[3] = {};
      const int bottom = std::min(image.height, (row + 1) * block);
      const int right = std::min(image.width, (column + 1) * block);
      for (int j = row * block; j < bottom; ++j)
        for (int i = column * block; i < right; ++i)
          for (std::size_t c = 0; c < 3; ++c) sum[c] += image.pixel(i, j)[c];
      const int count = (bottom - row * block) * (right - column * block);
      for (const float s : sum) small.rgb.push_back(s / static_cast<float>(count));
    }
  return small;
}

}  // namespace

std::string thumbnail(std::string_view png, int longestSide) {
  if (png.empty()) return {};
  try {
    const Image image = decodePng(png);
    const int longest = std::max(image.width, image.height);
    if (longest <= longestSide) return std::string(png);
    return encodePng(shrunk(image, (longest + longestSide - 1) / longestSide), 1.0);
  } catch (const ImageError&) {
    return {};
  }
}

}  // namespace pathmark::report
