#include "host/workshop.h"

#include "host/build_config.h"
#include "host/display_path.h"
#include "host/interrupt.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace pathmark {

namespace fs = std::filesystem;

BuildFolderError::BuildFolderError(const fs::path& folder, std::error_code why)
    : std::system_error(why),
      sentence_(fmt::format("{} cannot be written by this user ({}), and must be: coursework is "
                            "compiled there",
                            displayPath(folder), why.message())) {}

void makeBuildFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw BuildFolderError(folder, error);
}

ScratchFolder::ScratchFolder(Confinement* confinement) {
  if (confinement) {
    path_ = confinement->makeScratchFolder();
    return;
  }
  const fs::path workers = fs::path(build::kBuildFolder) / "workers";
  std::string name = (workers / "scratch.XXXXXX").string();
  makeBuildFolder(workers);
  if (!mkdtemp(name.data()))
    throw BuildFolderError(workers, std::error_code(errno, std::generic_category()));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

std::string Workshop::name() const { return confinement_ ? confinement_->name() : std::string(); }

std::string Workshop::visible(const fs::path& path) {
  if (!confinement_) return path.string();
  readable_.emplace_back(confinement_->visible(path), path);
  return readable_.back().first.string();
}

std::string Workshop::visibleFlag(std::string_view flag) {
  constexpr std::string_view kInclude = "-I/";
  if (!confinement_ || !flag.starts_with(kInclude)) return std::string(flag);
  return "-I" + visible(fs::path(flag.substr(2)));
}

std::vector<std::string> Workshop::prefixMaps() const {
  std::vector<std::string> maps;
  for (const auto& [seen, own] : readable_)
    if (seen != own) maps.push_back("-ffile-prefix-map=" + seen.string() + "=" + own.string());
  return maps;
}

ProcessResult Workshop::run(std::vector<std::string> command, const ScratchFolder& scratch) const {
  ProcessRequest request;
  request.arguments = std::move(command);
  request.goOn = [] { return !interrupted(); };
  const auto runStep = [&] {
    if (!confinement_) return runProcess(request);
    Confinement::Step step{std::move(request), scratch.path(), {}};
    for (const auto& [seen, own] : readable_) step.readable.push_back(seen);
    return confinement_->run(step);
  };
  ProcessResult result = runStep();
  if (result.stopped) throw Interrupted();
  // People know the files by their own places.
  for (const auto& [seen, own] : readable_) {
    const std::string from = seen.string(), to = own.string();
    if (from == to) continue;
    for (std::size_t k = 0; (k = result.output.find(from, k)) != std::string::npos; k += to.size())
      result.output.replace(k, from.size(), to);
  }
  return result;
}

}  // namespace pathmark
