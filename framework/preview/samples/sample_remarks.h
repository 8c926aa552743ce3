// What there is to say about samples, in sentences.
#pragma once

#include "preview/samples/sample_set.h"

#include <string>
#include <vector>

namespace pathmark::preview {

// A p-value below this is hardly chance.
inline constexpr double kUnlikely = 1e-3;

// What is odd, and what it means; nothing if nothing is odd.
std::vector<std::string> remarksOn(const SampleSet& set);

// "p = 0.42: ...", of the view that is chosen.
std::string describe(const CellTest& test, SamplerKind points);

}  // namespace pathmark::preview
