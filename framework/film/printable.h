// printable: text out of a file, for a sentence on a terminal.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace pathmark {

// At most 100 bytes of it, with question marks for control characters: those could move the cursor,
// or end the sentence's line.
inline std::string printable(std::string_view text) {
  constexpr std::size_t kMost = 100;
  std::string shown(text.substr(0, kMost));
  std::replace_if(
      shown.begin(), shown.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text.size() > kMost ? shown + "..." : shown;
}

}  // namespace pathmark
