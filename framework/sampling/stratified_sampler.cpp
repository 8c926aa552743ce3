#include "sampling/stratified_sampler.h"

#include <cmath>
#include <numeric>

namespace pathmark {

namespace {

// Beyond so many dimensions points are made from plain random numbers, without a store.
constexpr std::size_t kMostDimensions = 512;

constexpr std::uint64_t kPairs = 1, kSingles = 2;

class Random {
 public:
  explicit Random(std::uint64_t key) : state_(key) {}

  std::uint32_t digits24() { return static_cast<std::uint32_t>(next() >> 40); }

  // A whole number below `count`, which is small: no number is likelier than another by more than
  // count / 2^32.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32);
  }

  // 0 ... count - 1 in random order (Fisher & Yates).
  std::vector<std::uint32_t> permutation(std::uint32_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (std::uint32_t k = count; k > 1; --k) std::swap(order[k - 1], order[below(k)]);
    return order;
  }

 private:
  std::uint64_t next() { return mix(state_ += kGolden); }

  std::uint64_t state_;
};

// A place in a stratum of [0,1), all in units of 2^-24. In whole numbers, since in float the last
// stratum's end can round to 1.
std::uint32_t place(std::uint32_t stratum, std::uint32_t strata, std::uint32_t jitter) {
  return static_cast<std::uint32_t>(((static_cast<std::uint64_t>(stratum) << 24) + jitter) /
                                    strata);
}

float unitFloat(std::uint32_t digits24) { return static_cast<float>(digits24) * 0x1p-24f; }

}  // namespace

StratifiedSampler::StratifiedSampler(std::uint64_t seed, std::uint32_t raysPerPass)
    : seed_(seed),
      raysPerPass_(raysPerPass),
      columns_(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(raysPerPass)))),
      rows_((raysPerPass + columns_ - 1) / columns_) {}

void StratifiedSampler::startPixel(int i, int j, std::uint64_t raysBefore) {
  pixelKey_ = pixelKey(seed_, i, j);
  raysBefore_ = raysBefore;
  pairsOfPass_.clear();
  singlesOfPass_.clear();
  startRay(0);
}

void StratifiedSampler::startRay(int m) {
  const std::uint64_t ray = raysBefore_ + static_cast<std::uint64_t>(m);
  if (const std::uint64_t pass = ray / raysPerPass_; pass != pass_) {
    pass_ = pass;
    pairsOfPass_.clear();
    singlesOfPass_.clear();
  }
  ray_ = static_cast<std::uint32_t>(ray % raysPerPass_);
  pair_ = single_ = 0;
  forgetNumbers();
}

std::uint64_t StratifiedSampler::keyOf(std::uint64_t kind, std::size_t dimension) const {
  return mix(mix(pixelKey_ + pass_ * kGolden) + (4 * dimension + kind) * kGolden);
}

StratifiedSampler::Pairs StratifiedSampler::makePairs(std::uint64_t key) const {
  Random random(key);
  const std::uint32_t strata = columns_ * rows_;
  const std::vector<std::uint32_t> columnPlaces = random.permutation(columns_),
                                   rowPlaces = random.permutation(rows_),
                                   order = random.permutation(strata);
  Pairs pairs{Numbers(raysPerPass_), Numbers(raysPerPass_)};
  for (std::uint32_t ray = 0; ray < raysPerPass_; ++ray) {
    const std::uint32_t column = order[ray] % columns_, row = order[ray] / columns_;
    pairs.x[ray] = place(column * rows_ + rowPlaces[row], strata, random.digits24());
    pairs.y[ray] = place(row * columns_ + columnPlaces[column], strata, random.digits24());
  }
  return pairs;
}

StratifiedSampler::Numbers StratifiedSampler::makeSingles(std::uint64_t key) const {
  Random random(key);
  const std::uint32_t strata = columns_ * rows_;
  const std::vector<std::uint32_t> order = random.permutation(strata);
  Numbers singles(raysPerPass_);
  for (std::uint32_t ray = 0; ray < raysPerPass_; ++ray)
    singles[ray] = place(order[ray], strata, random.digits24());
  return singles;
}

// One at a time: a block would make dimensions that no ray asks for.
void StratifiedSampler::refillPairs() {
  nextPair_ = kBlock - 1;
  const std::size_t dimension = pair_++;
  if (dimension >= kMostDimensions) {
    Random random(mix(keyOf(kPairs, dimension) + ray_));
    pairsX_[nextPair_] = unitFloat(random.digits24());
    pairsY_[nextPair_] = unitFloat(random.digits24());
    return;
  }
  while (pairsOfPass_.size() <= dimension)
    pairsOfPass_.push_back(makePairs(keyOf(kPairs, pairsOfPass_.size())));
  pairsX_[nextPair_] = unitFloat(pairsOfPass_[dimension].x[ray_]);
  pairsY_[nextPair_] = unitFloat(pairsOfPass_[dimension].y[ray_]);
}

void StratifiedSampler::refillSingles() {
  nextSingle_ = kBlock - 1;
  const std::size_t dimension = single_++;
  if (dimension >= kMostDimensions) {
    singles_[nextSingle_] = unitFloat(Random(mix(keyOf(kSingles, dimension) + ray_)).digits24());
    return;
  }
  while (singlesOfPass_.size() <= dimension)
    singlesOfPass_.push_back(makeSingles(keyOf(kSingles, singlesOfPass_.size())));
  singles_[nextSingle_] = unitFloat(singlesOfPass_[dimension][ray_]);
}

}  // namespace pathmark
