// The part of LitScene that the framework gives.
#include <pathmark/lit_scene.h>

#include "render/camera_hits.h"
#include "render/first_surface.h"
#include "render/path_filter.h"
#include "render/ray_count.h"
#include "render/scene_core.h"

#include <utility>

namespace pathmark {

namespace {

thread_local std::uint64_t rayCount = 0;
thread_local PathFilter* pathFilter = nullptr;
thread_local CameraHits* cameraHits = nullptr;

// Of a path that shares its camera ray.
struct FirstSurface {
  Hit hit;
  bool waits = false;  // for the path to ask for it
  bool dark = false;   // the path shall not see what lights it
  bool left = false;   // by a ray that has been followed

  bool lightIsHidden(const Hit& from) const { return dark && from.p == hit.p; }
};
thread_local FirstSurface first;

// One look for all rays of a normal render.
thread_local bool isPlain = true;

void lookAgain() {
  isPlain = pathFilter == nullptr && cameraHits == nullptr && !first.waits && !first.dark;
}

bool intersectFiltered(const SceneCore& core, const Ray& ray, Hit& hit) {
  if (!pathFilter->follows(ray.origin)) return false;
  ++rayCount;
  if (!core.intersect(ray, hit)) return false;
  pathFilter->meet(hit);
  return true;
}

bool intersectAnywhere(const SceneCore& core, const Ray& ray, Hit& hit) {
  if (pathFilter != nullptr) return intersectFiltered(core, ray, hit);
  ++rayCount;
  if (cameraHits != nullptr && cameraHits->isNext(ray)) return cameraHits->take(hit);
  return core.intersect(ray, hit);
}

void hideEmission(Hit& hit) {
  hit.emission = Colour(0.0f);
  hit.light = nullptr;
}

bool intersectSpecially(const SceneCore& core, const Ray& ray, Hit& hit) {
  if (std::exchange(first.waits, false)) {
    lookAgain();
    hit = first.hit;
    return true;
  }
  const bool leavesDark = first.dark && !std::exchange(first.left, true);
  if (!intersectAnywhere(core, ray, hit)) return false;
  if (leavesDark) hideEmission(hit);
  return true;
}

}  // namespace

std::uint64_t raysOfThisThread() { return rayCount; }
void countRaysOfThisThread(std::uint64_t rays) { rayCount += rays; }
void restartRayCount() { rayCount = 0; }

void filterPathsOfThisThread(PathFilter* filter) {
  pathFilter = filter;
  lookAgain();
}

void cameraHitsOfThisThread(CameraHits* hits) {
  cameraHits = hits;
  lookAgain();
}

void beginWithSurface(const Hit& surface, bool dark) {
  first = {surface, true, dark, false};
  if (dark) hideEmission(first.hit);
  isPlain = false;
}

void beginAnywhere() {
  first.waits = first.dark = false;
  lookAgain();
}

bool LitScene::intersect(const Ray& ray, Hit& hit) const {
  if (!isPlain) [[unlikely]]
    return intersectSpecially(*core_, ray, hit);
  ++rayCount;
  return core_->intersect(ray, hit);
}

bool LitScene::visible(const Hit& from, const LightSample& to) const {
  if (!isPlain) [[unlikely]] {
    if (first.lightIsHidden(from)) return false;
    if (pathFilter != nullptr && !pathFilter->lightMayCome(from.p)) return false;
  }
  ++rayCount;
  return core_->visible(from, to);
}

std::span<const Light> LitScene::lights() const {
  if (first.dark && !first.left) [[unlikely]]
    return {};
  return core_->lights();
}

}  // namespace pathmark
