// Owen scrambling by hashes: what is exact, and how random the flips of digits are.
#include "sampling/owen_scramble.h"
#include "sampling/mix.h"
#include "stats/mean_test.h"
#include "stats/moments.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace pathmark::test {
namespace {

// Chance of the one statistical test to fail for flips by fair coins: 465 means of two nodes and
// 31 of one.
constexpr double kFalseFail = 1e-7;

std::uint32_t bits(std::uint64_t k) { return static_cast<std::uint32_t>(mix(k * kGolden) >> 32); }

TEST(OwenScramble, BitsAreReversed) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const std::uint32_t x = bits(k);
    std::uint32_t expected = 0;
    for (int bit = 0; bit < 32; ++bit) expected |= ((x >> bit) & 1u) << (31 - bit);
    EXPECT_EQ(reverseBits(x), expected);
  }
}

// Joe & Kuo 2008, dimension 2: the polynomial x + 1 of degree 1 and m_1 = 1, so that
// v_k = v_{k-1} xor (v_{k-1} >> 1), v_1 = 1/2.
TEST(OwenScramble, SecondCoordinateIsThatOfSobolsDirectionNumbers) {
  std::array<std::uint32_t, 32> direction{};
  direction[0] = 1u << 31;
  for (std::size_t k = 1; k < 32; ++k) direction[k] = direction[k - 1] ^ (direction[k - 1] >> 1);
  for (std::uint64_t n = 0; n < 5000; ++n) {
    const std::uint32_t index = n < 4096 ? static_cast<std::uint32_t>(n) : bits(n);
    std::uint32_t expected = 0;
    for (std::size_t k = 0; k < 32; ++k)
      if ((index >> k) & 1u) expected ^= direction[k];
    EXPECT_EQ(reverseBits(secondSobol(index)), expected) << index;
  }
}

TEST(OwenScramble, NumbersWithCommonDigitsKeepExactlyThose) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const std::uint32_t key = bits(3 * k), x = bits(3 * k + 1);
    const std::uint32_t common = static_cast<std::uint32_t>(k % 32);
    // The same lowest `common` bits, another next one, and anything above.
    const std::uint32_t difference = (bits(3 * k + 2) | 1u) << common;
    const std::uint32_t changed = owenScramble(x, key) ^ owenScramble(x ^ difference, key);
    EXPECT_EQ(changed & ((1u << common) - 1u), 0u);
    EXPECT_EQ((changed >> common) & 1u, 1u);
  }
}

// A digit's flip belongs to the digits before it, its node of the tree. The variance of an estimate
// over scrambled points depends on pairs of nodes only.
TEST(OwenScramble, FlipsAreFairCoinsAndIndependentBetweenAnyTwoNodes) {
  constexpr std::uint32_t kDepth = 5, kNodes = (1u << kDepth) - 1;
  constexpr std::uint64_t kKeys = 100000;
  std::vector<stats::RunningMoments> single(kNodes), both(kNodes * kNodes);
  std::array<double, kNodes> sign{};
  for (std::uint64_t k = 0; k < kKeys; ++k) {
    for (std::uint32_t depth = 0; depth < kDepth; ++depth)
      for (std::uint32_t before = 0; before < (1u << depth); ++before)
        sign[(1u << depth) - 1 + before] =
            ((owenScramble(before, bits(k)) >> depth) & 1u) != 0 ? 1.0 : -1.0;
    for (std::uint32_t a = 0; a < kNodes; ++a) {
      single[a].add(sign[a]);
      for (std::uint32_t b = 0; b < a; ++b) both[a * kNodes + b].add(sign[a] * sign[b]);
    }
  }
  stats::MeanTest settings;
  settings.alpha = kFalseFail / (kNodes * (kNodes + 1) / 2);
  for (std::uint32_t a = 0; a < kNodes; ++a) {
    EXPECT_TRUE(stats::testMean(single[a], 0.0, settings)) << a << ": " << single[a].mean();
    for (std::uint32_t b = 0; b < a; ++b)
      EXPECT_TRUE(stats::testMean(both[a * kNodes + b], 0.0, settings))
          << a << " and " << b << ": " << both[a * kNodes + b].mean();
  }
}

TEST(OwenScramble, TheLargestNumberIsBelowOne) {
  EXPECT_EQ(unitFloat(0xffffffffu), 1.0f - 0x1p-24f);
  EXPECT_EQ(unitFloat(0u), 0.0f);
  EXPECT_EQ(unitFloat(1u), 0.5f);
  EXPECT_EQ(unitFloat(1u << 23), 0x1p-24f);
}

}  // namespace
}  // namespace pathmark::test
