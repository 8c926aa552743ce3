#include "sampling/sobol_sampler.h"

#include "sampling/owen_scramble.h"

namespace pathmark {

namespace {

// A point of one sequence of a family.
struct Place {
  SobolSampler::Family family;
  std::uint32_t sequence = 0;
  std::uint32_t reversedIndex = 0;
};

// The finaliser of Wellons' "Prospecting for Hash Functions", 2018, with better constants found
// later by the same search: every bit of x reaches every bit of the hash.
constexpr std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x21f0aaadu;
  x = (x ^ (x >> 15)) * 0xd35a2d97u;
  return x ^ (x >> 15);
}

// Half of that, for keys that come from a hash already.
constexpr std::uint32_t otherKey(std::uint32_t key, std::uint32_t multiplier) {
  key = (key ^ (key >> 16)) * multiplier;
  return key ^ (key >> 15);
}

// kCount points of as many sequences that follow one another. `film` takes the place of the first
// point, if there is one. All of it is 32-bit arithmetic without branches, so that the loop becomes
// vector code.
template <std::uint32_t kCount, bool kFilm>
void makePoints(const Place& first, const Place& film, float* __restrict x, float* __restrict y) {
  for (std::uint32_t lane = 0; lane < kCount; ++lane) {
    const bool isFilm = kFilm && lane == 0;
    const std::uint32_t low = isFilm ? film.family.low : first.family.low;
    const std::uint32_t high = isFilm ? film.family.high : first.family.high;
    const std::uint32_t sequence = isFilm ? film.sequence : first.sequence + lane;
    const std::uint32_t reversed = isFilm ? film.reversedIndex : first.reversedIndex;

    const std::uint32_t key = hash(low + sequence * 0x9e3779b9u) ^ high;
    const std::uint32_t index = reverseBits(owenScramble(reversed, key));
    x[lane] = unitFloat(owenScramble(index, otherKey(key, 0x7feb352du)));
    y[lane] = unitFloat(owenScramble(secondSobol(index), otherKey(key, 0x846ca68bu)));
  }
}

SobolSampler::Family familyFrom(std::uint64_t key) {
  return {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)};
}

}  // namespace

void SobolSampler::startPixel(int i, int j, std::uint64_t raysBefore) {
  const std::uint64_t key = mix(pixelKey(seed_, i, j) + (raysBefore >> 32));
  filmFamily_ = familyFrom(mix(key + kGolden));
  pairFamily_ = familyFrom(mix(key + 2 * kGolden));
  singleFamily_ = familyFrom(mix(key + 3 * kGolden));
  raysBefore_ = raysBefore;
  startRay(0);
}

void SobolSampler::startRay(int m) {
  const std::uint64_t ray = raysBefore_ + static_cast<std::uint64_t>(m);
  ray_ = static_cast<std::uint32_t>(ray);
  pass_ = static_cast<std::uint32_t>(ray / raysPerPass_);
  rayOfPass_ = static_cast<std::uint32_t>(ray % raysPerPass_);
  pairsMade_ = sequencesOfSingles_ = 0;
  forgetNumbers();
}

void SobolSampler::refillPairs() {
  const Place first{pairFamily_, pairsMade_, reverseBits(ray_)};
  if (pairsMade_ == 0) {
    const Place film{filmFamily_, rayOfPass_, reverseBits(pass_)};
    makePoints<kBlock, true>(first, film, pairsX_.data(), pairsY_.data());
  } else {
    makePoints<kBlock, false>(first, {}, pairsX_.data(), pairsY_.data());
  }
  pairsMade_ += kBlock;
  nextPair_ = 0;
}

void SobolSampler::refillSingles() {
  constexpr std::uint32_t kCount = kBlock / 2;
  const Place first{singleFamily_, sequencesOfSingles_, reverseBits(ray_)};
  makePoints<kCount, false>(first, {}, singles_.data(), singles_.data() + kCount);
  sequencesOfSingles_ += kCount;
  nextSingle_ = 0;
}

}  // namespace pathmark
