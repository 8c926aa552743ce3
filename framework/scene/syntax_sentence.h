// What is wrong with a text that is no JSON, in words for a person.
//
//   shown, inQuotes  a piece of the file, safe and short enough to show
//   syntaxSentence   line and column, what was found there and what JSON allows
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pathmark {

// `text` without characters that would garble a terminal, and no longer than that.
std::string shown(std::string_view text, std::size_t longest);

// The same in quotes, with at most 40 characters.
std::string inQuotes(std::string_view text);

// "line:column: sentence" for a text whose reading ended just before `end`; `message`
// is the complaint of the JSON library, of which only what it expected is passed on.
std::string syntaxSentence(std::string_view text, std::size_t end, std::string_view message);

}  // namespace pathmark
