// The part of LitScene that the framework gives.
#include <pathmark/lit_scene.h>

#include "render/ray_count.h"
#include "render/scene_core.h"

namespace pathmark {

thread_local constinit std::uint64_t raysOfThisThread = 0;

bool LitScene::intersect(const Ray& ray, Hit& hit) const {
  ++raysOfThisThread;
  return core_->intersect(ray, hit);
}

bool LitScene::visible(const Hit& from, const LightSample& to) const {
  ++raysOfThisThread;
  return core_->visible(from, to);
}

std::span<const Light> LitScene::lights() const { return core_->lights(); }

}  // namespace pathmark
