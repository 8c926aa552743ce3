#include "light_paths/error_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark {

namespace {

// Characters, of which UTF-8 makes several bytes.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
  }));
}

std::string withoutControls(std::string_view text) {
  std::string shown(text);
  std::replace_if(
      shown.begin(), shown.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return shown;
}

}  // namespace

std::string sentenceOf(std::string_view text, const ExpressionError& error) {
  if (error.position() >= text.size() && !text.empty())
    return fmt::format("At the end of the expression: {}.", error.what());
  return fmt::format("At character {} of the expression: {}.",
                     characters(text.substr(0, error.position())) + 1, error.what());
}

std::string textWithCaret(std::string_view text, const ExpressionError& error) {
  constexpr std::size_t kMost = PathExpression::kLongestText;
  return fmt::format("{}.\n  {}\n  {}^", error.what(), withoutControls(text.substr(0, kMost)),
                     std::string(characters(text.substr(0, error.position())), ' '));
}

}  // namespace pathmark
