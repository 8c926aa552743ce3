// ObjWords: the statements of a Wavefront OBJ file, word by word.
//
//   ObjWords            one statement's words
//   endOfStatements     where a piece of a file can be cut
//
// A backslash at the end of a line continues its statement on the next, a # ends it.
#pragma once

#include <array>
#include <cstddef>
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
