// The marks of one submission: points for functions, parts and pictures, each with its reason.
//
//   MarkLine    points of one thing, and why not all of them
//   PartMarks   the lines of a part
//   Marks       all of it
#pragma once

#include <string>
#include <vector>

namespace pathmark::rubric {

// What the lines are called that are of no function.
inline constexpr const char* kEfficiencyLine = "efficiency";
inline constexpr const char* kRoundingLine = "rounding";

struct MarkLine {
  std::string what;  // "3.3 lambertianBRDF::reflection", "efficiency"
  double points = 0.0, outOf = 0.0;
  std::string reason;  // empty where there is nothing to say: "the picture is 2.1 % (1.9 to 2.3 %) off: ..."
};

struct PartMarks {
  int part = 0;       // 0 to 9; 10 stands for the whole as submitted
  std::string title;  // "Part 3: The Lambertian BRDF"
  double points = 0.0, outOf = 0.0;
  std::vector<MarkLine> lines;
};

struct Marks {
  double points = 0.0, outOf = 0.0;
  std::vector<PartMarks> parts;

  // What a person should look at before the marks are handed out: sentences.
  std::vector<std::string> toReview;

  std::string rubric{};  // the file of the rubric, where it is not the default one
};

}  // namespace pathmark::rubric
