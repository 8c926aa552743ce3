// What the colours of samples tell.
#pragma once

#include "preview/samples/sample_set.h"

#include <array>
#include <string_view>
#include <vector>

namespace pathmark::preview {

enum class Colouring { kOrder, kFirstNumber, kSecondNumber, kThirdNumber, kClaimed };

inline constexpr std::array<std::string_view, 5> kColouringNames{"order", "number s", "number t",
                                                                 "number u", "claimed density"};

// Whether the samples have it.
bool canShow(Colouring colouring, const SampleSet& set);

struct SampleColours {
  double low = 0.0, high = 1.0;
  std::vector<float> places;  // of each sample between these, in [0,1]
};
SampleColours sampleColours(Colouring colouring, const SampleSet& set);

}  // namespace pathmark::preview
