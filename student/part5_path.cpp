// Part 5: the path tracer. Handout: handouts/part5_path.md
#include <pathmark/coursework.h>

namespace pathmark {

// Part 5.1 (handout section 5.1): put it all together. The light that comes back along a camera
// ray, estimated with one path.
//
// Follow the ray with intersect(ray, hit); where it leaves the scene the world is black. With
// B = maxBounces() and the hits counted from 1 along the path:
//   - hit 1 adds what it emits towards the camera, hit.emitted(wo); later hits do not, because
//     direct lighting has counted that light already;
//   - hits 1 ... B add throughput * directLighting(hit, wo, sampler);
//   - hits 1 ... B-1 go on: wi and its density from hit.brdf->reflection(wo, hit.n, s, t, u), the
//     throughput is multiplied by f(wo, wi) cos(theta) / pdf, and the next ray is
//     hit.spawnRay(wi). The density 0 means that there is no direction: the path ends.
//   - After each update of the throughput, RussianRoulette(throughput, depth, u) with depth = the
//     number of scattering events so far (1 at hit 1) says whether the path goes on, and with what
//     factor on the throughput. Until part 6 is written it always goes on, with factor 1.
//
//   ray       from the camera; unit direction
//   sampler   for all random numbers
//
// Here wo = -ray.direction. Returns a radiance.
Colour LitScene::tracePath(const Ray& /*ray*/, Sampler& /*sampler*/) const {
  PATHMARK_UNIMPLEMENTED("part5_path.cpp", "LitScene::tracePath");
  return Colour(0.0f);
}

}  // namespace pathmark
