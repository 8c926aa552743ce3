// KitPlan: which files a kit will hold, from where, and what must not be found in it.
#pragma once

#include "kit/manifest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::kit {

// Part 7 is scenes.
inline constexpr int kScenesPart = 7, kLastPart = 9;
inline constexpr int kNothingReleased = -1;

struct KitFile {
  std::string from;  // relative to the project; a chapter goes through forStudents
  std::string name;  // relative to the kit
  FileKind kind = FileKind::kText;
};

struct KitPlan {
  std::filesystem::path project;
  int releasedThrough = kNothingReleased;
  std::vector<KitFile> files;        // sorted by name
  std::vector<std::string> answers;  // hidden files of which nothing may be quoted, sorted by lines
                                     // of contents.txt
  std::vector<std::string> hidden;   // all others that are not in the kit
};

// With parts 0 to releasedThrough as in solutions/. Throws std::runtime_error with a sentence if a
// line of contents.txt matches nothing, or a file is missing or is a link.
KitPlan planKit(const std::filesystem::path& project, int releasedThrough);

}  // namespace pathmark::kit
