#include "sampling/sobol_sampler.h"

#include "sampling/owen_scramble.h"

namespace pathmark {

namespace {

// The finaliser of Wellons' "Prospecting for Hash Functions", 2018, with better constants found
// later by the same search: every bit of x reaches every bit of the hash.
constexpr std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x21f0aaadu;
  x = (x ^ (x >> 15)) * 0xd35a2d97u;
  return x ^ (x >> 15);
}

}  // namespace

SobolSampler::SobolSampler(std::uint64_t seed, std::uint32_t raysPerPass)
    : seed_(seed), raysPerPass_(raysPerPass) {
  const std::size_t padded = (raysPerPass + kLanes - 1) / kLanes * kLanes;
  filmX_.resize(padded);
  filmY_.resize(padded);
}

// This and makePoints are 32-bit arithmetic without branches, which becomes vector code.
SobolSampler::Keys SobolSampler::keysOf(std::uint64_t family, std::uint32_t firstSequence) {
  const auto low = static_cast<std::uint32_t>(family);
  const auto high = static_cast<std::uint32_t>(family >> 32);
  Keys keys;
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    const std::uint32_t key = hash(low + (firstSequence + lane) * 0x9e3779b9u) ^ high;
    keys.order[lane] = key;
    keys.x[lane] = hash(key + 0x3c6ef372u);
    keys.y[lane] = hash(key + 0xdaa66d2bu);
  }
  return keys;
}

// Point number `index` of each sequence.
void SobolSampler::makePoints(const Keys& keys, std::uint32_t index, float* __restrict x,
                              float* __restrict y) {
  const std::uint32_t reversed = reverseBits(index);
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    const std::uint32_t shuffled = reverseBits(owenScramble(reversed, keys.order[lane]));
    x[lane] = unitFloat(owenScramble(shuffled, keys.x[lane]));
    y[lane] = unitFloat(owenScramble(secondSobol(shuffled), keys.y[lane]));
  }
}

void SobolSampler::startPixel(int i, int j, std::uint64_t raysBefore) {
  const std::uint64_t key = mix(pixelKey(seed_, i, j) + (raysBefore >> 32));
  filmFamily_ = mix(key + kGolden);
  pairFamily_ = mix(key + 2 * kGolden);
  singleFamily_ = mix(key + 3 * kGolden);
  for (std::uint32_t block = 0; block < firstPairs_.size(); ++block)
    firstPairs_[block] = keysOf(pairFamily_, block * kLanes);
  firstSingles_ = keysOf(singleFamily_, 0);
  raysBefore_ = raysBefore;
  pass_ = static_cast<std::uint32_t>(raysBefore / raysPerPass_);
  makeFilmPoints(pass_);
  startRay(0);
}

void SobolSampler::makeFilmPoints(std::uint32_t pass) {
  filmPass_ = pass;
  for (std::uint32_t m = 0; m < raysPerPass_; m += kLanes)
    makePoints(keysOf(filmFamily_, m), pass, &filmX_[m], &filmY_[m]);
}

void SobolSampler::startRay(int m) {
  auto rayOfPass = static_cast<std::uint32_t>(m);
  std::uint32_t pass = pass_;
  if (rayOfPass >= raysPerPass_) {
    pass += rayOfPass / raysPerPass_;
    rayOfPass %= raysPerPass_;
  }
  if (pass != filmPass_) makeFilmPoints(pass);
  ray_ = static_cast<std::uint32_t>(raysBefore_ + static_cast<std::uint64_t>(m));
  pairBlock_ = singleBlock_ = 0;
  nextSingle_ = kBlock;
  nextPair_ = kBlock - 1;
  pairsX_[nextPair_] = filmX_[rayOfPass];
  pairsY_[nextPair_] = filmY_[rayOfPass];
}

void SobolSampler::refillPairs() {
  nextPair_ = kBlock - kLanes;
  float *x = &pairsX_[nextPair_], *y = &pairsY_[nextPair_];
  if (const std::uint32_t block = pairBlock_++; block < firstPairs_.size())
    makePoints(firstPairs_[block], ray_, x, y);
  else
    makePoints(keysOf(pairFamily_, block * kLanes), ray_, x, y);
}

void SobolSampler::refillSingles() {
  nextSingle_ = kBlock - 2 * kLanes;
  float *x = &singles_[nextSingle_], *y = x + kLanes;
  if (const std::uint32_t block = singleBlock_++; block == 0)
    makePoints(firstSingles_, ray_, x, y);
  else
    makePoints(keysOf(singleFamily_, block * kLanes), ray_, x, y);
}

}  // namespace pathmark
