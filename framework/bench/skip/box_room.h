// Rooms of boxes, for the question from how many triangles on a hierarchy pays in whole renders.
#pragma once

#include "scene/load_scene.h"

namespace pathmark::bench {

// Each side of a box is a pair of triangles, as are the room's walls and its lamp.
LoadedScene boxRoom(int boxes, int side);  // of the picture, in pixels

constexpr int pairsInBoxRoom(int boxes) { return 6 + 1 + 6 * boxes; }

}  // namespace pathmark::bench
