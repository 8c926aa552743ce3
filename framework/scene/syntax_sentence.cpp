#include "scene/syntax_sentence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace pathmark {
namespace {

constexpr std::size_t kLongestQuote = 40;

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// Whether the last character before `end` that is no space is a comma.
bool followsComma(std::string_view text, std::size_t end) {
  const std::size_t last = text.substr(0, end).find_last_not_of(" \t\r\n");
  return last != std::string_view::npos && text[last] == ',';
}

std::string lineAndColumn(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t lastBreak = before.rfind('\n');
  const std::size_t column =
      lastBreak == std::string_view::npos ? before.size() + 1 : before.size() - lastBreak;
  return fmt::format("{}:{}", line, column);
}

struct Token {
  std::size_t first = 0;
  std::string_view text;
};

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || contains("+-._", {&c, 1});
}

// The bracket, text, number or word of which the last character that was read is a part. The JSON
// library's own idea of it may begin tokens earlier.
Token tokenBefore(std::string_view text, std::size_t end) {
  if (end == 0 || end > text.size()) return {text.size(), {}};
  std::size_t first = end - 1, last = end;
  if (text[first] == '"') {
    const std::size_t opening = first == 0 ? text.npos : text.rfind('"', first - 1);
    const bool closes =
        opening != text.npos && !contains(text.substr(opening, end - opening), "\n");
    if (closes) first = opening;
  } else if (isWordCharacter(text[first])) {
    while (first > 0 && isWordCharacter(text[first - 1])) --first;
    while (last < text.size() && isWordCharacter(text[last])) ++last;
  }
  return {first, text.substr(first, last - first)};
}

std::string complaint(std::string_view text, const Token& token, std::string_view message) {
  const bool isText = token.text.size() >= 2 && token.text.starts_with('"');
  const std::string found =
      inQuotes(isText ? token.text.substr(1, token.text.size() - 2) : token.text);
  if (contains(message, "number overflow")) {
    return fmt::format("found the number {}, but the largest number is about 1.8e308.", found);
  }
  if (contains(message, "unexpected end of input")) {
    return "the file ends here, but a value is missing or a bracket is still open.";
  }
  if (contains(message, "UTF-8")) {
    return "found a byte that is no UTF-8 text, but a scene file is UTF-8.";
  }
  if ((token.text == "}" || token.text == "]") && followsComma(text, token.first)) {
    return fmt::format("found {} after a comma, but the last entry has no comma after it.", found);
  }
  constexpr std::string_view kMark = "; expected ";
  const std::size_t mark = message.rfind(kMark);
  if (mark == std::string_view::npos) return fmt::format("found {}, but this is not JSON.", found);
  // The message quotes the file, which may hold the mark as well.
  const std::string wanted = shown(message.substr(mark + kMark.size()), kLongestQuote);
  const bool closing = wanted == "'}'" || wanted == "']'";
  return fmt::format("found {}, but JSON wants {}{} here.", found, closing ? "a comma or " : "",
                     wanted);
}

}  // namespace

std::string shown(std::string_view text, std::size_t longest) {
  std::string result(text.substr(0, longest));
  for (char& c : result) {
    const bool printable = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    c = printable ? c : '?';
  }
  return text.size() > longest ? result + "..." : result;
}

std::string inQuotes(std::string_view text) {
  return fmt::format("\"{}\"", shown(text, kLongestQuote));
}

std::string syntaxSentence(std::string_view text, std::size_t end, std::string_view message) {
  const Token token = tokenBefore(text, end);
  return fmt::format("{}: {}", lineAndColumn(text, token.first), complaint(text, token, message));
}

}  // namespace pathmark
