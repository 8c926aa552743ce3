#include "sampling/sobol_sampler.h"

#include <algorithm>
#include <bit>

namespace pathmark {

namespace {

constexpr std::uint32_t kLargestGroupBits = 6;

// Kept for the other rays of the group, each eight sequences; few paths are longer.
constexpr std::uint32_t kMostKept = 32;

}  // namespace

SobolSampler::SobolSampler(std::uint64_t seed, std::uint32_t raysPerPass)
    : seed_(seed),
      raysPerPass_(raysPerPass),
      groupBits_(std::min(static_cast<std::uint32_t>(std::bit_width(raysPerPass)) - 1,
                          kLargestGroupBits)) {
  const std::uint32_t padded = (raysPerPass + kSobolLanes - 1) / kSobolLanes * kSobolLanes;
  filmX_.resize(padded);
  filmY_.resize(padded);
}

void SobolSampler::startPixel(int i, int j, std::uint64_t raysBefore) {
  const std::uint64_t key = mix(pixelKey(seed_, i, j) + (raysBefore >> 32));
  filmKey_ = mix(key + kGolden);
  pairs_.key = mix(key + 2 * kGolden);
  pairsOfSingles_.key = mix(key + 3 * kGolden);
  pairs_.made.clear();
  pairsOfSingles_.made.clear();
  raysBefore_ = raysBefore;
  passBefore_ = static_cast<std::uint32_t>(raysBefore / raysPerPass_);
  hasFilmPoints_ = false;
  startPath(0);
}

void SobolSampler::makeFilmPoints(std::uint32_t pass) {
  filmPass_ = pass;
  hasFilmPoints_ = true;
  for (std::uint32_t m = 0; m < raysPerPass_; m += kSobolLanes)
    makeSobolPoint(makeSobolKeys(filmKey_, m), pass, &filmX_[m], &filmY_[m]);
}

void SobolSampler::startRay(int m) {
  auto rayOfPass = static_cast<std::uint32_t>(m);
  std::uint32_t pass = passBefore_;
  if (rayOfPass >= raysPerPass_) {
    pass += rayOfPass / raysPerPass_;
    rayOfPass %= raysPerPass_;
  }
  if (!hasFilmPoints_ || pass != filmPass_) makeFilmPoints(pass);

  startPath(m);
  nextPair_ = kBlock - 1;
  pairsX_[nextPair_] = filmX_[rayOfPass];
  pairsY_[nextPair_] = filmY_[rayOfPass];
}

void SobolSampler::startPath(int m) {
  ray_ = static_cast<std::uint32_t>(raysBefore_) + static_cast<std::uint32_t>(m);
  if (const std::uint32_t group = ray_ >> groupBits_; group != group_) {
    group_ = group;
    pairs_.made.clear();
    pairsOfSingles_.made.clear();
  }
  pairs_.next = pairsOfSingles_.next = 0;
  forgetNumbers();
}

void SobolSampler::makePoint(Family& family, float* x, float* y) {
  const std::uint32_t wanted = family.next++, rayOfGroup = ray_ & ((1u << groupBits_) - 1);
  const auto keys = [&](std::uint32_t which) {
    return makeSobolKeys(family.key, which * kSobolLanes);
  };
  if (wanted >= kMostKept) {
    SobolSequences(keys(wanted), group_, groupBits_).makePoint(rayOfGroup, x, y);
    return;
  }
  for (auto which = static_cast<std::uint32_t>(family.made.size()); which <= wanted; ++which)
    family.made.emplace_back(keys(which), group_, groupBits_);
  family.made[wanted].makePoint(rayOfGroup, x, y);
}

void SobolSampler::refillPairs() {
  nextPair_ = kBlock - kSobolLanes;
  makePoint(pairs_, &pairsX_[nextPair_], &pairsY_[nextPair_]);
}

void SobolSampler::refillSingles() {
  nextSingle_ = kBlock - std::size_t{2} * kSobolLanes;
  makePoint(pairsOfSingles_, &singles_[nextSingle_], &singles_[nextSingle_ + kSobolLanes]);
}

}  // namespace pathmark
