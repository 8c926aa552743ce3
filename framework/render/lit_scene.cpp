// The part of LitScene that the framework gives.
#include <pathmark/lit_scene.h>

#include "render/ray_count.h"
#include "render/scene_core.h"

namespace pathmark {

namespace {

thread_local std::uint64_t rayCount = 0;

}  // namespace

std::uint64_t raysOfThisThread() { return rayCount; }
void countRaysOfThisThread(std::uint64_t rays) { rayCount += rays; }
void restartRayCount() { rayCount = 0; }

bool LitScene::intersect(const Ray& ray, Hit& hit) const {
  ++rayCount;
  return core_->intersect(ray, hit);
}

bool LitScene::visible(const Hit& from, const LightSample& to) const {
  ++rayCount;
  return core_->visible(from, to);
}

std::span<const Light> LitScene::lights() const { return core_->lights(); }

}  // namespace pathmark
