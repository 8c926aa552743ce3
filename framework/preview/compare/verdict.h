// What the comparison says, in words.
#pragma once

#include "film/compare.h"

#include <string>

namespace pathmark::preview {

enum class Judgement {
  kNone,  // there is nothing to judge
  kTooEarly,
  kSame,
  kDiffers
};

struct Verdict {
  Judgement judgement = Judgement::kNone;
  std::string headline{};     // a sentence
  std::string detail{};       // sentences, one a line; may be empty
  PixelRegion worst{};        // tile; of no width if none differs
  double raysPerPixel = 0.0;  // when it was made
};

// Of a comparison of a picture (A) with the reference (B), both with known noise or exact.
Verdict verdictOf(const Comparison& comparison, double raysPerPixel);

// The tile whose difference noise explains least, in the channel where that is so; null if there
// are no tiles.
const RegionResult* worstTile(const Comparison& comparison);

}  // namespace pathmark::preview
