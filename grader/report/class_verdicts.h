// What went wrong most often in a class.
#pragma once

#include "report/graded.h"
#include "report/html_text.h"

#include <map>
#include <string>
#include <vector>

namespace pathmark::report {

struct FunctionCount {
  std::string section, name;
  std::map<record::Verdict, std::size_t> verdicts;  // submissions with each

  std::size_t notOk() const;
};

// Every function of the coursework, with the most often failed first. The functions of a part that
// could not be tried count with the verdict of the part.
std::vector<FunctionCount> functionCounts(GradedClass graded);

// A table of them with a bar each; only those that somebody did not get right.
Markup functionCountsHtml(const std::vector<FunctionCount>& counts, std::size_t submissions);

}  // namespace pathmark::report
