// Field: one of the things that are told of a check that did not pass.
//
//   shownWords    of an undecided check, what it can say so far; empty of others
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

namespace pathmark::report {

struct Field {
  std::string_view name;  // "where", "expected", "got", ...
  std::string value;
};

// `shown`: the relative error that would have been found, `delta`: the one that should be.
inline std::string shownWords(bool undecided, double shown, double delta) {
  if (!undecided || !std::isfinite(shown) || shown <= 0.0) return {};
  return fmt::format("an error of {:.2g} % would have been found, and {:.2g} % should be",
                     100.0 * shown, 100.0 * delta);
}

}  // namespace pathmark::report
