// Calls of any coursework function on given inputs, as laid out in contract.h.
#pragma once

#include "render/scene_core.h"
#include "worker/contract.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pathmark {

struct CallBatch {
  CourseworkFunction function;
  std::span<const std::uint32_t> object;
  std::span<const std::uint32_t> inputs;  // count x inputWords
  std::uint64_t count;
};

// Returns count x outputWords words, or nothing if the object's words do not fit the function or
// no scene is given to a function that needs one.
std::vector<std::uint32_t> callCoursework(const CallBatch& batch, const SceneCore* scene);

}  // namespace pathmark
