// Owen scrambling of Sobol points by hashes, for loops over arrays that a compiler vectorises.
//
//   reverseBits     a number as digits from the other end
//   owenScramble    a nested uniform scrambling, chosen by a key
//   secondSobol     the second coordinate of a Sobol point
//   hash            for keys
//   unitFloat       [0,1) from digits
//
// A fraction is kept as its binary digits from the least significant bit on ("reversed"): bit 0 is
// worth 1/2, bit 1 a quarter, and so on. The scrambling of a digit may then depend on the bits
// below it, which is the way that carries and products run. The reversed first Sobol coordinate of
// point number `index` is `index` itself.
#pragma once

#include <cstdint>

namespace pathmark {

constexpr std::uint32_t reverseBits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

// Owen's nested uniform scrambling of a reversed fraction: every digit is flipped or not, depending
// on the key and the digits before it. Laine & Karras, "Stratified Sampling for Stochastic
// Transparency", EGSR 2011, section 3.1; Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4),
// 2020; constants and the keyed product by Vegdahl, "Building a Better LK Hash", 2021. The key must
// be a hash itself.
constexpr std::uint32_t owenScramble(std::uint32_t x, std::uint32_t key) {
  x ^= x * 0x3d20adeau;
  x += key;
  x *= (key >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// Reversed, of point number `index` of the (0,2)-sequence whose first coordinate, reversed, is
// `index`. The generator matrix is Pascal's triangle modulo 2 (Sobol's direction numbers for the
// polynomial x + 1): the Kronecker product of five matrices [1 1; 0 1], one step each.
constexpr std::uint32_t secondSobol(std::uint32_t index) {
  index ^= (index >> 1) & 0x55555555u;
  index ^= (index >> 2) & 0x33333333u;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 8) & 0x00ff00ffu;
  return index ^ (index >> 16);
}

// The finaliser of Wellons' "Prospecting for Hash Functions", 2018, with better constants found
// later by the same search: every bit of x reaches every bit of the hash.
constexpr std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x21f0aaadu;
  x = (x ^ (x >> 15)) * 0xd35a2d97u;
  return x ^ (x >> 15);
}

// Of a reversed fraction, cut to 24 digits: 32 bits times 2^-32 can round to 1 in float.
constexpr float unitFloat(std::uint32_t reversed) {
  return static_cast<float>(static_cast<std::int32_t>(reverseBits(reversed) >> 8)) * 0x1p-24f;
}

}  // namespace pathmark
