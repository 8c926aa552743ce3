// SobolSequences: (0,2)-sequences side by side, as many as fit into a vector register, for the rays
// of a group.
//
//   makeSobolKeys    what scrambles them
//   makeSobolPoint   the point of one number of all of them, in the sequence's own order
//   SobolSequences   the points of a group of rays, in an order of each sequence's own
//
// Loops over lanes are 32-bit arithmetic without branches, so that they become vector code.
#pragma once

#include <array>
#include <cstdint>

namespace pathmark {

inline constexpr std::uint32_t kSobolLanes = 8;

using SobolLanes = std::array<std::uint32_t, kSobolLanes>;

struct SobolKeys {
  alignas(32) SobolLanes order, x, y;
};

// Of the sequences from `first` on of a family of independent ones.
SobolKeys makeSobolKeys(std::uint64_t family, std::uint32_t first);

void makeSobolPoint(const SobolKeys& keys, std::uint32_t number, float* x, float* y);

class SobolSequences {
 public:
  // Rays come in groups of 2^groupBits, at most 2^6.
  SobolSequences(const SobolKeys& keys, std::uint32_t group, std::uint32_t groupBits);

  void makePoint(std::uint32_t rayOfGroup, float* x, float* y) const;

 private:
  static constexpr std::uint32_t kDigitBits = 3;

  // A coordinate before scrambling, reversed, is the sum modulo 2 of a part that belongs to the
  // ray's lower octal digit and one that belongs to its upper digit.
  using Parts = std::array<SobolLanes, 1u << kDigitBits>;

  alignas(32) SobolLanes keysX_, keysY_;
  alignas(32) Parts lowerX_, lowerY_, upperX_, upperY_;
};

}  // namespace pathmark
