// Results as JSON, for other programs.
#pragma once

#include "checks/results.h"

#include <filesystem>
#include <string>

namespace pathmark::report {

// "pass", "fail", "undecided", "broken", "not written" or "blocked".
std::string statusName(checks::Status status);

std::string toJson(const checks::CourseworkResults& results);

// Throws ImageError if the file cannot be written.
void writeJson(const checks::CourseworkResults& results, const std::filesystem::path& file);

}  // namespace pathmark::report
