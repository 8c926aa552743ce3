// Where mistakes may show: the shipped scenes, small, as they are.
#pragma once

#include "marking/marking_scenes.h"

#include <span>
#include <string_view>
#include <vector>

namespace pathmark::gallery {

// Pixels along the longer side of each picture.
inline constexpr int kPixels = 96;

// Those in which a mistake of the part can be expected to show, the most usual one first. Those of
// part 0 are pictures of the warm-up.
std::vector<marking::MarkingScene> scenesOf(int part);

}  // namespace pathmark::gallery
