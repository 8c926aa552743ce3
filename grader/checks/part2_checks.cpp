#include "checks/part2_checks.h"

#include "checks/all_checks.h"

namespace pathmark::checks {

std::span<const Check> part2Checks() {
  static const std::vector<Check> kChecks = [] {
    std::vector<Check> all = polygonChecks();
    for (const auto& more : {sphereLightChecks(), directLightingChecks()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return kChecks;
}

}  // namespace pathmark::checks
