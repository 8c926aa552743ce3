// Which functions of a coursework are written, by the markers that its worker carries.
#pragma once

#include "render/render_job.h"
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

// Whether pictures that are made in this way come from the function: part 0 stands alone, and the
// other parts do without it and without the bonus parts, unless these are asked for. Of a function
// that the coursework may call or not, true.
bool isUsed(const FunctionContract& f, Estimator estimator, LightSampling lights);

// Records that name no function of the contract are left out.
StubReport makeStubReport(std::span<const StubRecord> records);

}  // namespace pathmark
