// Manifest: contents.txt, which says what a student kit is made of.
//
//   FileKind       what a file of a kit may hold
//   Manifest       which files are taken, as what, and which are answers
//   readManifest   from its text
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::kit {

enum class FileKind { kText, kImage, kBytes };

struct ManifestLine {
  int number = 0;  // in contents.txt
  FileKind kind = FileKind::kText;
  std::string pattern;
  std::string name;  // in the kit; empty: the file's own
};

struct Manifest {
  std::vector<ManifestLine> taken;
  std::vector<ManifestLine> answers;
};

// Throws std::runtime_error with a sentence that names the line.
Manifest readManifest(std::string_view text);

// Whether a path, relative to the project's folder, is one of the pattern's.
bool matches(const std::string& pattern, const std::string& path);

// The first line that takes this file; nullptr if none does.
const ManifestLine* lineFor(const std::vector<ManifestLine>& lines, const std::string& path);

}  // namespace pathmark::kit
