#include "kit/manifest.h"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include <fnmatch.h>

namespace pathmark::kit {

namespace {

[[noreturn]] void refuse(int number, const std::string& line) {
  throw std::runtime_error(
      fmt::format("grader/kit/contents.txt:{}: found \"{}\", allowed is text, image, bytes or "
                  "answers and a pattern, or text FILE as NAME.",
                  number, line));
}

void readLine(Manifest& manifest, int number, const std::string& line) {
  std::istringstream words(line);
  std::string kind, as, rest;
  ManifestLine entry{.number = number, .kind = FileKind::kText, .pattern = {}, .name = {}};
  if (!(words >> kind) || kind.starts_with('#')) return;
  words >> entry.pattern;
  if (words >> as && (as != "as" || !(words >> entry.name) || words >> rest)) refuse(number, line);
  if (entry.pattern.empty() || entry.pattern.starts_with('/')) refuse(number, line);
  if (kind == "answers") {
    if (!entry.name.empty()) refuse(number, line);
    manifest.answers.push_back(entry);
    return;
  }
  if (kind == "image")
    entry.kind = FileKind::kImage;
  else if (kind == "bytes")
    entry.kind = FileKind::kBytes;
  else if (kind != "text")
    refuse(number, line);
  manifest.taken.push_back(entry);
}

}  // namespace

Manifest readManifest(std::string_view text) {
  Manifest manifest;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) readLine(manifest, number, line);
  return manifest;
}

bool matches(const std::string& pattern, const std::string& path) {
  return fnmatch(pattern.c_str(), path.c_str(), FNM_PATHNAME | FNM_PERIOD) == 0;
}

const ManifestLine* lineFor(const std::vector<ManifestLine>& lines, const std::string& path) {
  for (const ManifestLine& line : lines)
    if (matches(line.pattern, path)) return &line;
  return nullptr;
}

}  // namespace pathmark::kit
