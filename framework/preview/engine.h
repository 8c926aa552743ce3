// Engine: renders on threads of its own what the window asks for, and again after each save.
//
//   EngineRequest   what is wanted
//   EngineState     what there is
//
// One thread watches the coursework and the scene and compiles; another has the worker. What was
// there last stays until there is something better: a file that does not compile, a crash or an
// endless loop become a sentence, and the next save starts anew.
#pragma once

#include "light_paths/expression.h"
#include "preview/part_picture.h"
#include "preview/picture.h"

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace pathmark::preview {

struct EngineRequest {
  std::string with = "student";  // coursework, as on the command line
  std::filesystem::path scene;
  PartPicture made{};
  SamplerKind sampler = SamplerKind::kSobol;
  std::optional<PathExpression> paths{};  // nothing: all light; the warm-up knows no other
  std::uint64_t seed = 0;
  std::uint32_t threads = 1;
  double mostRays = std::numeric_limits<double>::infinity();  // of each pixel
  double secondsWithoutAnswer = 10.0;

  std::optional<FlatCamera> camera{};  // instead of the file's ...
  std::uint64_t cameraOf = 0;          // ... of this scene: EngineState::sceneNumber
  bool moving = false;                 // quick pictures, of one ray for each pixel or fewer
  bool paused = false;
  std::uint64_t restarts = 0;  // to begin anew, count up
};

enum class Activity { kWaiting, kStarting, kRendering, kPaused, kFinished };

struct EngineState {
  std::shared_ptr<const PreviewScene> scene;  // null before the first
  std::uint64_t sceneNumber = 0;
  std::shared_ptr<const CourseworkState> coursework;  // never null
  std::shared_ptr<const Picture> picture;             // null before the first
  Activity activity = Activity::kStarting;
  bool building = false;

  // Sentences; empty where nothing is wrong. The picture is then an older one.
  std::string buildFailure;   // with the compiler's words
  std::string workerFailure;  // a crash, an endless loop
  std::string sceneFailure;
  std::string printed;  // the end of what the coursework has printed
};

class Engine {
 public:
  // `wake` is called from other threads when the state has changed.
  Engine(EngineRequest request, std::function<void()> wake);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void request(const EngineRequest& request);
  std::shared_ptr<const EngineState> state() const;

 private:
  class Renderer;
  friend class Renderer;

  // Changes the state, and wakes.
  void change(const std::function<void(EngineState&)>& how);
  EngineRequest wanted() const;
  void watch(const std::stop_token& stop);
  void build(const std::filesystem::path& folder);

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  EngineRequest request_;
  std::uint64_t requests_ = 0;    // counts changes that the renderer must look at
  std::uint64_t sceneStamp_ = 0;  // counts changes of the scene's files
  std::shared_ptr<const EngineState> state_;
  std::jthread watcher_, renderer_;  // last: they use what is above
};

}  // namespace pathmark::preview
