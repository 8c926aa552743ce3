// Asking reflection() for many directions, and what comes of it as features.
#pragma once

#include "checks/calls.h"
#include "diagnosis/direction_moments.h"
#include "diagnosis/probes.h"

#include <functional>
#include <string>

namespace pathmark::diagnosis {

struct DirectionCase {
  CourseworkFunction pdf;  // the density that belongs to reflection()
  checks::Words object;
  Vector wo, n;
  Vector axis;  // around which the moments are taken
  std::string where;
  std::function<double(const Vector& wi)> named;  // density, by the contract

  // Samples count with the contract's density over their own: for what leaves the density open.
  bool weighted = false;
};

void probeDirections(const ProbeRun& run, const DirectionCase& c, Signature& signature);

}  // namespace pathmark::diagnosis
