#include "host/lab.h"

#include "worker/contract.h"

#include <algorithm>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// Absolute, without "." and "..", and without a slash at its end.
fs::path plain(const fs::path& folder) {
  fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

bool hasCourseworkFile(const fs::path& folder) {
  const auto all = parts();
  return std::any_of(all.begin(), all.end(),
                     [&](const PartContract& part) { return fs::exists(folder / part.file); });
}

}  // namespace

bool isLab(const fs::path& folder) { return plain(folder).parent_path().filename() == "labs"; }

fs::path labOwner(const fs::path& folder) { return plain(folder).parent_path().parent_path(); }

std::vector<std::string> labNames(const fs::path& coursework) {
  std::vector<std::string> names;
  const fs::path labs = coursework / "labs";
  if (!fs::is_directory(labs)) return names;
  for (const auto& entry : fs::directory_iterator(labs))
    if (entry.is_directory() && hasCourseworkFile(entry.path()))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace pathmark
