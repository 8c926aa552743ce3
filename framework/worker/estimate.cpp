#include "worker/estimate.h"

#include "render/radiance.h"
#include "sampling/pixel_sampler.h"
#include "worker/contract.h"

#include <pathmark/lit_scene.h>

#include <bit>
#include <cmath>
#include <functional>

namespace pathmark {

namespace {

constexpr std::uint32_t kDirectLightingWords = 11, kTracePathWords = 7;

vec3 vectorAt(std::span<const std::uint32_t> words, std::size_t at) {
  return {std::bit_cast<float>(words[at]), std::bit_cast<float>(words[at + 1]),
          std::bit_cast<float>(words[at + 2])};
}

// One ray's radiance, as the words of a call ask for it.
using OneRay = std::function<Colour(Sampler&)>;

OneRay directLightingCall(std::span<const std::uint32_t> words, const SceneCore& core) {
  Hit hit;
  hit.p = vectorAt(words, 0);
  hit.n = vectorAt(words, 3);
  hit.error = std::bit_cast<float>(words[6]);
  if (words[7] >= core.materialCount()) return {};
  hit.brdf = &core.material(words[7]);
  const Vector wo = vectorAt(words, 8);
  return [scene = LitScene(core, core.maxBounces()), hit, wo](Sampler& sampler) {
    return scene.directLighting(hit, wo, sampler);
  };
}

OneRay tracePathCall(std::span<const std::uint32_t> words, const SceneCore& core, bool mis) {
  const Ray ray{vectorAt(words, 0), vectorAt(words, 3)};
  return [scene = LitScene(core, static_cast<int>(words[6])), ray, mis](Sampler& sampler) {
    return mis ? scene.tracePathMIS(ray, sampler) : scene.tracePath(ray, sampler);
  };
}

Estimate meanOf(const OneRay& oneRay, PixelSampler& sampler, std::uint64_t rays) {
  Estimate result;
  for (std::uint64_t m = 0; m < rays; ++m) {
    sampler.startRay(static_cast<int>(m));
    sampler.next2D();  // the place on the film, which renderPixel takes
    const Colour radiance = oneRay(sampler);
    if (!isRadiance(radiance)) {
      ++result.invalid;
      continue;
    }
    for (int k = 0; k < 3; ++k) result.mean[k] += static_cast<double>(radiance[k]);
  }
  for (double& mean : result.mean) mean /= static_cast<double>(rays - result.invalid);
  return result;
}

}  // namespace

std::optional<std::uint32_t> estimateWords(std::uint32_t function) {
  if (function == static_cast<std::uint32_t>(CourseworkFunction::kDirectLighting))
    return kDirectLightingWords;
  if (function == static_cast<std::uint32_t>(CourseworkFunction::kTracePath) ||
      function == static_cast<std::uint32_t>(CourseworkFunction::kTracePathMis))
    return kTracePathWords;
  return std::nullopt;
}

std::vector<Estimate> estimate(const EstimateRequest& request, std::span<const std::uint32_t> words,
                               const SceneCore& scene) {
  const auto stride = estimateWords(request.function);
  constexpr std::uint64_t kMostRays = std::uint64_t{1} << 30;
  if (!stride || words.size() != std::size_t{request.calls} * *stride || request.rays == 0 ||
      request.rays > kMostRays)
    return {};
  const auto sampler =
      makePixelSampler(request.sampler, request.seed, static_cast<std::uint32_t>(request.rays));
  const bool mis =
      request.function == static_cast<std::uint32_t>(CourseworkFunction::kTracePathMis);
  std::vector<Estimate> results;
  for (std::uint32_t c = 0; c < request.calls; ++c) {
    const auto call = words.subspan(std::size_t{c} * *stride, *stride);
    const OneRay oneRay = *stride == kTracePathWords ? tracePathCall(call, scene, mis)
                                                     : directLightingCall(call, scene);
    if (!oneRay) return {};
    for (std::uint32_t r = 0; r < request.replicates; ++r) {
      sampler->startPixel(static_cast<int>(c), static_cast<int>(r), 0);
      results.push_back(meanOf(oneRay, *sampler, request.rays));
    }
  }
  return results;
}

}  // namespace pathmark
