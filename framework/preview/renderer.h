// The engine's thread that has the worker.
#pragma once

#include "preview/engine.h"
#include "preview/series.h"

#include <memory>
#include <stop_token>
#include <string>

namespace pathmark::preview {

class Engine::Renderer {
 public:
  explicit Renderer(Engine& engine) : engine_(engine) {}

  void run(const std::stop_token& stop);

 private:
  // What a picture depends on; another one begins when any of it changes.
  struct Subject {
    std::uint64_t sceneStamp = 0;
    std::filesystem::path worker;  // empty: there is none
    EngineRequest request;
  };

  Subject subject();
  bool outdated() const;
  void waitForChange();
  bool prepare();
  bool setActivity(Activity activity);
  void begin();
  bool loadScene();
  void startWorker();
  void fail(const std::string& sentence);
  void work();
  bool glance(std::uint32_t rays);
  RenderSettings settings() const;
  void publish(Series::Made made);

  Engine& engine_;
  std::stop_token stop_;
  std::uint64_t seen_ = 0;  // of Engine::requests_
  Subject subject_;         // in work
  std::shared_ptr<const PreviewScene> scene_;
  std::uint64_t sceneNumber_ = 0;
  std::unique_ptr<WorkerProcess> worker_;  // before series_, which uses it
  std::filesystem::path workerProgram_;
  std::uint64_t workerScene_ = 0;  // the number of the scene that it has
  std::unique_ptr<Series> series_;
  std::uint64_t seriesNumber_ = 0, version_ = 0;
  bool failed_ = false;         // nothing more to do until something changes
  bool glanced_ = false;        // there is a quick picture
  double glanceSeconds_ = 0.0;  // that a ray for each pixel took last
  double raysMade_ = 0.0;       // of each pixel, in the series
};

}  // namespace pathmark::preview
