// Part 1 in two groups, in the order of the handout, and the cameras of both.
#pragma once

#include "checks/check.h"

#include <pathmark/camera.h>

#include <string>
#include <vector>

namespace pathmark::checks {

std::vector<Check> part1RayChecks();    // 1.1
std::vector<Check> part1PixelChecks();  // 1.2

// A plain one first; then one whose film is neither centred nor square to the view, with pixels
// that are not square; and one far away with a long way to its film.
std::vector<SimpleCamera> filmCameras();

std::string text(const SimpleCamera& camera);

}  // namespace pathmark::checks
