// Confinement: where programs run that read coursework or hold it.
//
//   Confinement        compiling, linking and running; one that shuts coursework in is given by
//                      those who do not trust it
//   ConfinementError   the machine cannot confine; it says nothing of the coursework
//
// Without one, programs run as this process does, with limits only.
#pragma once

#include "host/subprocess.h"
#include "host/worker_launch.h"

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace pathmark {

class ConfinementError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Used by several threads at once. All functions throw ConfinementError or std::system_error where
// the machine fails.
class Confinement {
 public:
  virtual ~Confinement() = default;

  // Part of the key under which results are kept: nothing that was made outside is used inside.
  virtual std::string name() const = 0;

  // Where steps find a file or folder of this process: at its own place, or in a copy that they may
  // read. Paths in the arguments of a step are such paths.
  virtual std::filesystem::path visible(const std::filesystem::path& path) = 0;

  // A new folder for steps to write in; the caller removes it.
  virtual std::filesystem::path makeScratchFolder() = 0;

  // One step of making a worker. `scratch` is the only folder that may be written; of the others
  // the step sees only those visible files and folders that are named here, and the system's own.
  struct Step {
    ProcessRequest request;
    std::filesystem::path scratch;
    std::vector<std::filesystem::path> readable;
  };
  virtual ProcessResult run(const Step& step) = 0;

  // A worker, as launchWorker starts it, by its path in this process.
  virtual LaunchedWorker launch(const std::filesystem::path& program, std::size_t memoryBytes) = 0;
};

}  // namespace pathmark
