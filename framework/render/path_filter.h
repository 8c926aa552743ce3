// PathFilter: follows the paths of a thread, and lets only light through that came along paths of
// an expression.
//
// Coursework traces paths as it likes. What it is given is filtered: whether there is a surface at
// the end of a ray (LitScene::intersect), what that surface emits and by which lobe it reflects
// (Hit), and whether a light is in view (LitScene::visible). A ray goes on from the surface that it
// starts at, so that the order of calls does not matter, and rays that branch are kept apart.
//
// At a surface with two lobes of different consequences one of them is chosen by chance, and the
// hit gets a BRDF that is this lobe over its probability: the mean over the choice is the sum over
// both. The numbers for it are the filter's own, and depend on the seed, the pixel and the pass
// only.
#pragma once

#include "render/path_automaton.h"
#include "render/scene_core.h"

#include <cstdint>
#include <vector>

namespace pathmark {

class PathFilter {
 public:
  // All must outlive the filter.
  PathFilter(const SceneCore& scene, const PathAutomaton& automaton, const Point& eye,
             std::uint64_t seed);

  // The next paths belong to pixel (i, j), of which earlier passes have made `raysBefore`.
  void startPixel(int i, int j, std::uint64_t raysBefore);

  // Whether light can still come along a ray from here; a ray from the eye begins a new path.
  bool follows(const Point& origin);

  // The surface at the end of the ray that was followed last.
  void meet(Hit& hit);

  // Whether light that comes straight to this point of a surface is let through.
  bool lightMayCome(const Point& surface) const;

 private:
  struct Vertex {
    Point p;
    PathAutomaton::State state;  // after its scattering event
  };

  const Vertex* nearestVertex(const Point& p) const;
  PathAutomaton::State scatter(const BRDF*& brdf);
  float number();

  const SceneCore& scene_;
  const PathAutomaton& automaton_;
  Point eye_;
  std::uint64_t seedKey_;
  std::uint64_t random_ = 0;
  PathAutomaton::State before_ = PathAutomaton::kDead;  // of the ray that was followed last
  std::vector<Vertex> path_;                            // all surfaces since the eye
};

// What LitScene asks in the calling thread from now on; null: nothing is filtered. The coursework
// is handed a scene that all threads share, so that only the thread can tell whose path it is.
void filterPathsOfThisThread(PathFilter* filter);

}  // namespace pathmark
