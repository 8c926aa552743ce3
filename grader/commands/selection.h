// selectChecks: from the word on the command line to checks.
#pragma once

#include "checks/runner.h"

#include <string>

namespace pathmark {

// "" for all; "3" or "part3"; "3.3"; "lambertianBRDF::reflection" or "reflection" where only one
// function ends so; "3.3/samples"; "images" or "images/mean". Throws UsageError for anything else,
// with all functions that it may mean.
checks::Selection selectChecks(const std::string& what);

}  // namespace pathmark
