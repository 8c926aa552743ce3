// What came of checking a coursework: checks, functions, parts.
#pragma once

#include "checks/check.h"
#include "checks/scene_checks.h"
#include "diagnosis/diagnosis.h"

#include <optional>
#include <string>
#include <vector>

namespace pathmark::checks {

struct CheckResult {
  const Check* check = nullptr;
  Finding finding;
  double seconds = 0.0;
};

struct FunctionResult {
  FunctionContract function;
  Status status = Status::kPass;  // the worst of its checks
  std::vector<CheckResult> checks;
  diagnosis::Diagnosis diagnosis{};  // of what is wrong
};

struct PartResult {
  PartContract part;
  std::string failure;  // why the part could not be checked: it does not compile or link
  std::optional<WorkerFault> fault;  // or its worker cannot be started, which ended like this
  std::vector<FunctionResult> functions;
};

// A bonus part of which nothing is written: it is not asked for, and is not missed.
bool isBonusNotBegun(const PartResult& part);

struct CourseworkResults {
  std::uint64_t seed = 0;
  std::vector<PartResult> parts;     // those that were asked for
  std::vector<CheckResult> images;   // of the whole coursework
  std::vector<SceneFinding> scenes;  // of part 7
  double seconds = 0.0;
  std::int64_t statistics = 0;  // that were judged; each of them could fail by chance

  const FunctionResult* find(CourseworkFunction function) const;
  bool anythingWrong() const;  // failed or broken; what is not written is not wrong
};

// How bad a status is, for the worst of several.
int severity(Status status);

}  // namespace pathmark::checks
