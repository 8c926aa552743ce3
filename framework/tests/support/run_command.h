// Runs a command as a user would, and keeps what it printed.
#pragma once

#include "host/subprocess.h"

#include <string>
#include <vector>

namespace pathmark::test {

inline ProcessResult run(std::vector<std::string> arguments,
                         const std::filesystem::path& folder = {}) {
  ProcessRequest request;
  request.arguments = std::move(arguments);
  request.folder = folder;
  return runProcess(request);
}

}  // namespace pathmark::test
