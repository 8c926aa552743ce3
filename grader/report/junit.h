// JUnit XML, for continuous integration: a test case for each check.
//
// wrong                                a failure
// crashed, stopped, does not compile   an error
// not written, blocked                 skipped
// undecided                            passed, with the words as output
#pragma once

#include "report/graded.h"

#include <string>

namespace pathmark::report {

std::string junitXml(const record::SubmissionRecord& record);

// The same of all of them, in one file.
std::string junitXml(GradedClass graded);

}  // namespace pathmark::report
