#include "bench/report_file.h"

#include "film/atomic_file.h"
#include "host/output_file.h"

#include <CLI/CLI.hpp>

namespace pathmark::bench {

void addJsonOption(CLI::App& command, std::string& file) {
  command.add_option("--json", file, "Also write all of it as JSON")->type_name("FILE");
}

void refuseJsonFile(const std::string& file) {
  if (file.empty()) return;
  requirePlaceForFile("--json", file);
  tryToWriteBeside(file);
}

void writeJson(const std::string& file, const Report& report) {
  if (!file.empty()) writeFileAtomically(file, reportJson(report));
}

}  // namespace pathmark::bench
