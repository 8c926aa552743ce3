// Lab: directions in proportion to the cosine, whatever the BRDF. Handout: handouts/labs.md,
// section 3
#include <pathmark/coursework.h>

namespace pathmark {

// A direction whose density is in proportion to the cosine of its angle to n (handout section 3):
// you have written one in part 3.
//
//   n         unit normal
//   sampler   for all random numbers, as many as it takes
//
// Returns a unit vector on the side of n, and its density, cos(theta)/pi, per unit solid angle.
[[maybe_unused]] static DirectionSample sampleDirection(const Vector& n, Sampler& /*sampler*/) {
  PATHMARK_UNIMPLEMENTED("part5_path.cpp", "sampleDirection");
  return {n, 0.0f};
}

// Your tracePath of part 5, with sampleDirection(hit.n, sampler) in place of the call of
// hit.brdf->reflection. Everything else stays as it is: the throughput is still multiplied by
// f cos(theta) / pdf.
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
