// The part of LitScene that the framework gives.
#include <pathmark/lit_scene.h>

#include "render/path_filter.h"
#include "render/ray_count.h"
#include "render/scene_core.h"

namespace pathmark {

namespace {

thread_local std::uint64_t rayCount = 0;
thread_local PathFilter* pathFilter = nullptr;

bool intersectFiltered(const SceneCore& core, const Ray& ray, Hit& hit) {
  if (!pathFilter->follows(ray.origin)) return false;
  ++rayCount;
  if (!core.intersect(ray, hit)) return false;
  pathFilter->meet(hit);
  return true;
}

}  // namespace

std::uint64_t raysOfThisThread() { return rayCount; }
void countRaysOfThisThread(std::uint64_t rays) { rayCount += rays; }
void restartRayCount() { rayCount = 0; }

void filterPathsOfThisThread(PathFilter* filter) { pathFilter = filter; }

bool LitScene::intersect(const Ray& ray, Hit& hit) const {
  if (pathFilter != nullptr) [[unlikely]]
    return intersectFiltered(*core_, ray, hit);
  ++rayCount;
  return core_->intersect(ray, hit);
}

bool LitScene::visible(const Hit& from, const LightSample& to) const {
  if (pathFilter != nullptr && !pathFilter->lightMayCome(from.p)) [[unlikely]]
    return false;
  ++rayCount;
  return core_->visible(from, to);
}

std::span<const Light> LitScene::lights() const { return core_->lights(); }

}  // namespace pathmark
