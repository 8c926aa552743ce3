#include "kit/project_files.h"

#include "host/subprocess.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace pathmark::kit {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestList = std::size_t{64} << 20;

// Empty where there is no git, or where it knows nothing of this folder.
std::vector<std::string> filesOfGit(const fs::path& project) {
  ProcessRequest request;
  request.arguments = {"sh", "-c", "exec git -C \"$1\" ls-files -z 2>/dev/null", "sh",
                       project.string()};
  request.outputLimit = kLongestList;
  ProcessResult listed;
  try {
    listed = runProcess(request);
  } catch (const std::system_error&) {
    return {};
  }
  std::vector<std::string> files;
  if (listed.exitCode != 0) return files;
  for (std::size_t begin = 0; begin < listed.output.size();) {
    const std::size_t end = std::min(listed.output.find('\0', begin), listed.output.size());
    files.push_back(listed.output.substr(begin, end - begin));
    begin = end + 1;
  }
  return files;
}

std::vector<std::string> filesOnDisk(const fs::path& project) {
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator entry(project), end; entry != end; ++entry) {
    const std::string path = entry->path().lexically_relative(project).generic_string();
    if (path == "build" || path == ".git") entry.disable_recursion_pending();
    if (!entry->is_directory() || entry->is_symlink()) files.push_back(path);
  }
  return files;
}

}  // namespace

std::vector<std::string> projectFiles(const fs::path& project) {
  std::vector<std::string> files = filesOfGit(project);
  if (files.empty()) files = filesOnDisk(project);
  std::sort(files.begin(), files.end());
  // A file that is being merged is listed more than once.
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

std::string readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad())
    throw std::runtime_error(fmt::format("{} cannot be read.", file.string()));
  return content;
}

}  // namespace pathmark::kit
