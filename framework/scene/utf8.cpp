#include "scene/utf8.h"

#include <algorithm>

namespace pathmark {

namespace {

bool between(char32_t c, char32_t first, char32_t last) { return c >= first && c <= last; }

// Controls, spaces, what has no width, directions of writing, tags, noncharacters.
bool isUnseen(char32_t c) {
  return between(c, 0x80, 0xA0) || c == 0xAD || c == 0x034F || c == 0x061C || c == 0x1680 ||
         c == 0x180E || between(c, 0x2000, 0x200F) || between(c, 0x2028, 0x202F) ||
         between(c, 0x205F, 0x206F) || c == 0x3000 || c == 0xFEFF || between(c, 0xFDD0, 0xFDEF) ||
         between(c, 0xFFF9, 0xFFFB) || (c & 0xFFFE) == 0xFFFE || between(c, 0xE0000, 0xE0FFF);
}

}  // namespace

bool continuesCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

// The Unicode Standard, table 3-7: no overlong forms, no surrogates, nothing above U+10FFFF.
Utf8Character firstCharacter(std::string_view text) {
  if (text.empty()) return {};
  const unsigned lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  char32_t code = lead & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!continuesCharacter(text[i])) return {};
    code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || code > 0x10FFFF || between(code, 0xD800, 0xDFFF)) return {};
  return {code, bytes};
}

std::size_t bytesOfNameLetter(std::string_view text) {
  const Utf8Character first = firstCharacter(text);
  return first.code < 0x80 || isUnseen(first.code) ? 0 : first.bytes;
}

bool isBlank(std::string_view text) {
  while (!text.empty()) {
    const Utf8Character first = firstCharacter(text);
    const bool isSeen =
        first.code < 0x80 ? first.code > ' ' && first.code != 0x7F : !isUnseen(first.code);
    if (isSeen) return false;
    text.remove_prefix(std::max<std::size_t>(first.bytes, 1));
  }
  return true;
}

std::string_view cutAtCharacter(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && continuesCharacter(text[bytes])) --bytes;
  return text.substr(0, bytes);
}

}  // namespace pathmark
