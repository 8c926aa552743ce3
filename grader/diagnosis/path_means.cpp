#include "diagnosis/path_means.h"

#include "checks/channels.h"

#include <fmt/format.h>

namespace pathmark::diagnosis {

void addPathMeans(const ProbeRun& run, const PathQuestion& question, Signature& signature) {
  constexpr std::uint32_t kReplicates = 32;
  std::vector<checks::PathRay> rays;
  for (const NamedRay& ray : question.rays) rays.push_back(ray.ray);
  stats::ErrorBudget budget;
  checks::CheckRun own{run.worker, run.seed, budget, run.function};
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

PathQuestion furnaceQuestion(const ProbeRun& run, const checks::Hollow& hollow,
                             checks::Random& random, const Colour& kd, const Colour& emission,
                             const FurnaceRays& rays) {
  run.worker.loadScene(furnaceIn(hollow, kd, emission));
  PathQuestion question{{}, rays.channels, emission, 512};
  for (const int b : rays.bounces)
    for (const double cosine : rays.cosines)
      question.rays.push_back(
          {{hollow.rayAt(cosine, random), b},
           fmt::format("radiance over emission, {}, maxBounces() = {}, cos(wo) = {}", rays.words, b,
                       cosine)});
  return question;
}

}  // namespace pathmark::diagnosis
