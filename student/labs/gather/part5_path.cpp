// Lab: gather rays instead of one path. Handout: handouts/labs.md, section 1
#include <pathmark/coursework.h>

namespace pathmark {

// As your tracePath of part 5, but several rays leave every hit: its indirect light is the mean of
// what kGatherRays directions bring, each divided by its density, and so on at every hit of theirs.
// A function that calls itself is the shortest way. Begin with kGatherRays = 2: the tree of a
// camera ray has kGatherRays^(B - 1) ends, B = maxBounces(). Leave the roulette out.
//
//   ray       from the camera; unit direction
//   sampler   for all random numbers
//
// Returns a radiance.
Colour LitScene::tracePath(const Ray& /*ray*/, Sampler& /*sampler*/) const {
  PATHMARK_UNIMPLEMENTED("part5_path.cpp", "LitScene::tracePath");
  return Colour(0.0f);
}

}  // namespace pathmark
