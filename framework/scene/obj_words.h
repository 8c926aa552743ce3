// ObjWords: the statements of a Wavefront OBJ file, word by word.
//
//   ObjWords            one statement's words
//   endOfStatements     where a piece of a file can be cut
//
// A backslash at the end of a line continues its statement on the next, a # ends it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pathmark {

class ObjWords {
 public:
  // Reads at `position`, and counts lines in `line`.
  ObjWords(std::string_view text, std::size_t& position, std::size_t& line)
      : text_(text), position_(position), line_(line) {}

  // The next word; empty at the end of the statement.
  std::string_view next() {
    skipSpaces();
    const std::size_t first = position_;
    while (position_ < text_.size() && (!maySplit(text_[position_]) || isPlainBackslash())) {
      ++position_;
    }
    return text_.substr(first, position_ - first);
  }

  // The next word, if it is a number as most are in a file: the fast way past next(). Otherwise
  // false, and nothing is read. The first takes whole numbers from 1 to `most`; the second,
  // decimals of at most 15 digits without an exponent. Their digits as a whole number and the power
  // of ten are exact in double, so that the quotient is the double nearest to the decimal.
  bool nextIndex(std::uint32_t most, std::uint32_t& index) {
    const std::size_t first = firstOfWord();
    std::size_t at = first;
    std::uint64_t value = 0;
    for (; at < text_.size() && isDigit(text_[at]) && at - first < 10; ++at) {
      value = 10 * value + digit(text_[at]);
    }
    if (value < 1 || value > most || !endsAt(at)) return false;
    index = static_cast<std::uint32_t>(value);
    position_ = at;
    return true;
  }
  bool nextDecimal(double& number) {
    static constexpr std::array kPowers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    std::size_t at = firstOfWord();
    const bool negative = at < text_.size() && text_[at] == '-';
    if (negative) ++at;
    std::uint64_t value = 0;
    std::size_t digits = 0, whole = kPowers.size();
    for (; at < text_.size(); ++at) {
      if (isDigit(text_[at])) {
        value = 10 * value + digit(text_[at]);
        if (++digits == kPowers.size()) return false;
      } else if (text_[at] == '.' && whole == kPowers.size()) {
        whole = digits;
      } else {
        break;
      }
    }
    if (digits == 0 || !endsAt(at)) return false;
    const double size = static_cast<double>(value) / kPowers[whole < digits ? digits - whole : 0];
    number = negative ? -size : size;
    position_ = at;
    return true;
  }

  // Goes behind the end of the line, from anywhere in the statement.
  void finish() {
    while (position_ < text_.size() && text_[position_] != '\n') {
      if (!skipContinuation()) ++position_;
    }
    if (position_ < text_.size()) {
      ++position_;
      ++line_;
    }
  }

 private:
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  static unsigned digit(char c) { return static_cast<unsigned>(c - '0'); }
  std::size_t firstOfWord() const {
    std::size_t at = position_;
    while (at < text_.size() && isSpace(text_[at])) ++at;
    return at;
  }
  // Whether a word ends here without doubt; at the end of the text and at a # next() knows more.
  bool endsAt(std::size_t at) const {
    return at < text_.size() && (isSpace(text_[at]) || text_[at] == '\n');
  }
  static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  // A table, because every character of a file is asked about.
  static bool maySplit(char c) {
    static constexpr std::array<bool, 256> kSplits = [] {
      std::array<bool, 256> splits{};
      for (const char s : {' ', '\t', '\r', '\n', '#', '\\'}) {
        splits[static_cast<unsigned char>(s)] = true;
      }
      return splits;
    }();
    return kSplits[static_cast<unsigned char>(c)];
  }
  bool isPlainBackslash() const { return text_[position_] == '\\' && continues() == 0; }

  // The length of a backslash and the line break behind it; 0 if there is none here.
  std::size_t continues() const {
    if (text_[position_] != '\\') return 0;
    const std::string_view rest = text_.substr(position_ + 1, 2);
    return rest.starts_with('\n') ? 2 : rest == "\r\n" ? 3 : 0;
  }
  bool skipContinuation() {
    const std::size_t length = continues();
    position_ += length;
    line_ += length > 0 ? 1 : 0;
    return length > 0;
  }
  void skipSpaces() {
    while (position_ < text_.size()) {
      if (isSpace(text_[position_])) {
        ++position_;
      } else if (!skipContinuation()) {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t& position_;
  std::size_t& line_;
};

// Behind the last line break that ends a statement; 0 if there is none. The text must begin where a
// statement does.
inline std::size_t endOfStatements(std::string_view text) {
  for (std::size_t end = text.size(); end > 0; --end) {
    if (text[end - 1] != '\n') continue;
    const std::string_view line = text.substr(0, end - 1);
    if (!line.ends_with('\\') && !line.ends_with("\\\r")) return end;
  }
  return 0;
}

}  // namespace pathmark
