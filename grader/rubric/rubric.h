// What things are worth: the rubric, and the marks that follow from it and from a record.
//
//   Rubric           points, credits and bands
//   readRubric       from a file such as rubric.json; rubric.schema.json says what may stand in it
//   markSubmission   marks, with the reason for each that is lost
//
// Marks depend on nothing but record and rubric. A larger bias never earns more, an efficiency that
// may lie in two bands earns the higher one, and what went wrong in the grader or the machine costs
// nothing.
#pragma once

#include "record/record.h"
#include "rubric/marks.h"

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace pathmark::rubric {

// One sentence for a person: file, line, JSON pointer, what was found, what is allowed.
class RubricError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Parts are numbered as in Marks.
inline constexpr int kScenesPart = 7, kWholePart = 10;

struct PartRubric {
  int part = 0;
  double points = 0.0;      // of all its functions and of its efficiency
  double efficiency = 0.0;  // those of its efficiency

  // By section of the handouts, "3.3"; 1 for a function that is not named.
  std::map<std::string, double> weights;

  // By id, "2.6/repeatable": what is lost if nothing but such checks of a function fails.
  std::map<std::string, double> checks;

  bool bonus = false;  // its points come on top of those that can be had
};

// The credit, a share of the points, while the bias of the worst picture is at most that.
struct BiasBand {
  double biasAtMost = 0.0, credit = 0.0;
};

// The credit from that efficiency on, relative to that of the solutions.
struct EfficiencyBand {
  double ratioAtLeast = 0.0, credit = 0.0;
};

struct Rubric {
  std::vector<PartRubric> parts;  // in their order; one that is not there counts nothing
  double step = 0.5;              // to which the points of a part are rounded; 0: not at all

  // Of what is wrong.
  std::vector<BiasBand> biasBands{{0.005, 1.0}, {0.02, 0.8}, {0.05, 0.6}, {0.15, 0.4}, {0.5, 0.2}};
  double wrongAtMost = 0.8;  // credit for a function that is wrong, however small the bias
  // Credit for one whose part appears in no picture; at most that where some of it is no radiance.
  double withoutPicture = 0.3;

  // Of what ended before it was done.
  double crashed = 0.0, timeLimit = 0.0, memoryLimit = 0.0, outputLimit = 0.0, forbiddenCall = 0.0;

  std::vector<EfficiencyBand> efficiencyBands{{0.1, 0.25}, {0.25, 0.5}, {0.5, 0.75}, {0.8, 1.0}};
  double reviewAbove = 3.0;  // an efficiency that a person should look at

  std::filesystem::path file;  // that it was read from
};

std::filesystem::path defaultRubric();  // the file rubric.json beside this one

// Throws RubricError.
Rubric readRubric(const std::filesystem::path& file);

// Parts of which the record says nothing were not graded, and are left out.
Marks markSubmission(const record::SubmissionRecord& record, const Rubric& rubric);

}  // namespace pathmark::rubric
