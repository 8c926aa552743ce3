// From the grader's results to what the preview window shows of them.
#pragma once

#include "checks/results.h"
#include "preview/checker.h"

#include <cstdint>
#include <filesystem>

namespace pathmark {

// What is in the results; all other functions are unknown. `folder` is that of the coursework.
preview::CheckReport reportOf(const checks::CourseworkResults& results, std::uint64_t build,
                              const std::filesystem::path& folder);

// The same, with what is said of all functions together.
preview::CheckReport finishedReport(const checks::CourseworkResults& results, std::uint64_t build,
                                    const std::filesystem::path& folder);

}  // namespace pathmark
