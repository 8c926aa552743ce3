// Names by which the linker puts object files together.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace pathmark {

struct ObjectSymbols {
  std::vector<std::string> used;     // of other objects
  std::vector<std::string> offered;  // to other objects
};

// Of a file that is no object, none.
ObjectSymbols symbolsOf(std::span<const std::byte> bytes);

}  // namespace pathmark
