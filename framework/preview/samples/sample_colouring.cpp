#include "preview/samples/sample_colouring.h"

#include <algorithm>

namespace pathmark::preview {

namespace {

using F = CourseworkFunction;

double valueOf(Colouring colouring, const Sample& sample, std::size_t number) {
  switch (colouring) {
    case Colouring::kFirstNumber:
      return double{sample.numbers.s};
    case Colouring::kSecondNumber:
      return double{sample.numbers.t};
    case Colouring::kThirdNumber:
      return double{sample.numbers.u};
    case Colouring::kClaimed:
      return sample.claimed;
    default:
      return static_cast<double>(number);
  }
}

}  // namespace

bool canShow(Colouring colouring, const SampleSet& set) {
  switch (colouring) {
    case Colouring::kFirstNumber:
    case Colouring::kSecondNumber:
      return set.settings.function != F::kGetRandomNumbers;
    case Colouring::kThirdNumber:
      return set.settings.function == F::kPhongReflection;
    case Colouring::kClaimed:
      return set.claims;
    default:
      return true;
  }
}

SampleColours sampleColours(Colouring colouring, const SampleSet& set) {
  SampleColours scale;
  const bool number = colouring == Colouring::kFirstNumber ||
                      colouring == Colouring::kSecondNumber || colouring == Colouring::kThirdNumber;
  if (colouring == Colouring::kOrder)
    scale.high = std::max(static_cast<double>(set.samples.size()) - 1.0, 1.0);
  else if (!number && set.claimed)
    scale = {set.claimed->low, set.claimed->high, {}};
  const double width = scale.high - scale.low;
  for (std::size_t i = 0; i < set.samples.size(); ++i) {
    const double place =
        width > 0.0 ? (valueOf(colouring, set.samples[i], i) - scale.low) / width : 1.0;
    scale.places.push_back(static_cast<float>(place > 0.0 ? std::min(place, 1.0) : 0.0));
  }
  return scale;
}

}  // namespace pathmark::preview
