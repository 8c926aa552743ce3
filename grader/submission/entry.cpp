#include "submission/entry.h"

#include "scene/utf8.h"

#include <fmt/format.h>

namespace pathmark::submission {

namespace {

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = firstCharacter(text).bytes;
    if (bytes == 0) return false;
    text.remove_prefix(bytes);
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
