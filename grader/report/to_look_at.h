// What a person should look at before the marks of a class are handed out.
//
//   sameFiles   of each submission, which others have the same files
//   reviewOf    what the marks of one say, and why a picture of it is missing
#pragma once

#include "report/graded.h"

#include <string>
#include <vector>

namespace pathmark::report {

// "The same files as in lee_99999.", in the order of the class; empty where there is no other. What
// was not graded, and what is nothing but stubs as they were handed out, is nobody's copy.
std::vector<std::string> sameFiles(GradedClass graded);

// Sentences.
std::vector<std::string> reviewOf(const Graded& graded);

}  // namespace pathmark::report
