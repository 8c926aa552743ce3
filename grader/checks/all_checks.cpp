#include "checks/all_checks.h"

#include <fmt/format.h>

namespace pathmark::checks {

std::string idOf(const Check& check) {
  if (check.whole) return fmt::format("images/{}", check.name);
  return fmt::format("{}/{}", contractOf(check.function).section, check.name);
}

std::span<const Check> checksOfPart(int part) {
  switch (part) {
    case 0:
      return part0Checks();
    case 1:
      return part1Checks();
    case 2:
      return part2Checks();
    case 3:
      return part3Checks();
    case 4:
      return part4Checks();
    case 5:
      return part5Checks();
    case 6:
      return part6Checks();
    case 8:
      return part8Checks();
    case 9:
      return part9Checks();
    default:
      return {};
  }
}

}  // namespace pathmark::checks
