#include "sandbox/landlock_tier.h"

#include "sandbox/landlock.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>

namespace pathmark::sandbox {

LandlockTier::LandlockTier(const Limits& limits)
    : ShutIn(limits), workerFilter_(workerFilter(true)), toolFilter_(toolFilter()) {}

std::string LandlockTier::name() const { return std::string(nameOf(Tier::kLandlock)); }

// A worker is executed by its descriptor: its user need not be able to reach its folder.
Started LandlockTier::start(Launch launch) {
  AccessRules rules;
  for (const auto& file : systemFiles(launch.worker)) rules.allowReading(file);
  for (const auto& file : launch.readable) rules.allowReading(file);
  if (!launch.scratch.empty()) rules.allowWriting(launch.scratch);
  FileDescriptor program;
  if (launch.worker) {
    program = FileDescriptor(open(launch.program.c_str(), O_PATH | O_CLOEXEC));
    if (program.get() < 0)
      throw std::system_error(errno, std::generic_category(), launch.program.string());
    rules.allowReading(program.get());
    launch.plan.program = program.get();
  }
  launch.plan.rules = rules.descriptor();
  launch.plan.powerless = true;
  launch.plan.filter = launch.worker ? workerFilter_ : toolFilter_;
  Started started;
  started.pid = startChild(launch.plan);
  return started;
}

}  // namespace pathmark::sandbox
