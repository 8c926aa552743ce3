// Mean direct light in many rooms, and what it must be.
#pragma once

#include "checks/check.h"
#include "checks/lit_room.h"

#include <string>
#include <vector>

namespace pathmark::checks {

struct DirectCase {
  LitRoom room;
  glm::dvec3 expected;

  // Whether the known mistakes can be computed: by quadrature over lights wholly above the horizon.
  bool comparable = true;

  std::uint32_t rays = 128;  // of a replicate
};

// Expected by quadrature.
DirectCase caseOf(const LitRoom& room, std::uint32_t rays = 128);

// The first case that is wrong, with the mistake that explains what is seen in all of them.
Finding judgeCases(CheckRun& run, const std::vector<DirectCase>& cases);

// No light at all in any sample. `cause`: what to look at if there is.
struct DarkCase {
  LitRoom room;
  std::string why, cause;
};

Finding judgeDarkness(CheckRun& run, const std::vector<DarkCase>& cases);

// Light in some samples, however the lights are chosen.
struct LitCase {
  LitRoom room;
  std::string why, cause;
};

Finding judgeSomeLight(CheckRun& run, const std::vector<LitCase>& cases);

}  // namespace pathmark::checks
