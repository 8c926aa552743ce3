// sRGB (IEC 61966-2-1), the curve that screens expect.
//
//   encodeSrgb, decodeSrgb   from linear to encoded and back, both in [0,1]
//   SrgbBytes                8-bit values, without a power for each
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pathmark {

double encodeSrgb(double linear);
double decodeSrgb(double encoded);

class SrgbBytes {
 public:
  // One for all; made at the first call.
  static const SrgbBytes& table();

  // 255 encodeSrgb(linear), rounded to nearest. What is below 0 counts as 0, what is above 1 as 1,
  // NaN as 0.
  std::uint8_t operator()(double linear) const { return static_cast<std::uint8_t>(byteOf(linear)); }

  // The same for many numbers, several at a time.
  void encode(std::span<const double> linear, std::uint8_t* bytes) const;

 private:
  // The curve is steepest at 0, where a cell has 12.92 * 255 / 4096 = 0.8 values: no cell has two
  // thresholds.
  static constexpr int kCells = 4096;

  SrgbBytes();

  // Without a branch, so that the compiler can make vectors of it.
  int byteOf(double linear) const {
    const double notNegative = linear > 0.0 ? linear : 0.0;
    const double x = notNegative < 1.0 ? notNegative : 1.0;
    const int atLeast = atCell_[static_cast<std::size_t>(static_cast<int>(x * kCells))];
    return atLeast + (x >= from_[static_cast<std::size_t>(atLeast + 1)] ? 1 : 0);
  }

  std::array<double, 257> from_{};        // the smallest linear number of each value
  std::array<int, kCells + 1> atCell_{};  // the value at each cell's beginning
};

}  // namespace pathmark
