// PathRecorder: writes down what happens on the paths that a thread traces.
//
// Linked only into workers that record (linkForRecording): there the calls between the framework
// and the coursework come by here on their way (recorded_calls.cpp), and surfaces have BRDFs that
// tell what they are asked.
#pragma once

#include "render/scene_core.h"
#include "worker/path_events.h"

#include <pathmark/warmup.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pathmark {

PathEvent pathEvent(PathEventKind kind, const vec3& a, const vec3& b = vec3(0.0f),
                    const vec3& c = vec3(0.0f));

class PathRecorder {
 public:
  // `filtered`: a light path expression leaves out some of the light.
  PathRecorder(const SceneCore& core, bool filtered);
  ~PathRecorder();
  PathRecorder(const PathRecorder&) = delete;
  PathRecorder& operator=(const PathRecorder&) = delete;

  // Where the calling thread's paths are recorded; null if they are not. The functions that are
  // called know nothing of a recorder, so that only the thread can tell.
  static PathRecorder* ofThisThread();
  void useForThisThread();

  // A path within a path, of a coursework that calls tracePath for each bounce, is part of it.
  void beginPath(const Ray& ray);
  void endPath(const Colour& radiance);

  void add(const PathEvent& event);

  // Notes the hit, and gives it a BRDF that records.
  void meet(const Ray& ray, Hit& hit);
  // Notes that there is no hit, or that it was left out.
  void miss(const Ray& ray);
  // Notes what has been found out, and looks for what is in the way.
  void shadowRay(const Hit& from, const LightSample& to, bool visible);
  // Part 0 calls its own functions, which cannot be seen, but for the rays that leave surfaces:
  // what happens there is what its task says.
  void leave(const Point& p, const Triangle& triangle, const Ray& next);
  // Where the last ray of such a path leads to, if it is still followed.
  void meetLast(const Ray& cameraRay);

  std::uint64_t paths() const { return paths_; }
  std::vector<PathEvent> takeEvents() { return std::move(events_); }

 private:
  class Material;

  void addMaterial(const BRDF& real, std::size_t index);

  const SceneCore& core_;
  bool filtered_;
  std::vector<std::unique_ptr<Material>> materials_;
  std::vector<Triangle> warmUp_;  // when it is first needed
  std::optional<Ray> lastRay_;    // that left a surface in part 0
  int left_ = 0;                  // how many have, of the path in work
  std::vector<PathEvent> events_;
  std::size_t first_ = 0;  // event of the path in work
  int depth_ = 0;          // of paths within paths
  bool recording_ = false;
  std::int32_t dropped_ = 0;
  std::uint64_t paths_ = 0;  // that have begun
};

}  // namespace pathmark
