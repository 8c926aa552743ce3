// Probes: how a function is asked for its signature, with inputs that are fixed and public.
//
//   ProbeSeed          of the random numbers that the function gets; the rest is always the same
//   probe              the signature of a function
//   probePart0 ...     the same, by part
#pragma once

#include "diagnosis/signature.h"
#include "host/worker_process.h"
#include "worker/contract.h"

#include <cstdint>

namespace pathmark::diagnosis {

// That of the catalogue, and another one: what a diagnosis says must not depend on it.
enum class ProbeSeed : std::uint64_t { kCatalogue = 0xca7a1095, kDisguise = 0xd1561153 };

// In a worker in which the function's part alone is coursework. Throws WorkerError.
Signature probe(WorkerProcess& worker, CourseworkFunction function, ProbeSeed seed);

struct ProbeRun {
  WorkerProcess& worker;
  CourseworkFunction function;
  std::uint64_t seed;  // of s, t, u and of samplers
};

Signature probePart0(const ProbeRun& run);
Signature probePart1(const ProbeRun& run);
Signature probePart2(const ProbeRun& run);
Signature probePart3(const ProbeRun& run);
Signature probePart4(const ProbeRun& run);
Signature probePart5(const ProbeRun& run);
Signature probePart6(const ProbeRun& run);
Signature probePart8(const ProbeRun& run);
Signature probePart9(const ProbeRun& run);

}  // namespace pathmark::diagnosis
