#include "film/ascii_text.h"

#include "scene/utf8.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pathmark {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

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
bool isCombiningMark(char32_t code) { return code >= 0x300 && code < 0x370; }

std::string_view baseLetters(char32_t code) {
  if (code >= 0xc0 && code < 0x100) return kLatin1[code - 0xc0];
  if (code >= 0x100 && code < 0x180) return kLatinExtendedA[code - 0x100];
  return isCombiningMark(code) ? "" : "?";
}

}  // namespace

std::string asciiText(std::string_view text) {
  std::string ascii;
  while (!text.empty()) {
    const Utf8Character first = firstCharacter(text);
    const char32_t code = first.bytes == 0 ? kReplacement : first.code;
    text.remove_prefix(std::max<std::size_t>(first.bytes, 1));
    if (code < 0x80)
      ascii += code >= 32 && code < 127 ? static_cast<char>(code) : '?';
    else
      ascii += baseLetters(code);
  }
  return ascii;
}

}  // namespace pathmark
