// Do directions follow the density that they are returned with? Importance-weighted, against the
// mixture that the contract names.
//
//   MixtureCase     a material, and directions
//   drawPhong       calls reflection
//   judgeMixture    judges its directions
#pragma once

#include "checks/direction_checks.h"
#include "checks/phong_oracle.h"

#include <string>
#include <vector>

namespace pathmark::checks {

struct MixtureCase {
  PhongMaterial material;
  Vector n, wo;

  std::string text() const;
};

std::vector<DrawnDirection> drawPhong(CheckRun& run, const MixtureCase& c,
                                      const std::vector<DirectionDraw>& points);

// Which density the directions are asked to follow.
enum class Follow {
  kReturned,  // the one that each of them was returned with
  kContract,  // the contract's mixture, whatever was returned
};

struct MixtureFinding {
  Finding finding;
  double variance = 0.0;  // of the weights contract/returned
};

// Each sample counts with contract/returned, so that any choice of the lobe passes, and any other
// valid density. Functions bounded by 1 of the directions above the surface: cosines and
// components around the normal and around the mirror direction, harmonics of the azimuth, 20
// cells. Below the surface, where nothing is reflected, a direction may have its density or 0.
//
// Where float cannot hold cos^m(alpha) to the usual tolerance, directions that fail it and pass
// that of lobeTolerance are right, with a remark.
MixtureFinding judgeMixture(CheckRun& run, const MixtureCase& c, Follow follow = Follow::kReturned);

}  // namespace pathmark::checks
