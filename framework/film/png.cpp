#include "film/image_file.h"

#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark {

namespace {

// IEC 61966-2-1.
double encodeSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

std::uint8_t toByte(float radiance, double exposure) {
  const double linear = std::clamp(static_cast<double>(radiance) * exposure, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(255.0 * encodeSrgb(linear)));
}

constexpr std::array<std::uint8_t, 3> kMagenta{255, 0, 255};

void appendToString(void* to, void* data, int size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                        static_cast<std::size_t>(size));
}

}  // namespace

std::string encodePng(const Image& image, double exposure) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.rgb.size());
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const bool invalid = !image.invalid.empty() && image.invalid[i / 3] != 0;
    bytes.push_back(invalid ? kMagenta[i % 3] : toByte(image.rgb[i], exposure));
  }
  std::string png;
  if (stbi_write_png_to_func(appendToString, &png, image.width, image.height, 3, bytes.data(),
                             3 * image.width) == 0)
    throw ImageError("The image could not be encoded as PNG.");
  return png;
}

}  // namespace pathmark
