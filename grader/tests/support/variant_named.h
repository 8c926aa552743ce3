// variantNamed: a variant of the coursework by its name; throws std::invalid_argument.
#pragma once

#include "variants/variant.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace pathmark::test {

inline Variant variantNamed(const std::string& name) {
  const std::vector<Variant> all = allVariants();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Variant& v) { return v.name == name; });
  if (found == all.end()) throw std::invalid_argument(name);
  return *found;
}

}  // namespace pathmark::test
