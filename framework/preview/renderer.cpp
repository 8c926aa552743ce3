#include "preview/renderer.h"

#include "host/session.h"
#include "preview/same_camera.h"
#include "scene/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <utility>

namespace pathmark::preview {

namespace {

// Of a picture that somebody waits for, and of one that is only getting better.
constexpr double kFirstStepSeconds = 0.1, kLaterStepSeconds = 0.4;

// While the camera moves, pictures come at least about this often: larger ones than fit are made
// with fewer pixels.
constexpr double kGlanceSeconds = 0.06;
constexpr int kCoarsest = 8;

constexpr std::size_t kMostPrinted = 4000;

bool sameMovedCamera(const std::optional<FlatCamera>& a, const std::optional<FlatCamera>& b) {
  return a && b ? sameCamera(*a, *b) : !a && !b;
}

// A film pixel takes 32 bytes.
void refuseLargePictures(const LoadedScene& scene) {
  const FlatCamera& camera = scene.flat.camera;
  if (std::uint64_t{camera.width} * camera.height > kMostPixels)
    throw SceneError(
        fmt::format("The scene {}: its size of {}x{} has more than {} pixels, which is the most.",
                    scene.name, camera.width, camera.height, kMostPixels));
}

std::string textOf(const std::optional<PathExpression>& paths) {
  return paths ? paths->text() : std::string();
}

bool samePicture(const EngineRequest& a, const EngineRequest& b) {
  return a.made.estimator == b.made.estimator && a.sampler == b.sampler && a.seed == b.seed &&
         textOf(a.paths) == textOf(b.paths) && a.threads == b.threads && a.restarts == b.restarts &&
         sameMovedCamera(a.camera, b.camera);
}

// The same view in fewer pixels, each `by` wide and high.
FlatCamera coarser(FlatCamera camera, std::uint32_t by) {
  for (int c = 0; c < 3; ++c) {
    const auto at = static_cast<std::size_t>(c);
    camera.pixelRight[at] *= static_cast<float>(by);
    camera.pixelDown[at] *= static_cast<float>(by);
  }
  camera.width = (camera.width + by - 1) / by;
  camera.height = (camera.height + by - 1) / by;
  return camera;
}

// Every pixel `by` times in each direction, cut to the size.
Image enlarged(const Image& small, int by, int width, int height) {
  Image image{.width = width, .height = height};
  image.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (const float value : small.pixel(column / by, row / by)) image.rgb.push_back(value);
  if (small.invalid.empty()) return image;
  const auto across = static_cast<std::size_t>(small.width);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      image.invalid.push_back(small.invalid[static_cast<std::size_t>(row / by) * across +
                                            static_cast<std::size_t>(column / by)]);
  return image;
}

}  // namespace

void Engine::Renderer::run(const std::stop_token& stop) {
  stop_ = stop;
  while (!stop.stop_requested()) {
    try {
      if (prepare()) {
        work();
        continue;
      }
    } catch (const WorkerError& e) {
      fail(e.what());
    } catch (const std::exception& e) {
      fail(fmt::format("This machine could not run the coursework: {}.", e.what()));
    }
    waitForChange();
  }
}

Engine::Renderer::Subject Engine::Renderer::subject() {
  const std::lock_guard lock(engine_.mutex_);
  seen_ = engine_.requests_;
  Subject now{.sceneStamp = engine_.sceneStamp_, .worker = {}, .request = engine_.request_};
  const CourseworkBuild* build = engine_.state_->coursework->build.get();
  const bool current = build != nullptr && build->folder == courseworkFolder(now.request.with);
  if (current && !build->worker.empty())
    now.worker = build->worker;
  else if (now.request.with == subject_.request.with)
    now.worker = subject_.worker;
  return now;
}

bool Engine::Renderer::outdated() const {
  const std::lock_guard lock(engine_.mutex_);
  return engine_.requests_ != seen_ || stop_.stop_requested();
}

void Engine::Renderer::waitForChange() {
  std::unique_lock lock(engine_.mutex_);
  engine_.changed_.wait(lock, stop_, [&] { return engine_.requests_ != seen_; });
}

// Returns whether there is something to render.
bool Engine::Renderer::prepare() {
  const Subject now = subject();
  const bool newScene = scene_ == nullptr || now.request.scene != subject_.request.scene ||
                        now.sceneStamp != subject_.sceneStamp ||
                        now.request.made.lightSampling != subject_.request.made.lightSampling;
  const bool newWorker = now.worker != subject_.worker;
  const bool newPicture = newScene || newWorker || !samePicture(now.request, subject_.request);
  subject_ = now;
  if (newPicture) begin();
  if (newScene && !loadScene()) return false;
  if (scene_ == nullptr || now.worker.empty() || failed_) return setActivity(Activity::kWaiting);
  if (now.request.camera && now.request.cameraOf != sceneNumber_)
    return setActivity(Activity::kWaiting);
  if (now.request.paused && glanced_) return setActivity(Activity::kPaused);
  if (worker_ == nullptr || workerProgram_ != now.worker || workerScene_ != sceneNumber_)
    startWorker();
  if (now.request.moving && glanced_) return setActivity(Activity::kWaiting);
  if (raysMade_ >= now.request.mostRays) return setActivity(Activity::kFinished);
  return true;
}

bool Engine::Renderer::setActivity(Activity activity) {
  if (engine_.state()->activity != activity)
    engine_.change([&](EngineState& s) { s.activity = activity; });
  return activity == Activity::kRendering;
}

void Engine::Renderer::begin() {
  series_.reset();
  ++seriesNumber_;
  failed_ = glanced_ = false;
  raysMade_ = 0.0;
}

bool Engine::Renderer::loadScene() {
  try {
    auto scene = std::make_shared<PreviewScene>();
    scene->loaded = pathmark::loadScene(subject_.request.scene);
    refuseLargePictures(scene->loaded);
    scene->hash = sceneHash(scene->loaded);
    scene->loaded.flat.lightSampling = subject_.request.made.lightSampling;
    scene_ = std::move(scene);
  } catch (const SceneError& e) {
    engine_.change([&](EngineState& s) { s.sceneFailure = e.what(); });
    failed_ = true;
    return false;
  }
  ++sceneNumber_;
  engine_.change([&](EngineState& s) {
    s.scene = scene_;
    s.sceneNumber = sceneNumber_;
    s.sceneFailure.clear();
  });
  return true;
}

void Engine::Renderer::startWorker() {
  setActivity(Activity::kStarting);
  series_.reset();
  worker_.reset();
  WorkerProcess::Options options;
  options.program = subject_.worker;
  options.courseworkFolder = courseworkFolder(subject_.request.with);
  options.limits.secondsWithoutAnswer = subject_.request.secondsWithoutAnswer;
  options.onText = [this](std::string_view text) {
    engine_.change([&](EngineState& s) {
      s.printed.append(text);
      if (s.printed.size() > kMostPrinted) s.printed.erase(0, s.printed.size() - kMostPrinted);
    });
  };
  worker_ = std::make_unique<WorkerProcess>(std::move(options));
  const StubReport stubs = makeStubReport(worker_->stubs());
  engine_.change([&](EngineState& s) {
    auto coursework = std::make_shared<CourseworkState>(*s.coursework);
    coursework->stubs = stubs;
    s.coursework = std::move(coursework);
    s.workerFailure.clear();
    s.printed.clear();
  });
  worker_->loadScene(scene_->loaded.flat);
  workerProgram_ = subject_.worker;
  workerScene_ = sceneNumber_;
}

void Engine::Renderer::fail(const std::string& sentence) {
  series_.reset();
  worker_.reset();
  failed_ = true;
  engine_.change([&](EngineState& s) {
    s.workerFailure = sentence;
    s.activity = Activity::kWaiting;
  });
}

RenderSettings Engine::Renderer::settings() const {
  constexpr double kEndless = 0x1p40;
  const EngineRequest& request = subject_.request;
  RenderSettings settings;
  settings.width = static_cast<int>(scene_->loaded.flat.camera.width);
  settings.height = static_cast<int>(scene_->loaded.flat.camera.height);
  settings.raysPerPixel = static_cast<std::uint64_t>(std::min(request.mostRays, kEndless));
  settings.threads = request.threads;
  settings.seed = request.seed;
  settings.sampler = request.sampler;
  settings.estimator = request.made.estimator;
  if (request.paths && request.made.estimator != Estimator::kWarmUp)
    letThrough(*request.paths, scene_->loaded.flat, settings);
  settings.camera = request.camera;
  return settings;
}

// First something to see, then all rays, a pass after the other. A quick picture of eight rays
// bridges the time until a long first pass is complete.
void Engine::Renderer::work() {
  setActivity(Activity::kRendering);
  constexpr double kLongPassSeconds = 0.5;
  if (!glanced_) {
    if (!glance(1)) return;
    const bool long_ = glanceSeconds_ * settings().raysPerPass() > kLongPassSeconds;
    if (!subject_.request.moving && long_ && !glance(8)) return;
    glanced_ = true;
    return;
  }
  if (!series_) series_ = std::make_unique<Series>(*worker_, settings());
  const double seconds =
      raysMade_ > 4.0 * settings().raysPerPass() ? kLaterStepSeconds : kFirstStepSeconds;
  if (!series_->step(seconds, [&] { return !outdated(); })) return;
  if (!series_->anyWholePass()) return;
  Series::Made made = series_->made();
  raysMade_ = made.raysPerPixel;
  publish(std::move(made));
}

bool Engine::Renderer::glance(std::uint32_t rays) {
  RenderSettings quick = settings();
  const int width = quick.width, height = quick.height;
  int by = 1;
  if (subject_.request.moving)
    while (by < kCoarsest && glanceSeconds_ / (by * by) > kGlanceSeconds) by *= 2;
  if (by > 1) {
    quick.camera =
        coarser(quick.camera.value_or(scene_->loaded.flat.camera), static_cast<std::uint32_t>(by));
    quick.width = static_cast<int>(quick.camera->width);
    quick.height = static_cast<int>(quick.camera->height);
  }
  quick.raysPerPixel = rays;
  // While the camera moves, a picture is finished even if there is a newer place already: it would
  // never be seen otherwise.
  const bool finish = subject_.request.moving;
  const RenderedImage rendered = renderImage(*worker_, quick, [&](const RenderStatus&) {
    return finish ? !stop_.stop_requested() : !outdated();
  });
  if (!rendered.complete) return false;
  glanceSeconds_ = rendered.seconds * by * by / rays;
  Series::Made made;
  made.image = by > 1 ? enlarged(rendered.image, by, width, height) : rendered.image;
  made.invalid = rendered.invalid;
  made.raysPerPixel = rays / static_cast<double>(by * by);
  made.seconds = rendered.seconds;
  made.raysTraced = rendered.raysTraced;
  publish(std::move(made));
  return true;
}

void Engine::Renderer::publish(Series::Made made) {
  auto picture = std::make_shared<Picture>();
  const EngineRequest& request = subject_.request;
  picture->scene = scene_;
  picture->camera = request.camera.value_or(scene_->loaded.flat.camera);
  picture->fileCamera = !request.camera;
  picture->made = request.made;
  picture->sampler = request.sampler;
  picture->seed = request.seed;
  const RenderSettings asked = settings();
  picture->raysPerPass = asked.raysPerPass();
  picture->paths = asked.paths;
  picture->automaton = asked.automaton;
  picture->coursework = courseworkName(request.with);
  picture->image = std::move(made.image);
  picture->replicates = made.replicates;
  picture->invalid = made.invalid;
  picture->raysPerPixel = made.raysPerPixel;
  picture->seconds = made.seconds;
  picture->raysTraced = made.raysTraced;
  picture->raysPerSecond =
      made.seconds > 0.0 ? static_cast<double>(made.raysTraced) / made.seconds : 0.0;
  picture->series = seriesNumber_;
  picture->version = ++version_;
  engine_.change([&](EngineState& s) { s.picture = std::move(picture); });
}

}  // namespace pathmark::preview
