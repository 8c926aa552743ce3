// Part 7: the scenes of a coursework, each checked for itself.
//
//   SceneFinding   what there is to say of one
//   checkScenes    of all files in the coursework's folder scenes/
//
// Nothing in a scene can be wrong but its format, and that there is nothing to be seen. What is
// measured is for its author: whether the noise is where the caption expects it.
#pragma once

#include "checks/check.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::checks {

struct SceneFinding {
  std::filesystem::path file;
  Status status = Status::kPass;
  std::string message;               // what is wrong, or in the way
  std::string noise;                 // where it is, of a scene that was rendered
  std::optional<WorkerFault> fault;  // of what is broken: how the worker ended
};

// The worker of the whole coursework.
struct WholeWorker {
  std::string blocker;  // what is in the way of rendering: a part, or a function
  std::function<WorkerProcess&()> get;
  std::function<void()> forget;  // after it has died
  std::function<bool()> goOn;    // asked before each scene; if it says no, the rest is left out
};

// Those that were checked until it had to stop.
std::vector<SceneFinding> checkScenes(const std::filesystem::path& coursework,
                                      const WholeWorker& worker, std::uint64_t seed);

}  // namespace pathmark::checks
