#include "checks/part0_checks.h"

#include "checks/all_checks.h"

namespace pathmark::checks {

std::span<const Check> part0Checks() {
  static const std::vector<Check> kChecks = [] {
    std::vector<Check> all = part0IntersectionChecks();
    for (const Check& check : part0SamplingChecks()) all.push_back(check);
    for (const Check& check : part0RadianceChecks()) all.push_back(check);
    for (const Check& check : part0BackChecks()) all.push_back(check);
    return all;
  }();
  return kChecks;
}

}  // namespace pathmark::checks
