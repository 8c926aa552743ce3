// What bench error found, for a person and for programs.
//
//   printErrors    tables on the terminal
//   errorsJson     all of it, single renders too
//   errorCharts    error against time, a chart for each scene
//   errorsHtml     a page that needs nothing from elsewhere
#pragma once

#include "bench/error_bench.h"
#include "bench/log_chart.h"

#include <string>
#include <vector>

namespace pathmark::bench {

void printErrors(const ErrorFindings& findings, const std::string& machine);

std::string errorsJson(const ErrorFindings& findings, const std::vector<ErrorRun>& runs,
                       const std::string& machine);

std::vector<LogChart> errorCharts(const ErrorFindings& findings);

std::string errorsHtml(const ErrorFindings& findings, const std::string& machine);

}  // namespace pathmark::bench
