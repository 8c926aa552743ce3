#include "film/ascii_text.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pathmark {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

// U+00C0 to U+00FF.
constexpr std::array<std::string_view, 64> kLatin1{"A", "A", "A", "A", "A", "A", "AE", "C",   //
                                                   "E", "E", "E", "E", "I", "I", "I",  "I",   //
                                                   "D", "N", "O", "O", "O", "O", "O",  "x",   //
                                                   "O", "U", "U", "U", "U", "Y", "Th", "ss",  //
                                                   "a", "a", "a", "a", "a", "a", "ae", "c",   //
                                                   "e", "e", "e", "e", "i", "i", "i",  "i",   //
                                                   "d", "n", "o", "o", "o", "o", "o",  "/",   //
                                                   "o", "u", "u", "u", "u", "y", "th", "y"};

// U+0100 to U+017F.
constexpr std::array<std::string_view, 128> kLatinExtendedA{
    "A", "a",  "A",  "a",  "A", "a", "C", "c",  //
    "C", "c",  "C",  "c",  "C", "c", "D", "d",  //
    "D", "d",  "E",  "e",  "E", "e", "E", "e",  //
    "E", "e",  "E",  "e",  "G", "g", "G", "g",  //
    "G", "g",  "G",  "g",  "H", "h", "H", "h",  //
    "I", "i",  "I",  "i",  "I", "i", "I", "i",  //
    "I", "i",  "IJ", "ij", "J", "j", "K", "k",  //
    "k", "L",  "l",  "L",  "l", "L", "l", "L",  //
    "l", "L",  "l",  "N",  "n", "N", "n", "N",  //
    "n", "'n", "N",  "n",  "O", "o", "O", "o",  //
    "O", "o",  "OE", "oe", "R", "r", "R", "r",  //
    "R", "r",  "S",  "s",  "S", "s", "S", "s",  //
    "S", "s",  "T",  "t",  "T", "t", "T", "t",  //
    "U", "u",  "U",  "u",  "U", "u", "U", "u",  //
    "U", "u",  "U",  "u",  "W", "w", "Y", "y",  //
    "Y", "Z",  "z",  "Z",  "z", "Z", "z", "s"};

// Marks on the letter before them, as file names from some systems have them.
bool isCombiningMark(std::uint32_t code) { return code >= 0x300 && code < 0x370; }

std::string_view baseLetters(std::uint32_t code) {
  if (code >= 0xc0 && code < 0x100) return kLatin1[code - 0xc0];
  if (code >= 0x100 && code < 0x180) return kLatinExtendedA[code - 0x100];
  return isCombiningMark(code) ? "" : "?";
}

std::size_t bytesOfLead(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  return lead >= 0xf0 && lead < 0xf5 ? 4 : 0;
}

// The first code point, which is taken off the text; kNone for a byte that begins none.
std::uint32_t takeCodePoint(std::string_view& text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const std::size_t bytes = bytesOfLead(byte(0));
  std::uint32_t code = bytes < 2 ? byte(0) : byte(0) & (0xffu >> (bytes + 1));
  bool whole = bytes > 0 && bytes <= text.size();
  for (std::size_t k = 1; whole && k < bytes; ++k) {
    whole = (byte(k) & 0xc0u) == 0x80u;
    code = code << 6 | (byte(k) & 0x3fu);
  }
  text.remove_prefix(whole ? bytes : 1);
  return whole ? code : kNone;
}

}  // namespace

std::string asciiText(std::string_view text) {
  std::string ascii;
  while (!text.empty()) {
    const std::uint32_t code = takeCodePoint(text);
    if (code < 0x80)
      ascii += code >= 32 && code < 127 ? static_cast<char>(code) : '?';
    else
      ascii += baseLetters(code);
  }
  return ascii;
}

}  // namespace pathmark
