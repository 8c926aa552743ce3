// Confinement: where programs run that read coursework or hold it.
//
//   Confinement   compiling, linking and running; one that shuts coursework in is given by those
//                 who do not trust it
//
// Without one, programs run as this process does, with limits only.
#pragma once

#include "host/subprocess.h"
#include "host/worker_launch.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pathmark {

class Confinement {
 public:
  virtual ~Confinement() = default;

  // Part of the key under which results are kept: nothing that was made outside is used inside.
  virtual std::string name() const = 0;

  // One step of making a worker. `scratch` is the only folder that may be written; of the others
  // the step sees only those files and folders that are named here, and the system's own.
  struct Step {
    ProcessRequest request;
    std::filesystem::path scratch;
    std::vector<std::filesystem::path> readable;
  };
  virtual ProcessResult run(const Step& step) = 0;

  // A worker, as launchWorker starts it.
  virtual LaunchedWorker launch(const std::filesystem::path& program, std::size_t memoryBytes) = 0;
};

}  // namespace pathmark
