// Scenes of a chosen number of primitives, for measuring intersection.
//
//   boxRoom      triangles: a room with turned boxes in it
//   sphereRoom   spheres: a hollow one with others in it
//   blobOnFloor  many triangles: the mesh of the shipped scene "blob", coarser or as it is
//   cornellBox   the shipped scene's 32 triangles
//   asSeen       a scene as it is rendered, with its camera
#pragma once

#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <optional>

namespace pathmark::bench {

// Shadow rays go to points of this parallelogram, which is no part of the scene.
struct Lamp {
  Point corner{0.0f};
  Vector side{0.0f}, otherSide{0.0f};
};

struct RayScene {
  FlatScene flat;
  Lamp lamp;
  float offset = 0.0f;  // of a ray's origin from the surface that it leaves
  // Paths begin at what it sees; without one at points of all surfaces, by area.
  std::optional<FlatCamera> camera{};
};

// Twelve triangles of the room, then twelve of each box, the last of which may be open; fewer than
// twelve are a part of the room.
RayScene boxRoom(std::size_t triangles);

RayScene sphereRoom(std::size_t spheres);

// 8 n^2 triangles of the blob and 4 around it.
RayScene blobOnFloor(int subdivisions);

RayScene cornellBox();

// Of triangles. Without a lamp: for rays that look for their nearest hit.
RayScene asSeen(FlatScene flat);

}  // namespace pathmark::bench
