// PictureFolder: where a benchmark's pictures go; a folder of its run's own ends with it.
#pragma once

#include "host/build_config.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <system_error>

#include <unistd.h>

namespace pathmark::bench {

class PictureFolder {
 public:
  // A folder that is named is kept.
  explicit PictureFolder(const std::string& keep = {})
      : path_(keep.empty()
                  ? std::filesystem::path(build::kBuildFolder) / fmt::format("bench-{}", getpid())
                  : std::filesystem::absolute(keep)),
        kept_(!keep.empty()) {
    std::filesystem::create_directories(path_);
  }
  ~PictureFolder() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove_all(path_, ignored);
  }
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool kept_;
};

}  // namespace pathmark::bench
