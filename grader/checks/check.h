// The words of checking: what is asked of a function, and what was found.
//
//   Check       one statement about one function, and how it is tested
//   Finding     what the test found
//   CheckRun    what a test may use: the worker, a seed, the budget of false fails
//
// The checks of a part are in part*_checks.cpp, each beginning with the statement that it tests.
#pragma once

#include "host/worker_process.h"
#include "stats/error_budget.h"
#include "worker/contract.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::checks {

enum class Status {
  kPass,
  kFail,
  kUndecided,   // neither right nor wrong could be shown within the budget of samples
  kBroken,      // crashed, never ended, printed without end: the sentence is in `got`
  kNotWritten,  // the stub's marker is still there
  kBlocked,     // by another function or part, named in `cause`
};

struct Finding {
  Status status = Status::kPass;
  std::string where;                 // the inputs: "n = (0, 0, -1), s = 0.5, t = 0"
  std::string expected;              // "pdf = 0.318310"
  std::string got;                   // "pdf = 1.000000"
  std::string tolerance;             // "0.0001 of the value", "6.9 standard errors of 0.0012"
  std::string cause;                 // likely cause, in words; empty if nothing matches clearly
  std::string evidence;              // for the cause, where it is a known mistake
  std::string remark;                // of a pass: correct, but noisier than it could be
  std::optional<WorkerFault> fault;  // of what is broken: how the worker ended

  // Of a statistical check that passed: the smallest relative error that it would have found.
  double shown = 0.0;
  // Of a statistical check that failed: how far off it was, in the smallest errors that it finds.
  double distance = 0.0;
  std::uint64_t calls = 0;

  bool passed() const { return status == Status::kPass; }
};

struct CheckRun {
  WorkerProcess& worker;
  std::uint64_t seed = 0;  // of this check alone
  stats::ErrorBudget& budget;
  CourseworkFunction function = CourseworkFunction::kTracePath;  // that is checked
};

struct Check {
  std::string_view name;  // "samples"; with the function's section "3.3/samples"
  CourseworkFunction function;
  std::string_view statement;

  // The smallest error that is found with probability 0.999, relative to the value; 0: pointwise.
  double delta = 0.0;

  Finding (*run)(CheckRun&);

  // Functions that the test relies on, which must be right first.
  std::vector<CourseworkFunction> needs{};

  // A test of the whole coursework, of its pictures, and not of the function alone.
  bool whole = false;
};

// "3.3/samples", or "images/samples" for one of the whole coursework.
std::string idOf(const Check& check);

}  // namespace pathmark::checks
