// How much noise a picture has, beside that of the reference at the same number of rays.
#pragma once

#include "checks/check.h"

namespace pathmark::checks {

// Never fails: noise is no error. Says in a remark where it is clearly more or less.
Finding noiseIsThatOfTheReference(CheckRun& run);

}  // namespace pathmark::checks
