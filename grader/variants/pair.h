// Compensating mistakes: variants whose errors hide each other in a picture.
//
//   Pair        mistakes that belong together, and the picture in which they hide
//   allPairs    those of grader/variants/pairs/pairs.json
//
// An entry names its patches by their paths from grader/variants without ".patch", in the order in
// which they are applied. They apply one by one too: each mistake alone shows in the picture.
#pragma once

#include "variants/variant.h"

#include <optional>
#include <string>
#include <vector>

namespace pathmark {

struct Pair {
  std::string name;
  std::string scene;                // a shipped one
  std::optional<int> maxBounces{};  // where it is not the scene's own
  bool warmUp = false;              // the picture is made by part 0
  std::vector<Variant> mistakes;    // two, or three where it takes as many
};

// Throws std::runtime_error with a sentence if the list or a patch is not as it must be.
std::vector<Pair> allPairs();

}  // namespace pathmark
