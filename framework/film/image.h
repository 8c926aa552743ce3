// Image: linear radiance, row by row from the top.
//
//   Image           radiance, and where it is known its variance
//   imageFromFilm   means of a film's pixels
//   ImageError      a sentence about a file that could not be written or read
#pragma once

#include "render/render_job.h"

#include <span>
#include <stdexcept>
#include <vector>

namespace pathmark {

class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Image {
  int width = 0, height = 0;
  std::vector<float> rgb{};             // 3 x width x height
  std::vector<std::uint8_t> invalid{};  // 1 for a pixel that has no valid ray; empty if none is
  // Of each value of rgb as an estimate, the square of its standard error; empty if unknown.
  std::vector<float> variance{};

  std::span<const float, 3> pixel(int column, int row) const {
    const auto at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(column));
    return std::span<const float, 3>(rgb.data() + at, 3);
  }
};

// A pixel without rays becomes black, and is marked as invalid.
Image imageFromFilm(int width, int height, std::span<const FilmPixel> film);

}  // namespace pathmark
