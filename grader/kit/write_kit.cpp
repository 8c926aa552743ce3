#include "kit/write_kit.h"

#include "host/display_path.h"
#include "host/session.h"
#include "kit/for_students.h"
#include "kit/project_files.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace pathmark::kit {

namespace fs = std::filesystem;

namespace {

// Gone at the end, unless it has taken its name.
class UnfinishedFolder {
 public:
  explicit UnfinishedFolder(fs::path folder) : folder_(std::move(folder)) {
    fs::remove_all(folder_);  // of a run that was killed
    fs::create_directories(folder_);
  }
  ~UnfinishedFolder() {
    std::error_code error;
    if (!folder_.empty()) fs::remove_all(folder_, error);
  }
  UnfinishedFolder(const UnfinishedFolder&) = delete;
  UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;

  const fs::path& path() const { return folder_; }

  // An empty folder of that name gives way.
  void takeName(const fs::path& name) {
    fs::rename(folder_, name);
    folder_.clear();
  }

 private:
  fs::path folder_;
};

bool isInside(const fs::path& path, const fs::path& folder) {
  const fs::path relative =
      fs::weakly_canonical(path).lexically_relative(fs::weakly_canonical(folder));
  return !relative.empty() && *relative.begin() != "..";
}

void refuseWhatIsThere(const KitPlan& plan, const fs::path& destination) {
  const fs::file_status status = fs::symlink_status(destination);
  if (fs::exists(status) && !fs::is_directory(status))
    throw UsageError(
        fmt::format("{} is there and is no folder; a kit is written to a new folder "
                    "or to an empty one.",
                    displayPath(destination)));
  if (fs::exists(status) && !fs::is_empty(destination))
    throw UsageError(
        fmt::format("{} is not empty; a kit is written to a new folder or to an "
                    "empty one.",
                    displayPath(destination)));
  if (isInside(destination, plan.project) && !isInside(destination, plan.project / "build"))
    throw UsageError(fmt::format("{} lies inside the project; choose a folder outside of it.",
                                 displayPath(destination)));
}

void put(const KitPlan& plan, const KitFile& file, const fs::path& to) {
  fs::create_directories(to.parent_path());
  fs::copy_file(plan.project / file.from, to);
  if (to.extension() != ".md") return;
  const std::string whole = readFile(to), kept = forStudents(whole);
  if (kept == whole) return;
  std::ofstream out(to, std::ios::binary | std::ios::trunc);
  out << kept;
  out.close();
  if (!out) throw std::runtime_error(fmt::format("{} cannot be written.", displayPath(to)));
}

WrittenKit writeAndInspect(const KitPlan& plan, const fs::path& destination, const GoOn& goOn) {
  UnfinishedFolder folder(unfinishedFolder(destination));
  for (const KitFile& file : plan.files) {
    put(plan, file, folder.path() / file.name);
    if (!goOn()) return {};
  }
  WrittenKit written{.outcome = KitOutcome::kRefused,
                     .inspection = inspectKit(plan, folder.path())};
  if (!goOn()) return {};
  if (!written.inspection.findings.empty()) return written;
  folder.takeName(destination);
  written.outcome = KitOutcome::kWritten;
  return written;
}

}  // namespace

fs::path unfinishedFolder(const fs::path& destination) {
  const fs::path normal = fs::absolute(destination).lexically_normal();
  const fs::path whole = normal.has_filename() ? normal : normal.parent_path();
  return whole.parent_path() /
         fmt::format(".{}.pathmark-kit-unfinished", whole.filename().string());
}

WrittenKit writeKit(const KitPlan& plan, const fs::path& destination, const GoOn& goOn) {
  refuseWhatIsThere(plan, destination);
  try {
    return writeAndInspect(plan, destination, goOn);
  } catch (const fs::filesystem_error& e) {
    throw std::runtime_error(fmt::format("The kit cannot be written to {}: {}.",
                                         displayPath(destination), e.code().message()));
  }
}

}  // namespace pathmark::kit
