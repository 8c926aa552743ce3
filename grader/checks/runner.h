// Running the checks of a coursework, each part in a worker of its own with stand-ins for the
// others.
//
//   Selection      which checks to run
//   runChecks      runs them, several parts at the same time
#pragma once

#include "checks/results.h"
#include "host/coursework_builder.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pathmark::checks {

struct Selection {
  std::vector<int> parts{0, 1, 2, 3, 4, 5, 6, 8, 9};  // one thread checks them in this order
  bool images = true;
  bool scenes = true;  // of part 7
  std::string only;    // an id or a section, such as "3.3/samples" or "3.3"; empty: all
  std::vector<CourseworkFunction> functions{};  // no others are looked at; empty: all

  bool selects(const Check& check) const;
  bool selects(CourseworkFunction function) const;
};

struct RunOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: one for each processor
  double secondsWithoutAnswer = 5.0;
  std::size_t memoryBytes = WorkerLimits{}.memoryBytes;  // of a worker
  std::function<void(std::string_view)> onText;          // what the coursework prints
  bool untilWrong = false;  // a function that has failed a check is not asked any more
  bool diagnose = true;     // what is wrong is compared with known mistakes

  // Results of parts that are not selected this time, which become part of the new ones.
  const CourseworkResults* known = nullptr;
};

// Called from several threads, but never from two at once.
struct RunEvents {
  // What is done, and the check that is begun.
  std::function<void(double fraction, const std::string& id)> onProgress;
  std::function<void(const PartResult&)> onPart;              // all checks of it are done
  std::function<void(const CourseworkResults&)> onFunctions;  // before the images

  // Asked before each check and each scene, and a few times a second while a worker is waited for.
  // If it says no, the rest is left out: of functions the parts that are not done, of pictures and
  // scenes those that are not.
  std::function<bool()> goOn;
};

// The workers run where the coursework was compiled: confined, or not. Throws std::system_error or
// ConfinementError where the machine cannot start a worker.
CourseworkResults runChecks(const CourseworkBuild& build, const Selection& selection,
                            const RunOptions& options, const RunEvents& events = {});

}  // namespace pathmark::checks
