// A light of each shape at height 2 that looks down, and a receiver that it shines upon.
#pragma once

#include "checks/lit_room.h"
#include "checks/random_rooms.h"

namespace pathmark::checks {

inline const Colour kPlainEmission(3.0f, 2.0f, 0.5f);
inline const Receiver kBelowPlainLight{{0.3f, 0, 0.2f}, {0, 1, 0}, {0.6f, 0.8f, 0}};

RoomLight plainLight(LightShape shape);

}  // namespace pathmark::checks
