#include "film/text.h"

#include "film/ascii_text.h"

#include <stb_easy_font.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace pathmark {

namespace {

// What stb_easy_font_print fills in, four for each rectangle.
struct EasyFontVertex {
  float x, y, z;
  unsigned char colour[4];
};

}  // namespace

TextDots textDots(std::string_view text) {
  std::string ascii = asciiText(text);
  TextDots dots{stb_easy_font_width(ascii.data()), kTextDotsHeight, {}};
  dots.set.resize(dots.index(0, dots.height));
  // A letter has at most 16 rectangles.
  std::vector<EasyFontVertex> vertices(ascii.size() * 64 + 4);
  const int rectangles =
      stb_easy_font_print(0.0f, 0.0f, ascii.data(), nullptr, vertices.data(),
                          static_cast<int>(vertices.size() * sizeof(EasyFontVertex)));
  for (std::size_t k = 0; k < static_cast<std::size_t>(rectangles); ++k) {
    const EasyFontVertex &low = vertices[4 * k], &high = vertices[4 * k + 2];
    const int right = std::min(static_cast<int>(high.x), dots.width);
    const int bottom = std::min(static_cast<int>(high.y), dots.height);
    for (int y = static_cast<int>(low.y); y < bottom; ++y)
      for (int x = static_cast<int>(low.x); x < right; ++x) dots.set[dots.index(x, y)] = 1;
  }
  return dots;
}

}  // namespace pathmark
