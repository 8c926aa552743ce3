#include "preview/app.h"

#include "film/atomic_file.h"
#include "film/image_file.h"
#include "film/image_formats.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/session.h"
#include "preview/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

namespace pathmark::preview {

namespace {

// The camera counts as moving for so long after it was moved last.
constexpr double kSettleSeconds = 0.2;

// Widgets answer to what the last frame has drawn, and what lies over the picture is drawn before
// the panel that it belongs to takes its news: it takes more than one frame until all is settled.
constexpr int kFramesAfterInput = 3, kFramesAfterNews = 2;

int framesAfter(Window::Event event) {
  switch (event) {
    case Window::Event::kWoken:
      return kFramesAfterNews;
    case Window::Event::kInput:
      return kFramesAfterInput;
    case Window::Event::kNone:
      break;
  }
  return 0;
}

constexpr double kToastSeconds = 4.0;
constexpr double kIdleSeconds = 1.0;

}  // namespace

std::string unusedStem(const std::string& stem, std::initializer_list<const char*> endings) {
  for (int k = 1;; ++k) {
    std::string numbered = fmt::format("{}_{:03}", stem, k);
    // A name that there cannot be, such as one that is too long, is refused when it is written.
    const auto isThere = [&](const char* ending) {
      std::error_code error;
      return std::filesystem::exists(numbered + ending, error);
    };
    if (std::ranges::none_of(endings, isThere)) return numbered;
  }
}

App::App(Window& window, AppOptions options)
    : window_(window),
      options_(std::move(options)),
      request_(options_.request),
      wake_([] { Window::wake(); }),
      part_(options_.part >= 0 ? options_.part : 5),
      openTab_(options_.tab),
      stops_(options_.exposureStops),
      panels_(std::make_unique<Panels>(
          wake_, [this](CourseworkFunction f) { choosePart(contractOf(f).part); })) {
  request_.made = pictureOfPart(part_);
  if (request_.paths) pathsField_.show(request_.paths->text());
  engine_ = std::make_unique<Engine>(request_, wake_);
  state_ = engine_->state();
}

App::~App() = default;

double App::exposure() const {
  return (state_->scene ? state_->scene->loaded.exposure : 1.0) * std::exp2(stops_);
}

int App::run() {
  while (window_.open() && !interrupted()) {
    // The end of a movement and of a message are news too.
    const double now = ImGui::GetTime();
    const bool waiting = request_.moving || now < toastUntil_;
    if (framesDue_ <= 0) framesDue_ = framesAfter(window_.wait(waiting ? 0.05 : kIdleSeconds));
    if (framesDue_ <= 0 && !waiting && !options_.scripted()) continue;
    --framesDue_;
    takeNews();
    showFrame();
    if (windowShot_) {
      saveWindow(*windowShot_);
      windowShot_.reset();
    }
    if (options_.scripted() && scriptDone()) break;
  }
  return interrupted() ? kInterrupted : exitCode_;
}

Remembered App::remembered() const {
  return {.width = window_.width(),
          .height = window_.height(),
          .scene = std::filesystem::absolute(request_.scene).lexically_normal().string(),
          .part = part_};
}

void App::showFrame(Pixels* seen) {
  window_.drawFrame([this](const auto& pressed) { draw(pressed); }, seen);
}

void App::takeNews() {
  state_ = engine_->state();
  if (state_->scene && poseOf_ != state_->sceneNumber) {
    // A save that leaves the file's camera where it was leaves the moved one there too.
    const LoadedScene& scene = state_->scene->loaded;
    if (!pose_ || poseIn_ != scene.name || !pose_->isOf(scene)) {
      pose_.emplace(scene);
      request_.camera.reset();
    }
    poseIn_ = scene.name;
    poseOf_ = state_->sceneNumber;
    apply();
  }
  panels_->takeNews(*state_);
  if (options_.pick && state_->picture) {
    const auto [column, row] = *std::exchange(options_.pick, std::nullopt);
    panels_->pick(column, row);
  }
  if (request_.moving && ImGui::GetTime() - cameraMovedAt_ > kSettleSeconds) {
    request_.moving = false;
    apply();
  }
  window_.setTitle(title());
}

std::string App::title() const {
  std::string text = "Pathmark";
  if (!state_->picture) return text;
  const Picture& picture = *state_->picture;
  text += fmt::format(": {}, {}, {:.4g} rays per pixel", picture.scene->loaded.name,
                      picture.coursework, picture.raysPerPixel);
  if (!picture.paths.empty()) text += fmt::format(", light paths {}", picture.paths);
  if (!state_->buildFailure.empty()) text += ", does not compile";
  if (!state_->sceneFailure.empty()) text += ", the scene cannot be used";
  if (!state_->workerFailure.empty()) text += ", stopped";
  return text;
}

void App::apply() {
  request_.cameraOf = poseOf_;
  engine_->request(request_);
  framesDue_ = kFramesAfterInput;
}

Frame App::makeFrame() const {
  Frame frame;
  frame.picture = state_->picture;
  frame.coursework = state_->coursework;
  frame.checks = panels_->checks();
  frame.part = part_;
  frame.scale = window_.scale();
  frame.exposure = exposure();
  frame.wake = &wake_;
  return frame;
}

void App::choosePart(int part) {
  if (part == part_) return;
  part_ = part;
  request_.made = pictureOfPart(part);
  apply();
}

void App::chooseScene(const std::string& name) {
  request_.scene = findScene(name);
  apply();
}

void App::togglePause() {
  request_.paused = !request_.paused;
  apply();
}

void App::beginAnew() {
  ++request_.restarts;
  apply();
}

void App::useFileCamera() {
  if (!pose_ || !request_.camera) return;
  pose_->reset();
  request_.camera.reset();
  apply();
}

void App::say(std::string text) {
  toast_ = std::move(text);
  toastUntil_ = ImGui::GetTime() + kToastSeconds;
}

// Who is at the window reads the sentence; a script has the exit code alone.
void App::cannotWrite(const ImageError& error) {
  say(error.what());
  if (options_.scripted()) exitCode_ = kMachineFault;
}

void App::askForWindowShot() { windowShot_ = unusedStem("pathmark_window", {".png"}) + ".png"; }

void App::saveWindow(const std::filesystem::path& file) {
  Pixels pixels;
  showFrame(&pixels);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(pixels.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < pixels.rgba.size(); i += 4)
    rgb.insert(rgb.end(), {pixels.rgba[i], pixels.rgba[i + 1], pixels.rgba[i + 2]});
  try {
    writeFileAtomically(file, encodePngBytes(pixels.width, pixels.height, rgb));
    say(fmt::format("Saved the window to {}", displayPath(file)));
  } catch (const ImageError& e) {
    cannotWrite(e);
  }
}

void App::savePicture(const std::filesystem::path& file) {
  const Picture& picture = *state_->picture;
  ImageOrigin origin{
      .scene = picture.scene->loaded.name,
      .sceneHash = picture.fileCamera ? picture.scene->hash : std::string(),
      .coursework = picture.coursework,
      .raysPerPixel = picture.raysPerPixel,
      .raysPerPass = picture.raysPerPass,
      .replicates = std::max(1u, picture.replicates),
      .seed = picture.seed,
      .sampler = std::string(kSamplerNames[static_cast<std::size_t>(picture.sampler)]),
      .paths = picture.paths,
      .seconds = picture.seconds};
  try {
    writeImage(file, picture.image, exposure(), origin);
    say(fmt::format("Saved the picture to {}", displayPath(file)));
  } catch (const ImageError& e) {
    cannotWrite(e);
  }
}

void App::saveBoth() {
  if (!state_->picture) return say("There is no picture yet.");
  const std::string stem =
      unusedStem("pathmark_" + state_->picture->scene->loaded.name, {".png", ".exr"});
  savePicture(stem + ".png");
  savePicture(stem + ".exr");
}

// A script that cannot come to its picture ends with the reason.
bool App::scriptDone() {
  for (const std::string* failure :
       {&state_->sceneFailure, &state_->buildFailure, &state_->workerFailure}) {
    if (failure->empty()) continue;
    fmt::print(stderr, "{}\n", *failure);
    exitCode_ = failure == &state_->sceneFailure ? kUsageFault : kCourseworkFault;
  }
  const bool failed = exitCode_ != 0;
  const bool enough = state_->picture && state_->activity == Activity::kFinished;
  if (!failed && (!enough || panels_->busy(options_.tab, makeFrame()))) return false;
  if (!options_.screenshot.empty()) {
    // What has just come is in the window after this many frames.
    for (int k = 0; k < kFramesAfterInput; ++k) showFrame();
    saveWindow(options_.screenshot);
  }
  if (!options_.picture.empty() && !failed) savePicture(options_.picture);
  return true;
}

}  // namespace pathmark::preview
