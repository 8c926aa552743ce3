// Where a benchmark's JSON goes.
#pragma once

#include "bench/report.h"

#include <string>

namespace CLI {
class App;
}

namespace pathmark::bench {

// --json FILE
void addJsonOption(CLI::App& command, std::string& file);

// Before the work begins. Throws UsageError.
void refuseJsonFile(const std::string& file);

// Writes the report unless `file` is empty. Throws ImageError.
void writeJson(const std::string& file, const Report& report);

}  // namespace pathmark::bench
