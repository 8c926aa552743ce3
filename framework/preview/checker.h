// Checker: what the window asks of the grader, which the framework does not know: the grader
// implements it.
//
//   FunctionVerdict   what the checks say of a function
//   CheckReport       of all functions
//   makeChecker       the grader's
#pragma once

#include "host/coursework_builder.h"
#include "worker/contract.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace pathmark::preview {

enum class Outcome { kUnknown, kPass, kFail, kUndecided, kBroken, kNotWritten, kBlocked };

struct CheckLine {
  std::string id;         // "3.3/samples"
  std::string statement;  // that is tested
  Outcome outcome = Outcome::kUnknown;
  std::string found;    // lines: where, expected, got, tolerance, likely cause; empty of a pass
  std::string note;     // of a pass: right, but noisier than it could be
  std::string command;  // that repeats it

  // The lines of `found`, one by one.
  struct Field {
    std::string name, value;
  };
  std::vector<Field> fields;
};

struct FunctionVerdict {
  CourseworkFunction function = CourseworkFunction::kRayTriangleIntersection;
  Outcome outcome = Outcome::kUnknown;
  std::vector<CheckLine> checks;
  std::string blocker;      // of a blocked one: "by 3.1 lambertianBRDF::brdf"
  std::uint64_t build = 0;  // CourseworkState::number that it is about
};

// Immutable once it is made.
struct CheckReport {
  std::uint64_t build = 0;  // CourseworkState::number that it is about
  bool finished = false;    // of the functions; while it is not, outcomes may be kUnknown
  double fraction = 0.0;    // [0,1]
  std::string current;      // id of the check that is being made, while it is not finished
  std::vector<FunctionVerdict> functions;  // all of the contract, in its order
  std::vector<std::string> failures;       // by part: why it could not be checked; empty if it can

  // Once it is finished.
  std::string headline;  // what is right, or why nothing could be checked
  std::string next;      // what to do next; empty if all is right
  std::optional<CourseworkFunction> nextFunction;

  const FunctionVerdict* find(CourseworkFunction function) const {
    for (const FunctionVerdict& f : functions)
      if (f.function == function) return &f;
    return nullptr;
  }
};

class Checker {
 public:
  virtual ~Checker() = default;

  // Checks all functions of the parts that have changed since the last call, without pictures.
  // Runs on the calling thread and may take seconds; `onReport` gets what there is so far. Stops
  // early, with no further report, when asked to. Never throws: what goes wrong is the headline.
  virtual void check(const CourseworkBuild& build, std::uint64_t number, std::stop_token stop,
                     const std::function<void(std::shared_ptr<const CheckReport>)>& onReport) = 0;

  // Up to three, from a nudge to nearly the answer; empty if there are none. From any thread, also
  // while there is a check.
  virtual std::vector<std::string> hints(CourseworkFunction function) = 0;
};

struct CheckerOptions {
  std::uint64_t seed = 1;  // of the random inputs
  unsigned threads = 1;    // parts that are checked at the same time
};

// The grader defines it.
std::unique_ptr<Checker> makeChecker(const CheckerOptions& options);

}  // namespace pathmark::preview
