// What the tiers of the sandbox have in common: copies, scratch folders, limits, users.
//
//   Launch    a program that is to be shut in
//   ShutIn    a Confinement but for the walls
#pragma once

#include "sandbox/child.h"
#include "sandbox/sandbox.h"
#include "sandbox/staging.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::sandbox {

struct Launch {
  // Arguments, environment, standard descriptors, limits and user; the walls add the rest.
  ChildPlan plan;
  bool worker = false;
  std::filesystem::path program;  // of a worker
  std::filesystem::path scratch;
  std::vector<std::filesystem::path> readable;
};

struct Started {
  pid_t pid = -1;
  pid_t inner = -1;
  FileDescriptor innerHandle;
  // Asked after the end: a sentence if the program never began.
  std::function<std::string()> startFailure;
};

class ShutIn : public Confinement {
 public:
  explicit ShutIn(const Limits& limits);

  std::filesystem::path visible(const std::filesystem::path& path) override;
  std::filesystem::path makeScratchFolder() override;
  ProcessResult run(const Step& step) override;
  LaunchedWorker launch(const std::filesystem::path& program, std::size_t memoryBytes) override;

 protected:
  virtual Started start(Launch launch) = 0;
  const Limits& limits() const { return limits_; }

 private:
  std::vector<Limit> workerLimits(std::size_t memoryBytes) const;
  std::vector<Limit> toolLimits(double seconds) const;

  Limits limits_;
  Staging staging_;
  std::size_t otherProcesses_;  // that may count as a program's own
};

// Folders and files of the system that programs need to start, and compilers besides. `worker`:
// libraries only.
std::vector<std::filesystem::path> systemFiles(bool worker);

}  // namespace pathmark::sandbox
