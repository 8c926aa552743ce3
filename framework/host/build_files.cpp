#include "host/build_files.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace pathmark {

namespace fs = std::filesystem;

std::vector<std::string> readLines(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

// Without reading it.
std::string fileStamp(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  return fmt::format("{} {} {}\n", file.string(), time, fs::file_size(file, error));
}

std::vector<std::string> standInObjects() {
  return readLines(kBuildFolder / "standin_objects.txt");
}

}  // namespace pathmark
