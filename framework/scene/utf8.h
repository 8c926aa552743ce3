// Text in UTF-8, character by character.
//
//   firstCharacter       the first character and its bytes; none where the text is no UTF-8
//   continuesCharacter   whether a character has begun before this byte
//   bytesOfNameLetter    those of a character beyond ASCII that may stand in a name
//   isBlank              whether nothing of it is seen
//   cutAtCharacter       not more than so many bytes, and no half of a character
#pragma once

#include <cstddef>
#include <string_view>

namespace pathmark {

struct Utf8Character {
  char32_t code = 0;
  std::size_t bytes = 0;  // 0: there is none
};

Utf8Character firstCharacter(std::string_view text);

bool continuesCharacter(char byte);

// Of the first character; 0 if it is ASCII, no UTF-8, or one that is not seen: a control character,
// a space, a mark that turns the direction of writing round.
std::size_t bytesOfNameLetter(std::string_view text);

// Also of what is no UTF-8.
bool isBlank(std::string_view text);

std::string_view cutAtCharacter(std::string_view text, std::size_t bytes);

}  // namespace pathmark
