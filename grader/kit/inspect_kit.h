// inspectKit: is anything in a kit that must not be?
//
// It reads the kit as it lies on disk, not the plan that it was written from.
#pragma once

#include "kit/kit_plan.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::kit {

struct Inspection {
  std::size_t files = 0, bytes = 0;   // that were searched
  std::size_t hiddenFiles = 0;        // whose text was looked for
  std::vector<std::string> findings;  // a sentence for each, with file and line
};

// Looks for files and links that the plan does not have, files that are not of their kind, copies
// and quotations of hidden files, names of this machine's folders, and parts that are solved and
// must not be, or the other way round.
Inspection inspectKit(const KitPlan& plan, const std::filesystem::path& folder);

}  // namespace pathmark::kit
