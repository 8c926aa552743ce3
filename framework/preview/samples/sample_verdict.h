// What the checks say of a function, in words for the sample view.
#pragma once

#include "preview/checker.h"
#include "preview/picture.h"

#include <string>
#include <vector>

namespace pathmark::preview {

struct VerdictWords {
  Outcome outcome = Outcome::kUnknown;
  std::string headline;
  std::vector<CheckLine::Field> found;  // of the first check that is not right
};

// `report` may be null.
VerdictWords verdictOn(CourseworkFunction function, const CourseworkState& coursework,
                       const CheckReport* report);

}  // namespace pathmark::preview
