// Mistakes in drawing from Phong's lobes, simulated, for the diagnosis of directions that do not
// follow their density.
#pragma once

#include "checks/phong_mixture.h"

#include <functional>
#include <string>
#include <vector>

namespace pathmark::checks {

struct PhongMistake {
  std::string text;
  std::function<glm::dvec3(const DirectionDraw&)> draw;
};

// The lobe is chosen as the contract says.
std::vector<PhongMistake> phongMistakes(const MixtureCase& c);

// A sentence about a number of s, t and u that changes nothing, so that another must do its work;
// empty if there is none.
std::string numberUsedTwice(CheckRun& run, const MixtureCase& c);

}  // namespace pathmark::checks
