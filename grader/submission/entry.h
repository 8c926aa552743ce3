// What a folder or an archive holds, one entry at a time.
//
//   Entry        name and kind of one
//   ReadEntry    its bytes
//   EntryPath    its name in pieces, or what is wrong with it
#pragma once

#include "submission/submission.h"

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::submission {

enum class EntryKind { kFile, kFolder, kSymbolicLink, kHardLink, kOther };

struct Entry {
  std::string path;  // as it stands in the archive, or relative to the folder
  EntryKind kind = EntryKind::kFile;
  bool encrypted = false;
};

// At most that many bytes; fewer only at the end. Throws Refusal if they cannot be read.
using ReadEntry = std::function<std::string(std::size_t atMost)>;

// What makes a whole submission unreadable: a sentence.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct EntryPath {
  std::vector<std::string> pieces;  // folders first; without "."
  std::string problem;              // "leads out of the submission"; empty if there is none
};

EntryPath splitPath(std::string_view path, const Limits& limits);

}  // namespace pathmark::submission
