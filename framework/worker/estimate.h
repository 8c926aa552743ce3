// Means of an estimator of the coursework over many rays.
#pragma once

#include "render/scene_core.h"
#include "worker/protocol.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pathmark {

// Words of one call of this estimator in a request; nothing for a function that is none.
std::optional<std::uint32_t> estimateWords(std::uint32_t function);

// The answer to a request; empty if its words do not fit it.
std::vector<Estimate> estimate(const EstimateRequest& request, std::span<const std::uint32_t> words,
                               const SceneCore& scene);

}  // namespace pathmark
