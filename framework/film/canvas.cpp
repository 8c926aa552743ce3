#include "film/canvas.h"

#include "film/srgb.h"
#include "film/text.h"

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

std::size_t pixelIndex(const Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
         static_cast<std::size_t>(x);
}

bool contains(const Image& image, int x, int y) {
  return x >= 0 && y >= 0 && x < image.width && y < image.height;
}

void markInvalid(Image& image, std::size_t pixel) {
  image.invalid.resize(image.rgb.size() / 3);
  image.invalid[pixel] = 1;
}

// The lengths that [low, high), low >= 0, has in common with each of the unit intervals from the
// one around low on.
std::vector<double> coverage(double low, double high) {
  std::vector<double> shares;
  for (int at = static_cast<int>(low); at < high; ++at)
    shares.push_back(std::min(at + 1.0, high) - std::max<double>(at, low));
  return shares;
}

// How much of each pixel of a width x height area the letters cover, in [0, 1].
std::vector<double> inkOf(const TextDots& dots, double dot, int width, int height) {
  std::vector<double> ink(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int v = 0; v < dots.height; ++v) {
    const std::vector<double> rows = coverage(v * dot, (v + 1) * dot);
    for (int u = 0; u < dots.width; ++u) {
      if (!dots.at(u, v)) continue;
      const std::vector<double> columns = coverage(u * dot, (u + 1) * dot);
      for (std::size_t j = 0; j < rows.size(); ++j) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
          const auto x = static_cast<std::size_t>(u * dot) + i;
          const auto y = static_cast<std::size_t>(v * dot) + j;
          if (x < static_cast<std::size_t>(width) && y < static_cast<std::size_t>(height))
            ink[y * static_cast<std::size_t>(width) + x] += rows[j] * columns[i];
        }
      }
    }
  }
  return ink;
}

}  // namespace

LinearRgb greyOfLevel(int level) {
  const auto value = static_cast<float>(decodeSrgb(level / 255.0));
  return {value, value, value};
}

Image makeCanvas(int width, int height, const LinearRgb& colour) {
  Image canvas{width, height, {}, {}};
  canvas.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  fillRectangle(canvas, 0, 0, width, height, colour);
  return canvas;
}

void fillRectangle(Image& canvas, int x, int y, int width, int height, const LinearRgb& colour) {
  for (int row = std::max(y, 0); row < std::min(y + height, canvas.height); ++row)
    for (int column = std::max(x, 0); column < std::min(x + width, canvas.width); ++column)
      std::copy(
          colour.begin(), colour.end(),
          canvas.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixelIndex(canvas, column, row)));
}

void drawImage(Image& canvas, const Image& image, double exposure, int x, int y) {
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (!contains(canvas, x + column, y + row)) continue;
      const std::size_t from = pixelIndex(image, column, row);
      const std::size_t to = pixelIndex(canvas, x + column, y + row);
      for (std::size_t k = 0; k < 3; ++k)
        canvas.rgb[3 * to + k] = static_cast<float>(exposure * image.rgb[3 * from + k]);
      if (!image.invalid.empty() && image.invalid[from] != 0) markInvalid(canvas, to);
    }
  }
}

void drawText(Image& canvas, std::string_view text, int x, int y, double dot,
              const LinearRgb& colour) {
  const int width = textWidth(text, dot), height = textHeight(dot);
  const std::vector<double> ink = inkOf(textDots(text), dot, width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (!contains(canvas, x + column, y + row)) continue;
      const auto share = static_cast<float>(
          std::min(ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)],
                   1.0));
      const std::size_t to = pixelIndex(canvas, x + column, y + row);
      for (std::size_t k = 0; k < 3; ++k) {
        float& value = canvas.rgb[3 * to + k];
        value += share * (colour[k] - value);
      }
    }
  }
}

int textWidth(std::string_view text, double dot) {
  return static_cast<int>(std::ceil(textDots(text).width * dot));
}

int textHeight(double dot) { return static_cast<int>(std::ceil(kTextDotsHeight * dot)); }

}  // namespace pathmark
