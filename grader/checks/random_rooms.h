// Rooms at random, in which the mean radiance is known and no sample counts for much more than
// others.
//
//   LightShape, makeLight    a light of a given shape, anywhere
//   place                    puts a receiver in front of the room's first light
//   lightAround              one of several lights around a receiver
#pragma once

#include "checks/lit_room.h"
#include "checks/points.h"

namespace pathmark::checks {

enum class LightShape { kTriangle, kParallelogram, kPolygon, kSphere };

Colour randomEmission(Random& random);

// Of this size, its centre within some sizes of the origin.
RoomLight makeLight(Random& random, LightShape shape, double size);

enum class Placement {
  kWhollyLit,  // the light is wholly above the horizon
  kCut,        // the horizon cuts it
};

// Before a polygon, or outside of a sphere of which it sees the sine `sine`.
Receiver place(Random& random, const RoomLight& light, Placement placement, double sine = 0.0);

// In sector k of n, 25 to 55 degrees above the horizon of the receiver, and turned towards it; of
// such emission that the receiver reflects about as much from each.
RoomLight lightAround(Random& random, const Receiver& receiver, LightShape shape, int k, int n);

}  // namespace pathmark::checks
