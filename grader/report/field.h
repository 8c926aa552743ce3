// Field: one of the things that are told of a check that did not pass.
#pragma once

#include <string>
#include <string_view>

namespace pathmark::report {

struct Field {
  std::string_view name;  // "where", "expected", "got", ...
  std::string value;
};

}  // namespace pathmark::report
