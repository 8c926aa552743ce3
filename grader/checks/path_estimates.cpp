#include "checks/path_estimates.h"

#include "checks/calls.h"
#include "sampling/mix.h"

#include <algorithm>
#include <limits>

namespace pathmark::checks {

namespace {

// Of one request: few enough for an answer in good time.
constexpr std::uint32_t kReplicatesAtOnce = 64;

}  // namespace

void PathEstimates::measure(std::uint32_t first, std::uint32_t count, std::span<double> values) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Words inputs;
  for (const PathRay& r : rays_) inputs.add(r.ray, r.bounces);
  for (std::uint32_t done = 0; done < count; done += kReplicatesAtOnce) {
    const std::uint32_t replicates = std::min(kReplicatesAtOnce, count - done);
    EstimateRequest request;
    request.function = static_cast<std::uint32_t>(run_.function);
    request.seed = mix(run_.seed + kGolden * (first + done + 1));
    request.replicates = replicates;
    request.calls = static_cast<std::uint32_t>(rays_.size());
    request.rays = paths_;
    const std::vector<Estimate> estimates = run_.worker.estimate(request, inputs.words());
    made_ += std::uint64_t{replicates} * request.calls * paths_;
    for (std::size_t c = 0; c < rays_.size(); ++c)
      for (std::size_t r = 0; r < replicates; ++r) {
        const Estimate& e = estimates[c * replicates + r];
        invalid_ += e.invalid;
        for (std::size_t k = 0; k < 3; ++k)
          values[((done + r) * rays_.size() + c) * 3 + k] = e.invalid > 0 ? kNan : e.mean[k];
      }
  }
}

}  // namespace pathmark::checks
