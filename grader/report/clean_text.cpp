#include "report/clean_text.h"

#include "scene/utf8.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

namespace pathmark::report {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

struct Decoded {
  char32_t character = kReplacement;
  std::size_t bytes = 1;
};

// The first character. Each byte of what is not well-formed is one U+FFFD.
Decoded firstOf(std::string_view text) {
  const Utf8Character first = firstCharacter(text);
  return first.bytes == 0 ? Decoded{} : Decoded{first.code, first.bytes};
}

void append(std::string& text, char32_t c) {
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (c < 0x80) {
    add(c);
  } else if (c < 0x800) {
    add(0xC0 | (c >> 6));
    add(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    add(0xE0 | (c >> 12));
    add(0x80 | ((c >> 6) & 0x3F));
    add(0x80 | (c & 0x3F));
  } else {
    add(0xF0 | (c >> 18));
    add(0x80 | ((c >> 12) & 0x3F));
    add(0x80 | ((c >> 6) & 0x3F));
    add(0x80 | (c & 0x3F));
  }
}

bool between(char32_t c, char32_t first, char32_t last) { return c >= first && c <= last; }

// Characters that change how others are shown: C1 controls, directions of writing (Boucher &
// Anderson, "Trojan Source", 2021), line and paragraph separators, tags, noncharacters.
bool misleads(char32_t c) {
  return between(c, 0x80, 0x9F) || c == 0x061C || between(c, 0x200E, 0x200F) ||
         between(c, 0x2028, 0x202E) || between(c, 0x2066, 0x2069) || c == 0xFEFF ||
         between(c, 0xFDD0, 0xFDEF) || (c & 0xFFFE) == 0xFFFE || between(c, 0xE0000, 0xE007F);
}

char32_t shown(char32_t c) {
  if (c == '\n' || c == '\t') return c;
  if (c < 0x20) return 0x2400 + c;
  if (c == 0x7F) return 0x2421;
  return misleads(c) ? kReplacement : c;
}

// Wide: the blocks of East Asian Width W and F that a name may hold; nothing: combining marks.
std::size_t columnsOf(char32_t c) {
  if (between(c, 0x0300, 0x036F) || between(c, 0x200B, 0x200D) || between(c, 0xFE00, 0xFE0F))
    return 0;
  const bool wide =
      between(c, 0x1100, 0x115F) || between(c, 0x2E80, 0xA4CF) || between(c, 0xAC00, 0xD7A3) ||
      between(c, 0xF900, 0xFAFF) || between(c, 0xFE30, 0xFE6F) || between(c, 0xFF00, 0xFF60) ||
      between(c, 0xFFE0, 0xFFE6) || between(c, 0x1F300, 0x1FAFF) || between(c, 0x20000, 0x3FFFD);
  return wide ? 2 : 1;
}

}  // namespace

std::string cleanText(std::string_view bytes) {
  std::string clean;
  clean.reserve(bytes.size());
  while (!bytes.empty()) {
    if (bytes.starts_with("\r\n")) bytes.remove_prefix(1);
    const Decoded first = firstOf(bytes);
    append(clean, shown(first.character));
    bytes.remove_prefix(first.bytes);
  }
  return clean;
}

std::string cleanLine(std::string_view bytes) {
  std::string clean = cleanText(bytes);
  for (char& c : clean)
    if (c == '\n' || c == '\t') c = ' ';
  return clean;
}

std::string cutAfter(std::string_view clean, std::size_t bytes) {
  if (clean.size() <= bytes) return std::string(clean);
  const std::string_view kept = cutAtCharacter(clean, bytes);
  return fmt::format("{}\n... and {} more bytes", kept, clean.size() - kept.size());
}

std::size_t columnsOf(std::string_view clean) {
  std::size_t columns = 0;
  while (!clean.empty()) {
    const Decoded first = firstOf(clean);
    columns += columnsOf(first.character);
    clean.remove_prefix(first.bytes);
  }
  return columns;
}

std::string cutInMiddle(std::string_view clean, std::size_t columns) {
  constexpr std::string_view kDots = "...";
  if (columnsOf(clean) <= columns) return std::string(clean);
  if (columns < kDots.size() + 2) return std::string(kDots.substr(0, columns));

  // Where each character begins.
  std::vector<std::size_t> begins;
  for (std::size_t at = 0; at < clean.size(); at += firstOf(clean.substr(at)).bytes)
    begins.push_back(at);
  begins.push_back(clean.size());
  const auto widthBetween = [&](std::size_t first, std::size_t last) {
    return columnsOf(clean.substr(begins[first], begins[last] - begins[first]));
  };
  const std::size_t room = columns - kDots.size(), all = begins.size() - 1;
  std::size_t head = 0, tail = all;
  while (head < all && widthBetween(0, head + 1) <= (room + 1) / 2) ++head;
  const std::size_t left = room - widthBetween(0, head);
  while (tail > head && widthBetween(tail - 1, all) <= left) --tail;
  return fmt::format("{}{}{}", clean.substr(0, begins[head]), kDots, clean.substr(begins[tail]));
}

}  // namespace pathmark::report
