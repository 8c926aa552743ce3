#include "checks/all_checks.h"

namespace pathmark::checks {

std::span<const Check> imageChecks() { return {}; }

}  // namespace pathmark::checks
