// Lab: the hemispherical form of the rendering equation. Handout: handouts/labs.md, section 2
#include <pathmark/coursework.h>

namespace pathmark {

// Your tracePath of part 5 for the hemispherical form: light is found only where a path meets it.
// Every hit adds throughput * hit.emitted(wo), the first as well as the later ones; there is no
// directLighting. With B = maxBounces() and the hits counted from 1, hits 1 ... B go on, so that
// hit B + 1 can still be a light.
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
