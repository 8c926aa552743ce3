#include "submission/entry.h"

#include <fmt/format.h>

namespace pathmark::submission {

namespace {

// The Unicode Standard, table 3-7: no overlong forms, no surrogates, nothing above U+10FFFF.
bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t at) {
      return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
    };
    const unsigned first = byte(i), second = byte(i + 1);
    std::size_t more = 0;
    if (first >= 0xc2 && first <= 0xdf) more = 1;
    if (first >= 0xe0 && first <= 0xef) more = 2;
    if (first >= 0xf0 && first <= 0xf4) more = 3;
    if (first >= 0x80 && more == 0) return false;
    const bool badSecond = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                           (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    if (badSecond) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((byte(i + k) & 0xc0) != 0x80) return false;
    i += more + 1;
  }
  return true;
}

bool hasControlCharacter(std::string_view text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return true;
  return false;
}

bool hasDriveLetter(std::string_view path) {
  return path.size() >= 2 && path[1] == ':' &&
         ((path[0] >= 'a' && path[0] <= 'z') || (path[0] >= 'A' && path[0] <= 'Z'));
}

std::string problemOf(std::string_view path, const Limits& limits) {
  if (path.empty()) return "has no name that can be read";
  if (path.size() > limits.pathBytes)
    return fmt::format("has a name of {} bytes, but at most {} are allowed", path.size(),
                       limits.pathBytes);
  if (hasControlCharacter(path)) return "has a control character in its name";
  if (!isUtf8(path)) return "has a name that is not UTF-8";
  if (path.front() == '/') return "has an absolute name";
  if (hasDriveLetter(path)) return "has a drive letter in its name";
  if (path.find('\\') != std::string_view::npos) return "has a backslash in its name";
  return {};
}

}  // namespace

EntryPath splitPath(std::string_view path, const Limits& limits) {
  EntryPath result;
  result.problem = problemOf(path, limits);
  if (!result.problem.empty()) return result;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    const std::string_view piece = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    if (piece.empty() || piece == ".") continue;
    if (piece == "..") {
      result.problem = "leads out of the submission";
      return result;
    }
    result.pieces.emplace_back(piece);
  }
  if (result.pieces.size() > limits.pathDepth)
    result.problem = fmt::format("lies {} folders deep, but at most {} are allowed",
                                 result.pieces.size(), limits.pathDepth);
  return result;
}

}  // namespace pathmark::submission
