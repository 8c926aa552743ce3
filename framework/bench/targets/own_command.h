// Running this program's own commands, as processes of their own.
//
//   OwnRun      what one took, and when it had said something
//   runOwn      runs one to its end
//   ownReport   runs one of bench, and reads the report that it writes
#pragma once

#include "bench/child_process.h"
#include "host/progress_bar.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::bench {

struct OwnRun {
  ChildUsage usage;
  double saidSeconds = 0.0;  // on the wall's clock, until it has printed `words`
};

// What it prints goes to the file `log`. Throws CourseworkError, with the log, if it fails for
// another reason than wrong coursework, and Interrupted.
OwnRun runOwn(const std::vector<std::string>& arguments, const std::filesystem::path& log,
              std::string_view words = "\n");

// In the folder `scratch`. From another thread `show` is told how far it is. Throws CourseworkError
// if it fails for any reason, and Interrupted.
nlohmann::ordered_json ownReport(std::vector<std::string> arguments,
                                 const std::filesystem::path& scratch,
                                 const std::function<void(const LoggedProgress&)>& show);

}  // namespace pathmark::bench
