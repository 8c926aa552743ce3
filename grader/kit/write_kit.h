// writeKit: a folder for students, whole or not at all.
#pragma once

#include "kit/inspect_kit.h"
#include "kit/kit_plan.h"

#include <filesystem>
#include <functional>

namespace pathmark::kit {

// Asked after each file; false stops, and leaves nothing behind.
using GoOn = std::function<bool()>;

enum class KitOutcome { kWritten, kRefused, kStopped };

struct WrittenKit {
  KitOutcome outcome = KitOutcome::kStopped;
  Inspection inspection;
};

// Where a kit is written and inspected before it takes its name; in the same folder, so that
// renaming does not copy.
std::filesystem::path unfinishedFolder(const std::filesystem::path& destination);

// The kit is at `destination` only if the inspection found nothing. Throws UsageError if there is
// something at `destination` already or it lies inside the project, and std::runtime_error if a
// file cannot be read or written.
WrittenKit writeKit(
    const KitPlan& plan, const std::filesystem::path& destination,
    const GoOn& goOn = [] { return true; });

}  // namespace pathmark::kit
