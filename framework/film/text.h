// Text as dots: the letters of stb_easy_font, seven dots high.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pathmark {

struct TextDots {
  int width = 0, height = 0;
  std::vector<std::uint8_t> set;  // width x height, row by row from the top; 1 where there is ink

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  bool at(int x, int y) const { return set[index(x, y)] != 0; }
};

// From the line of the highest letters to that of the deepest descenders.
inline constexpr int kTextDotsHeight = 10;

// One line. The font is ASCII: see ascii_text.h for what becomes of other letters.
TextDots textDots(std::string_view text);

}  // namespace pathmark
