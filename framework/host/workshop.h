// Where the steps of making a worker are done: in a confinement, or outside.
//
//   BuildFolderError   the build folder cannot be written, which is needed with and without a
//                      confinement
//   makeBuildFolder    a folder in it
//   ScratchFolder      a folder of its own for one step of the work, gone afterwards
//   Workshop           runs steps
#pragma once

#include "host/confinement.h"

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace pathmark {

// A sentence without its full stop.
class BuildFolderError : public std::system_error {
 public:
  BuildFolderError(const std::filesystem::path& folder, std::error_code why);
  const char* what() const noexcept override { return sentence_.c_str(); }

 private:
  std::string sentence_;
};

// With those that it lies in, if they are not there. Throws BuildFolderError.
void makeBuildFolder(const std::filesystem::path& folder);

class ScratchFolder {
 public:
  // In the confinement's place for them, or in the build folder. Throws std::system_error, of which
  // BuildFolderError is one.
  explicit ScratchFolder(Confinement* confinement);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

class Workshop {
 public:
  explicit Workshop(std::shared_ptr<Confinement> confinement)
      : confinement_(std::move(confinement)) {}

  Confinement* confinement() const { return confinement_.get(); }

  // Part of the keys under which results are kept; empty outside of confinements.
  std::string name() const;

  // Where a step finds this file or folder; remembers that it may read it.
  std::string visible(const std::filesystem::path& path);

  // A flag of the compiler; the folder of one such as -I/opt/glm becomes visible.
  std::string visibleFlag(std::string_view flag);

  // "-ffile-prefix-map=A=B" for what is visible elsewhere than it is.
  std::vector<std::string> prefixMaps() const;

  // Throws Interrupted, if this process is, rather than wait for the end of the step; and what
  // Confinement::run throws.
  ProcessResult run(std::vector<std::string> command, const ScratchFolder& scratch) const;

 private:
  std::shared_ptr<Confinement> confinement_;
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> readable_;  // visible, own
};

}  // namespace pathmark
