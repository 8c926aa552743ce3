// Lab: the hemispherical form, uniform directions. Handout: handouts/labs.md, section 2
#include <pathmark/coursework.h>

namespace pathmark {

// The lab `hemispherical`, with directions that are uniform over the hemisphere, as the lab
// `uniform` draws them.
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
