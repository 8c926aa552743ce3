// EdgeSampler: a sampler all of whose numbers are kEdgeNumbers, in a different order for each ray.
#pragma once

#include "tests/support/edge_inputs.h"

#include <pathmark/sampler.h>

namespace pathmark::testing {

class EdgeSampler final : public Sampler {
 public:
  void startRay(int m) override {
    order_ = Uniforms(static_cast<std::uint64_t>(m));
    next_ = end_ = nullptr;
  }

 private:
  void refill() override {
    number_ = kEdgeNumbers[order_.bits() % kEdgeNumbers.size()];
    next_ = &number_;
    end_ = next_ + 1;
  }

  Uniforms order_{0};
  float number_ = 0.0f;
};

}  // namespace pathmark::testing
