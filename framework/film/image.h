// Image: linear radiance, row by row from the top.
//
//   imageFromFilm   means of a film's pixels
//   writeImage      PNG for looking at, PFM for computing with, by the file's ending
#pragma once

#include "render/render_job.h"

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pathmark {

// A sentence about a file that could not be written or read.
class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Image {
  int width = 0, height = 0;
  std::vector<float> rgb;             // 3 x width x height
  std::vector<std::uint8_t> invalid;  // 1 for a pixel that has no valid ray; empty if none is

  std::span<const float, 3> pixel(int column, int row) const {
    const auto at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(column));
    return std::span<const float, 3>(rgb.data() + at, 3);
  }
};

// A pixel without rays becomes black, and is marked as invalid.
Image imageFromFilm(int width, int height, std::span<const FilmPixel> film);

// 8-bit sRGB of exposure * radiance, clipped at 1; invalid pixels in magenta.
std::string encodePng(const Image& image, double exposure);

// 32-bit floats, little-endian, rows from the bottom (Debevec's portable float map).
std::string encodePfm(const Image& image);

// Reads what encodePfm wrote, or another PFM with three channels. Throws ImageError.
Image readPfm(const std::filesystem::path& file);

// Whether `file` ends in .png or .pfm; if not, `why` becomes a sentence that says what is allowed.
bool imageFormatKnown(const std::filesystem::path& file, std::string& why);

// Replaces the file in one step: no reader ever sees half of it. Throws ImageError.
void writeImage(const std::filesystem::path& file, const Image& image, double exposure);

}  // namespace pathmark
