// What a class is in numbers.
//
//   partsOf      the parts that have marks in any of the submissions
//   marksOf      of one part of one submission; null if there are none
//   totalsOf, pointsOfPart   of every submission that was graded
//   meanOf, medianOf
#pragma once

#include "report/graded.h"

#include <string>
#include <vector>

namespace pathmark::report {

struct ClassPart {
  int part = 0;
  std::string title;
  double outOf = 0.0;  // the most of any submission
};
std::vector<ClassPart> partsOf(GradedClass graded);

const rubric::PartMarks* marksOf(const Graded& graded, int part);

// Totals of all submissions whose record is complete: an internal error is nobody's mark.
std::vector<double> totalsOf(GradedClass graded);
std::vector<double> pointsOfPart(GradedClass graded, int part);

// 0 of nothing.
double meanOf(const std::vector<double>& values);
double medianOf(std::vector<double> values);

}  // namespace pathmark::report
