#include "scene/syntax_sentence.h"

#include "scene/utf8.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
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

bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80u; }

// With all of its bytes; one of them where it is no UTF-8.
std::string_view characterAt(std::string_view text, std::size_t first) {
  const std::string_view rest = text.substr(first);
  return rest.substr(0, std::max<std::size_t>(firstCharacter(rest).bytes, 1));
}

std::string lineAndColumn(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::string_view ofLine = before.substr(before.rfind('\n') + 1);
  const auto column = 1 + std::count_if(ofLine.begin(), ofLine.end(),
                                        [](char c) { return !continuesCharacter(c); });
  return fmt::format("{}:{}", line, column);
}

struct Token {
  std::size_t first = 0;
  std::string_view text;
};

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || contains("+-._", {&c, 1});
}

bool isLiteral(std::string_view word) {
  return word == "true" || word == "false" || word == "null";
}

std::string_view wordAround(std::string_view text, std::size_t at) {
  std::size_t first = at, last = at + 1;
  while (first > 0 && isWordCharacter(text[first - 1])) --first;
  while (last < text.size() && isWordCharacter(text[last])) ++last;
  return text.substr(first, last - first);
}

// Whether the library gave up at this character only because a number or word before it has ended
// too early.
bool endsWord(std::string_view text, std::size_t at, std::string_view kind) {
  if (at == 0 || isWordCharacter(text[at]) || !isWordCharacter(text[at - 1])) return false;
  if (contains(kind, "invalid number")) return true;
  return contains(kind, "invalid literal") &&
         std::isalpha(static_cast<unsigned char>(text[at - 1])) &&
         !isLiteral(wordAround(text, at - 1));
}

// The bracket, text, number, word or other character of which the last byte that was read is a
// part. The JSON library's own idea of it may begin tokens earlier.
Token tokenBefore(std::string_view text, std::size_t end, std::string_view kind) {
  if (end == 0 || end > text.size()) return {text.size(), {}};
  const std::size_t at = endsWord(text, end - 1, kind) ? end - 2 : end - 1;
  if (text[at] == '"') {
    const std::size_t opening = at == 0 ? text.npos : text.rfind('"', at - 1);
    const bool closes =
        opening != text.npos && !contains(text.substr(opening, end - opening), "\n");
    const std::size_t first = closes ? opening : at;
    return {first, text.substr(first, end - first)};
  }
  if (!isWordCharacter(text[at])) return {at, characterAt(text, at)};
  const std::string_view word = wordAround(text, at);
  return {static_cast<std::size_t>(word.data() - text.data()), word};
}

// Of a text that ends, or fails, at `end`: no other quote in it is without a backslash.
std::size_t openingQuote(std::string_view text, std::size_t end) {
  std::size_t quote = end;
  for (;;) {
    quote = quote == 0 ? text.npos : text.rfind('"', quote - 1);
    if (quote == text.npos) return 0;
    const std::size_t before = text.substr(0, quote).find_last_not_of('\\');
    const std::size_t backslashes = before == text.npos ? quote : quote - before - 1;
    if (backslashes % 2 == 0) return quote;
  }
}

struct Complaint {
  std::size_t at = 0;
  std::string sentence;
};

constexpr const char* kNoUtf8 = "found a byte that is no UTF-8 text, but a scene file is UTF-8.";

// Of a text within its quotes.
Complaint aboutText(std::string_view text, std::size_t end, std::string_view kind) {
  const std::size_t at = std::min(std::max<std::size_t>(end, 1) - 1, text.size());
  if (contains(kind, "UTF-8")) return {at, kNoUtf8};
  const std::size_t opening = openingQuote(text, at);
  const std::string found = inQuotes(text.substr(opening + 1, at - opening - 1));
  if (at == text.size() || text[at] == '\n' || text[at] == '\r') {
    return {opening, fmt::format("found the text {} without a quote at its end, but a text must "
                                 "stand on one line: \\n in it is a new one.",
                                 found)};
  }
  if (contains(kind, "control character")) {
    const bool tab = text[at] == '\t';
    return {at,
            fmt::format("found a {} after {} in a text, but there it is written as {}.",
                        tab ? "tab" : "control character", found,
                        tab ? "\\t" : fmt::format("\\u{:04x}", static_cast<unsigned>(text[at])))};
  }
  if (contains(kind, "after backslash")) {
    return {at - 1, fmt::format("found {} in a text, but there a backslash is written as \\\\.",
                                inQuotes(fmt::format("\\{}", characterAt(text, at))))};
  }
  return {at,
          fmt::format("found {} in a text, but \\u is followed by the four hexadecimal digits of "
                      "a character.",
                      found)};
}

bool isOtherQuote(std::string_view character) {
  constexpr std::array<std::string_view, 14> kQuotes{
      "\u201c", "\u201d", "\u201e", "\u201f", "\u2018", "\u2019", "\u201a",
      "\u00ab", "\u00bb", "\u2039", "\u203a", "\u2033", "'",      "`"};
  return std::find(kQuotes.begin(), kQuotes.end(), character) != kQuotes.end();
}

bool looksLikeNumber(std::string_view word) {
  return !word.empty() &&
         (std::isdigit(static_cast<unsigned char>(word[0])) || contains("+-.", word.substr(0, 1)));
}

// What the JSON library expected, in words of this project.
std::string wantedIn(std::string_view message) {
  constexpr std::string_view kMark = "; expected ";
  const std::size_t mark = message.rfind(kMark);
  if (mark == std::string_view::npos) return {};
  // The message quotes the file, which may hold the mark as well.
  std::string wanted = shown(message.substr(mark + kMark.size()), kLongestQuote);
  if (wanted == "'}'" || wanted == "']'") return "a comma or " + wanted;
  if (wanted == "string literal") return "a text in \"quotes\"";
  if (wanted == "'[', '{', or a literal") return "a value";
  if (wanted == "end of input") return "the end of the file";
  return wanted;
}

// Of what stands between brackets, commas and colons.
std::string aboutToken(std::string_view text, const Token& token, std::string_view message) {
  const bool isText = token.text.size() >= 2 && token.text.starts_with('"');
  std::string found = inQuotes(isText ? token.text.substr(1, token.text.size() - 2) : token.text);
  if ((token.text == "}" || token.text == "]") && followsComma(text, token.first)) {
    return fmt::format("found {} right after a comma, but a comma is followed by another entry.",
                       found);
  }
  if (!token.text.empty() && !isAscii(token.text[0])) {
    const Utf8Character character = firstCharacter(token.text);
    if (character.bytes == 0) return kNoUtf8;
    found += fmt::format(" (U+{:04X})", static_cast<unsigned>(character.code));
  }
  if (isOtherQuote(token.text)) {
    return fmt::format("found {}, but a text stands in plain quotes: \"like this\".", found);
  }
  if (looksLikeNumber(token.text) && !nlohmann::json::accept(token.text)) {
    return fmt::format("found {}, which is no number, but one is written such as -0.8 or 1e-3.",
                       found);
  }
  const std::string wanted = wantedIn(message);
  return wanted.empty() ? fmt::format("found {}, but this is not JSON.", found)
                        : fmt::format("found {}, but JSON wants {} here.", found, wanted);
}

Complaint complaintOf(std::string_view text, std::size_t end, std::string_view message) {
  // Behind it the message quotes the file.
  const std::string_view kind = message.substr(0, message.find("; last read: "));
  if (contains(kind, "invalid string")) return aboutText(text, end, kind);
  const Token token = tokenBefore(text, end, kind);
  if (contains(kind, "number overflow")) {
    return {token.first,
            fmt::format("found the number {}, but the largest number is about 1.8e308.",
                        inQuotes(token.text))};
  }
  if (contains(kind, "invalid comment") && token.text.empty()) {
    return {token.first, "the file ends here, but a comment is still open."};
  }
  if (token.text.empty() || contains(kind, "unexpected end of input")) {
    return {token.first, "the file ends here, but a value is missing or a bracket is still open."};
  }
  return {token.first, aboutToken(text, token, message)};
}

}  // namespace

std::string shown(std::string_view text, std::size_t longest) {
  const std::string_view cut = cutAtCharacter(text, longest);
  std::string result(cut);
  for (char& c : result) {
    const bool printable = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    c = printable ? c : '?';
  }
  return text.size() > cut.size() ? result + "..." : result;
}

std::string inQuotes(std::string_view text) {
  return fmt::format("\"{}\"", shown(text, kLongestQuote));
}

std::string syntaxSentence(std::string_view text, std::size_t end, std::string_view message) {
  const auto [at, sentence] = complaintOf(text, end, message);
  return fmt::format("{}: {}", lineAndColumn(text, at), sentence);
}

}  // namespace pathmark
