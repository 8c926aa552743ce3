// The names of submissions.
//
//   safeName       a name that is safe as a folder's, in a table and in a report
//   UniqueNames    the same name a second time gets -2
//   naturalLess    "task 9" before "task 10"
//   archiveStem    "work" for "work.tar.gz"; nothing if the name is not an archive's
//   looksLikePart  whether a file may be one of the coursework's under another name
//   numberOfPart   3 for "part3.cpp"
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace pathmark::submission {

inline constexpr std::size_t kLongestName = 80;  // bytes

std::string lowerCase(std::string_view text);  // of ASCII letters

// Letters of all scripts stay: names differ as those of the folders do.
std::string safeName(std::string_view name);

class UniqueNames {
 public:
  // `safe` is a safeName. Capitals count as small letters, as in some file systems.
  std::string unique(const std::string& safe);

  // Nobody else gets it.
  void take(const std::string& name) { taken_.insert(lowerCase(name)); }
  bool isTaken(const std::string& name) const { return taken_.contains(lowerCase(name)); }

 private:
  std::set<std::string> taken_;  // in small letters
};

bool naturalLess(std::string_view a, std::string_view b);

std::optional<std::string> archiveStem(std::string_view name);

// "part3.cpp", "part3_lambertian (1).cpp"
bool looksLikePart(std::string_view name);

// Nothing for "parts.cpp".
std::optional<int> numberOfPart(std::string_view name);

}  // namespace pathmark::submission
