// EdgeSampler: a sampler all of whose numbers are kEdgeNumbers, in a different order for each ray.
#pragma once

#include "tests/support/edge_inputs.h"

#include <pathmark/sampler.h>

namespace pathmark::testing {

class EdgeSampler final : public Sampler {
 public:
  void startRay(int m) override {
    order_ = Uniforms(static_cast<std::uint64_t>(m));
    forgetNumbers();
  }

 private:
  void refillSingles() override {
    nextSingle_ = kBlock - 1;
    singles_[nextSingle_] = number();
  }

  void refillPairs() override {
    nextPair_ = kBlock - 1;
    pairsX_[nextPair_] = number();
    pairsY_[nextPair_] = number();
  }

  float number() { return kEdgeNumbers[order_.bits() % kEdgeNumbers.size()]; }

  Uniforms order_{0};
};

}  // namespace pathmark::testing
