// Part 1: stratified camera rays. Handout: handouts/part1_stratified.md
//
// Until part 5 is written the picture stays black: `./pathmark status` says what is missing.
#include <pathmark/coursework.h>

namespace pathmark {

// Part 1.1 (handout section 1.1): a random ray through one stratum of a pixel.
//
// The pixel in column i and row j is cut into n x n strata. The ray goes from the eye through
//   (x, y) = (i + (k + s)/n, j + (l + t)/n),
// in pixels from the top left corner of the film, x to the right and y downwards. That point is
// seen along the vector topLeft() + x pixelRight() + y pixelDown().
//
//   i, j   column and row of the pixel
//   k, l   column and row of the stratum, 0 <= k, l < n
//   n      strata along each side, n >= 1; n = 1 is the whole pixel
//   s, t   uniform in [0,1): where in the stratum
//
// Returns a ray with its origin at eye() and a unit direction.
Ray SimpleCamera::StratifiedRandomRay(int /*i*/, int /*j*/, int /*k*/, int /*l*/, int /*n*/,
                                      float /*s*/, float /*t*/) const {
  PATHMARK_UNIMPLEMENTED("part1_stratified.cpp", "SimpleCamera::StratifiedRandomRay");
  return {eye(), normalize(topLeft())};
}

// Part 1.2 (handout section 1.2): the colour of a pixel is the mean over its rays.
//
// With N = nRaysPerPixel and n = floor(sqrt(N)): one ray in each of the n x n strata, then the
// remaining N - n^2 rays anywhere in the pixel, by StratifiedRandomRay(i, j, 0, 0, 1, s, t).
// Ask tracePath(ray, sampler) for the radiance along each. Every s and t is random, also where N is
// 1: the mean is that of the whole pixel, and not of its centre.
//
//   i, j            column and row of the pixel
//   nRaysPerPixel   how many rays, exactly
//   sampler         call sampler.startRay(m) before the m-th ray, m = 0 ... N-1, and then take s
//                   and t from it: best from sampler.next2D(), since its two numbers are spread
//                   evenly together, which those of two calls of next1D() are not
//
// Returns the mean radiance of all N rays.
Colour LitScene::renderPixel(int /*i*/, int /*j*/, const SimpleCamera& /*camera*/,
                             int /*nRaysPerPixel*/, Sampler& /*sampler*/) const {
  PATHMARK_UNIMPLEMENTED("part1_stratified.cpp", "LitScene::renderPixel");
  return Colour(0.0f);
}

}  // namespace pathmark
