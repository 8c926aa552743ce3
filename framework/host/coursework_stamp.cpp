#include "host/coursework_stamp.h"

#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

std::string stampOf(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const PartContract& part : parts()) files.push_back(folder / part.file);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "scenes", error))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string text;
  for (const fs::path& file : files) {
    const auto time = fs::last_write_time(file, error).time_since_epoch().count();
    text += fmt::format("{} {} {}\n", file.string(), error ? 0 : time, fs::file_size(file, error));
  }
  return text;
}

}  // namespace pathmark
