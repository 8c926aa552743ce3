// Sentences about numbers of a path that do not fit one another, with the likeliest reason.
#pragma once

#include "preview/paths/path_account.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace pathmark::preview {

// Three significant digits: "0.318", "1.2e-05", "nan".
std::string shortNumber(double value);
std::string shortColour(const Colour& c);  // "0.318 0.25 0", or "0.318" of a grey one

struct ThroughputStep {
  Colour before{1.0f};
  Colour own{1.0f};       // of the coursework
  Colour expected{1.0f};  // before times f cos / pdf
  Scattering scattering;
  float weightBefore = 1.0f;  // of the roulette at the vertex before
};

// At the k-th vertex, from 0.
std::string stepRemark(std::size_t k, const ThroughputStep& step);
std::string directRemark(std::size_t k, const Colour& returned, const Colour& sum);
std::string sumRemark(const TracedPath& path, const PathAccount& account);
// Of part 8: a weight cannot be right, since that has not been asked for.
std::string weightRemark(std::size_t k, std::string_view notAsked);
std::string tooLongRemark(int dropped);

}  // namespace pathmark::preview
