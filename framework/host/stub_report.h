// Which functions of a coursework are written, by the markers that its worker carries.
#pragma once

#include "worker/contract.h"

#include <pathmark/unimplemented.h>

#include <span>
#include <string>
#include <vector>

namespace pathmark {

struct StubReport {
  std::vector<FunctionContract> unwritten;  // in the order of the handouts

  bool isUnwritten(CourseworkFunction f) const;
};

// Records that name no function of the contract are left out.
StubReport makeStubReport(std::span<const StubRecord> records);

}  // namespace pathmark
