// What a class is in numbers.
//
//   partsOf      the parts that have marks in any of the submissions
//   marksOf      of one part of one submission; null if there are none
//   largestTotal   what the marks are out of
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

// The most of any submission: one that was not graded is out of nothing.
double largestTotal(GradedClass graded);

// Totals of all submissions that have marks: no marks are not 0.
std::vector<double> totalsOf(GradedClass graded);
std::vector<double> pointsOfPart(GradedClass graded, int part);

// 0 of nothing.
double meanOf(const std::vector<double>& values);
double medianOf(std::vector<double> values);

}  // namespace pathmark::report
