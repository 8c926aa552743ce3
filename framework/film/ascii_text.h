// asciiText: text in the letters of a font that has those of ASCII only.
#pragma once

#include <string>
#include <string_view>

namespace pathmark {

// Latin letters lose their marks, and are spelt out where they are two in one: Muller, strasse,
// Lukasz. Every other character beyond ASCII, and what is no UTF-8, becomes a question mark.
std::string asciiText(std::string_view text);

}  // namespace pathmark
