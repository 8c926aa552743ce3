// CameraHits: what the camera rays of a pixel meet, found together before their paths ask for it.
//
//   trace                    of the rays of a pixel, in the order in which paths will ask
//   isNext, take             the answer, if it is the next of these rays that a path asks for
//   cameraHitsOfThisThread   what LitScene::intersect looks at
//
// Rays through one pixel go nearly the same way through a hierarchy, which serves them as packets
// in a third of the time. But the coursework's tracePath follows one path after the other; so its
// camera rays are foreseen. A path that asks for another ray is answered as ever.
#pragma once

#include "render/scene_core.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pathmark {

class CameraHits {
 public:
  // Of a scene whose packets hold more than one ray.
  explicit CameraHits(const SceneCore& core) : core_(core) {}

  void trace(std::span<const Ray> rays);

  bool isNext(const Ray& ray) const {
    return next_ < answers_.size() && ray.direction == answers_[next_].ray.direction &&
           ray.origin == answers_[next_].ray.origin;
  }

  // Of the next ray; returns whether it meets anything, and only then sets `hit`.
  bool take(Hit& hit) {
    const Answer& answer = answers_[next_++];
    if (answer.met) hit = answer.hit;
    return answer.met;
  }

 private:
  struct Answer {
    Ray ray;
    Hit hit;
    bool met;
  };

  const SceneCore& core_;
  std::vector<Answer> answers_;
  std::size_t next_ = 0;
};

// Of the calling thread from now on; null: none.
void cameraHitsOfThisThread(CameraHits* hits);

}  // namespace pathmark
