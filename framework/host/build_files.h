// The project's and the build's folders, and what is noted in them about building coursework.
//
//   readLines         the lines of a file that are not empty
//   fileStamp         changes when a file is written anew
//   standInObjects    by place of the part
#pragma once

#include "host/build_config.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark {

inline const std::filesystem::path kBuildFolder{build::kBuildFolder};
inline const std::filesystem::path kProjectFolder{build::kProjectFolder};

// The names of the functions whose calls a recording worker leads elsewhere.
inline const std::filesystem::path kRecordedSymbols =
    kProjectFolder / "framework/worker/recorded.symbols";

std::vector<std::string> readLines(const std::filesystem::path& file);

std::string fileStamp(const std::filesystem::path& file);

std::vector<std::string> standInObjects();

}  // namespace pathmark
