// drawSamples: asks a worker for samples.
#pragma once

#include "host/worker_process.h"
#include "preview/samples/sample_set.h"

namespace pathmark::preview {

// Throws WorkerError.
SampleSet drawSamples(WorkerProcess& worker, const SampleSettings& settings);

}  // namespace pathmark::preview
