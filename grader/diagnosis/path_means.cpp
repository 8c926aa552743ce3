#include "diagnosis/path_means.h"

#include "checks/channels.h"

#include <algorithm>

namespace pathmark::diagnosis {

void addPathMeans(const ProbeRun& run, const PathQuestion& question, Signature& signature) {
  constexpr std::uint32_t kReplicates = 32;
  std::vector<checks::PathRay> rays;
  for (const NamedRay& ray : question.rays) rays.push_back(ray.ray);
  stats::ErrorBudget budget;
  checks::CheckRun own{run.worker, run.seed, budget};
  checks::PathEstimates estimates(own, rays, question.paths);
  std::vector<double> values(kReplicates * rays.size() * 3);
  estimates.measure(0, kReplicates, values);
  Replicates means(kReplicates, rays.size() * 3);
  for (std::uint32_t r = 0; r < kReplicates; ++r) {
    const std::span<double> of = means.of(r);
    for (std::size_t k = 0; k < of.size(); ++k)
      of[k] = values[r * of.size() + k] / double{question.scale[static_cast<int>(k % 3)]};
  }
  for (std::size_t k = 0; k < rays.size(); ++k)
    for (const int channel : question.channels)
      means.add(signature, checks::inChannel(question.rays[k].what, channel),
                3 * k + static_cast<std::size_t>(channel));
}

}  // namespace pathmark::diagnosis
