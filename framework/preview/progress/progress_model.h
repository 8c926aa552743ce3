// What the progress panel shows, without the drawing: parts, functions, and what is next.
//
//   FunctionRow    a function, and what is known of it
//   PartRow        the functions of a part
//   Progress       all of them, and what is said of all together
//   progressOf     from a coursework and its checks
//   withOlder      what is known of functions that have not been checked again
#pragma once

#include "preview/checker.h"
#include "preview/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace pathmark::preview {

struct FunctionRow {
  FunctionContract function;
  Outcome outcome = Outcome::kUnknown;
  bool older = false;                        // the outcome is of an older build
  const FunctionVerdict* verdict = nullptr;  // null if there is none; lives in the report
};

struct PartRow {
  PartContract part;
  std::string failure;  // why it cannot be checked; empty if it can
  std::vector<FunctionRow> functions;

  int count(Outcome outcome) const;
  bool bonusNotBegun() const;  // nothing of it is written, and nobody asks for it
};

struct Progress {
  std::vector<PartRow> parts;
  std::string next;  // "write 3.1 lambertianBRDF::brdf in ..."; empty if nothing is
  std::optional<CourseworkFunction> nextFunction;
  bool checking = false;
  double fraction = 0.0;  // of the checks, while there are some
  std::string status;     // what is being checked, or what came of it; may be empty

  // Of all parts but bonus parts that are not begun.
  int count(Outcome outcome) const;
  int functions() const;
};

// `report` is null before the first; it must outlive the result.
Progress progressOf(const CourseworkState& coursework, const CheckReport* report);

// The newer report, with the older verdicts of what it does not know yet; `older` may be null.
CheckReport withOlder(CheckReport newer, const CheckReport* older);

// "right", "not written yet".
const char* wordOf(Outcome outcome);

// The line of the compiler's messages that tells the error.
std::string firstError(const std::string& compilerWords);

}  // namespace pathmark::preview
