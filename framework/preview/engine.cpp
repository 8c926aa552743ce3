#include "preview/engine.h"

#include "host/coursework_stamp.h"
#include "host/session.h"
#include "preview/renderer.h"
#include "preview/scene_watch.h"

#include <fmt/format.h>

#include <chrono>

namespace pathmark::preview {

namespace fs = std::filesystem;

namespace {

// How often files are looked at: far below what somebody notices, and nothing to the processor.
constexpr auto kWatchPeriod = std::chrono::milliseconds(60);

}  // namespace

Engine::Engine(EngineRequest request, std::function<void()> wake)
    : wake_(std::move(wake)), request_(std::move(request)) {
  auto state = std::make_shared<EngineState>();
  state->coursework = std::make_shared<CourseworkState>();
  state_ = std::move(state);
  watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  renderer_ = std::jthread([this](const std::stop_token& stop) { Renderer(*this).run(stop); });
}

Engine::~Engine() {
  renderer_.request_stop();
  watcher_.request_stop();
  changed_.notify_all();
}

void Engine::request(const EngineRequest& request) {
  {
    const std::lock_guard lock(mutex_);
    request_ = request;
    ++requests_;
  }
  changed_.notify_all();
}

EngineRequest Engine::wanted() const {
  const std::lock_guard lock(mutex_);
  return request_;
}

std::shared_ptr<const EngineState> Engine::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void Engine::change(const std::function<void(EngineState&)>& how) {
  {
    const std::lock_guard lock(mutex_);
    auto next = std::make_shared<EngineState>(*state_);
    how(*next);
    state_ = std::move(next);
  }
  wake_();
}

void Engine::watch(const std::stop_token& stop) {
  std::string coursework, scene;
  SceneWatch scenes;
  std::mutex sleeping;
  while (!stop.stop_requested()) {
    const EngineRequest wanted = this->wanted();
    const fs::path folder = courseworkFolder(wanted.with);
    if (const std::string now = wanted.with + stampOf(folder); now != coursework) {
      coursework = now;
      build(folder);
    }
    if (const std::string now = scenes.stampOf(wanted.scene); now != scene) {
      scene = now;
      const std::lock_guard lock(mutex_);
      ++sceneStamp_;
      ++requests_;
    }
    changed_.notify_all();
    std::unique_lock lock(sleeping);
    std::condition_variable_any().wait_for(lock, stop, kWatchPeriod, [] { return false; });
  }
}

void Engine::build(const fs::path& folder) {
  change([](EngineState& s) { s.building = true; });
  auto made = std::make_shared<CourseworkState>();
  std::string failure;
  try {
    made->build = std::make_shared<CourseworkBuild>(buildCoursework(folder));
    if (made->build->worker.empty()) failure = made->build->failure();
  } catch (const std::exception& e) {
    failure = fmt::format("The coursework could not be compiled: {}.", e.what());
  }
  change([&](EngineState& s) {
    made->number = s.coursework->number + 1;
    made->stubs = s.coursework->stubs;
    if (made->build == nullptr) made->build = s.coursework->build;
    s.coursework = made;
    s.buildFailure = failure;
    s.building = false;
  });
  const std::lock_guard lock(mutex_);
  ++requests_;
}

}  // namespace pathmark::preview
