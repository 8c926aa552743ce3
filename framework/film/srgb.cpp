#include "film/srgb.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark {

double encodeSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decodeSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

const SrgbBytes& SrgbBytes::table() {
  static const SrgbBytes bytes;
  return bytes;
}

// By way of whole ints: bytes, which may alias everything, would keep the compiler from making
// vectors of the first loop.
void SrgbBytes::encode(std::span<const double> linear, std::uint8_t* bytes) const {
  std::array<int, 256> values;
  while (!linear.empty()) {
    const std::size_t count = std::min(values.size(), linear.size());
    for (std::size_t i = 0; i < count; ++i) values[i] = byteOf(linear[i]);
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(values[i]);
    linear = linear.subspan(count);
    bytes += count;
  }
}

SrgbBytes::SrgbBytes() {
  for (std::size_t value = 1; value < 256; ++value)
    from_[value] = decodeSrgb((static_cast<double>(value) - 0.5) / 255.0);
  from_[256] = std::numeric_limits<double>::infinity();
  std::size_t value = 0;
  for (std::size_t cell = 0; cell < atCell_.size(); ++cell) {
    while (static_cast<double>(cell) / kCells >= from_[value + 1]) ++value;
    atCell_[cell] = static_cast<int>(value);
  }
}

}  // namespace pathmark
