// Stands in for part 5 where another part is checked. Where renderPixel is, it hands the rays over
// to the recorder; else it gives the direct light alone of what the ray meets, as a surface of the
// scene that may emit.
#include "worker/pixel_recorder.h"

#include <pathmark/coursework.h>

namespace pathmark {

Colour LitScene::tracePath(const Ray& ray, Sampler& sampler) const {
  auto* recorder = dynamic_cast<PixelRecorder*>(&sampler);
  if (recorder != nullptr) return recorder->trace(ray);
  Hit hit;
  return intersect(ray, hit) ? directLighting(hit, -ray.direction, sampler) : Colour(0.0f);
}

}  // namespace pathmark
