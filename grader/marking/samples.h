// drawSamples: what the sampling functions of a part return, for plots.
#pragma once

#include "host/worker_process.h"
#include "record/record.h"

#include <span>
#include <vector>

namespace pathmark::marking {

// The same inputs go to both workers. Functions that are `left out` are not called. Throws
// WorkerError, which then is the coursework's: the solutions do not fail.
std::vector<record::SampleRecord> drawSamples(WorkerProcess& worker, WorkerProcess& solutions,
                                              int part,
                                              std::span<const CourseworkFunction> leftOut);

}  // namespace pathmark::marking
