#include "submission/names.h"

#include "scene/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pathmark::submission {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isSafe(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '_' ||
         c == '-';
}

// Longer endings before those that they end in.
constexpr std::array<std::string_view, 13> kArchiveEndings{
    ".tar.gz", ".tar.xz", ".tar.bz2", ".tar.zst", ".tar.lzma", ".tgz", ".txz",
    ".tbz2",   ".tbz",    ".tzst",    ".tlz",     ".zip",      ".tar"};

constexpr std::string_view kPart = "part";

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string safeName(std::string_view name) {
  std::string safe;
  while (!name.empty()) {
    const std::size_t bytes = isSafe(name.front()) ? 1 : bytesOfNameLetter(name);
    // A run of other characters becomes one '_'.
    if (bytes > 0) {
      safe += name.substr(0, bytes);
    } else if (safe.empty() || safe.back() != '_') {
      safe += '_';
    }
    name.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  // Neither hidden, nor an option, nor ".".
  safe.erase(0, std::min(safe.find_first_not_of(".-"), safe.size()));
  safe.resize(cutAtCharacter(safe, kLongestName).size());
  const bool saysSomething = safe.find_first_not_of("._-") != std::string::npos;
  return saysSomething ? safe : "submission";
}

std::string UniqueNames::unique(const std::string& safe) {
  std::string name = safe;
  for (int count = 2; !taken_.insert(lowerCase(name)).second; ++count) {
    const std::string ending = fmt::format("-{}", count);
    name = fmt::format("{}{}", cutAtCharacter(safe, kLongestName - ending.size()), ending);
  }
  return name;
}

bool naturalLess(std::string_view a, std::string_view b) {
  const std::string x = lowerCase(a), y = lowerCase(b);
  std::size_t i = 0, j = 0;
  while (i < x.size() && j < y.size()) {
    if (isDigit(x[i]) && isDigit(y[j])) {
      // Numbers of any length: without leading zeros the longer one is larger.
      while (i < x.size() && x[i] == '0') ++i;
      while (j < y.size() && y[j] == '0') ++j;
      const std::size_t from = i, start = j;
      while (i < x.size() && isDigit(x[i])) ++i;
      while (j < y.size() && isDigit(y[j])) ++j;
      if (i - from != j - start) return i - from < j - start;
      const int order = x.compare(from, i - from, y, start, j - start);
      if (order != 0) return order < 0;
    } else if (x[i] != y[j]) {
      return static_cast<unsigned char>(x[i]) < static_cast<unsigned char>(y[j]);
    } else {
      ++i, ++j;
    }
  }
  const std::size_t restX = x.size() - i, restY = y.size() - j;
  return restX != restY ? restX < restY : a < b;
}

std::optional<std::string> archiveStem(std::string_view name) {
  const std::string lower = lowerCase(name);
  for (const std::string_view ending : kArchiveEndings)
    if (lower.size() > ending.size() && lower.ends_with(ending))
      return std::string(name.substr(0, name.size() - ending.size()));
  return std::nullopt;
}

bool looksLikePart(std::string_view name) {
  const std::string lower = lowerCase(name);
  return lower.starts_with(kPart) && lower.find(".cpp") != std::string::npos;
}

std::optional<int> numberOfPart(std::string_view name) {
  const std::size_t digit = kPart.size();
  if (!lowerCase(name).starts_with(kPart) || name.size() <= digit || !isDigit(name[digit]))
    return std::nullopt;
  return name[digit] - '0';
}

}  // namespace pathmark::submission
