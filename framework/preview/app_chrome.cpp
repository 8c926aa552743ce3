// What the app draws around its panels.
#include "preview/app.h"

#include "preview/compare/error_curves.h"
#include "preview/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pathmark::preview {

namespace {

constexpr float kPanelWidth = 440.0f;
const ImVec4 kNeutral{0.16f, 0.18f, 0.24f, 1.0f};
const ImVec4 kAlarm{0.55f, 0.20f, 0.10f, 1.0f};

constexpr const char* kShortcuts[][2] = {
    {"? or F1", "these shortcuts"},
    {"1 ... 5", "progress, samples, paths, compare, view"},
    {"Space", "pause, and go on"},
    {"R", "begin the picture anew"},
    {"+ and -", "exposure, half a stop at a time"},
    {"0", "the scene's own exposure"},
    {"C", "the camera of the scene file"},
    {"F", "fit the picture to the window"},
    {"F12", "save the window as a PNG file"},
    {"Shift+F12", "save the picture as PNG and EXR files"},
    {"Ctrl+Q", "close the window"},
    {"drag", "orbit the camera"},
    {"Shift+drag, right drag", "move it sidewards"},
    {"wheel", "move it nearer or further"},
    {"Ctrl+wheel", "magnify the picture"},
    {"middle drag", "move the magnified picture"},
    {"click", "show the paths of a pixel"},
};

std::string shortTime(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.1f} s", seconds);
  return fmt::format("{:.0f}:{:02.0f} min", std::floor(seconds / 60.0), std::fmod(seconds, 60.0));
}

const char* activityName(Activity activity) {
  switch (activity) {
    case Activity::kWaiting:
      return "waiting";
    case Activity::kStarting:
      return "starting";
    case Activity::kRendering:
      return "rendering";
    case Activity::kPaused:
      return "paused";
    case Activity::kFinished:
      break;
  }
  return "finished";
}

// Up to so many lines.
std::string firstLines(const std::string& text, int lines) {
  std::size_t at = 0;
  for (int k = 0; k < lines; ++k) {
    at = text.find('\n', at);
    if (at == std::string::npos) return text;
    ++at;
  }
  return text.substr(0, at) + "...";
}

}  // namespace

void App::draw(const std::vector<KeyPress>& pressed) {
  for (const KeyPress& press : pressed) key(press);
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::Begin("Pathmark", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_MenuBar |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  drawMenu();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float all = ImGui::GetContentRegionAvail().x;
  const float panels = std::min(kPanelWidth * window_.scale(), 0.45f * all);
  drawPicture(all - panels - gap);
  ImGui::SameLine();
  drawPanels();
  ImGui::End();
  if (help_) drawHelp();
  drawToast();
}

void App::drawPicture(float width) {
  const float status = ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("left", {width, 0.0f}, false, ImGuiWindowFlags_NoScrollbar);
  drawBanners();
  ImGui::BeginChild("area", {0.0f, -status}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const Frame frame = makeFrame();
  if (frame.picture) {
    PictureArea::Actions actions;
    actions.pose = pose_ && poseOf_ == state_->sceneNumber ? &*pose_ : nullptr;
    actions.pick = [&](int column, int row) {
      panels_->pick(column, row);
      openTab_ = Tab::kPaths;
    };
    actions.drawOver = [&](const Placement& at) { panels_->drawOver(tab_, frame, at); };
    if (area_.draw(panels_->shown(frame), window_.scale(), actions)) {
      request_.camera = pose_->camera();
      request_.moving = true;
      cameraMovedAt_ = ImGui::GetTime();
      apply();
    }
  } else {
    ImGui::TextDisabled(state_->building ? "Compiling ..." : "No picture yet.");
  }
  ImGui::EndChild();
  drawStatus();
  ImGui::EndChild();
}

void App::drawBanners() {
  const bool any = state_->picture != nullptr;
  drawBanner("The scene cannot be used", state_->sceneFailure,
             any ? "The picture is the last one that could be made. Save the scene again to go on."
                 : "Save the scene again to go on.",
             kAlarm);
  drawBanner("Does not compile", state_->buildFailure,
             any ? "The picture is that of the last version that did. Save the file again to go on."
                 : "Save the file again to go on.",
             kAlarm, codeFont());
  drawBanner(
      "Stopped", state_->workerFailure,
      any ? "The picture is the last one that could be made. Save the file again, or press R."
          : "Save the file again, or press R.",
      kAlarm);
  drawBanner("Not written yet", unwrittenSentence(), "", kNeutral);
}

// A picture that is black because of what is missing should not look like a mistake.
std::string App::unwrittenSentence() const {
  const FunctionContract* first = nullptr;
  int count = 0;
  for (const FunctionContract& f : state_->coursework->stubs.unwritten) {
    if (!isUsed(f, request_.made.estimator, request_.made.lightSampling)) continue;
    if (first == nullptr) first = &f;
    ++count;
  }
  if (first == nullptr) return {};
  return fmt::format("{} {} that the picture needs, the first of them {} {}.", count,
                     count == 1 ? "function" : "functions", first->section, first->name);
}

void App::drawBanner(const char* title, const std::string& text, const char* remedy,
                     const ImVec4& colour, ImFont* font) {
  if (text.empty()) return;
  constexpr int kLines = 12;
  const std::string words = firstLines(text, kLines);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::GetContentRegionAvail().x - 2.0f * style.WindowPadding.x;
  const auto heightOf = [&](const char* t) {
    return *t == '\0' ? 0.0f
                      : ImGui::CalcTextSize(t, nullptr, false, width).y + style.ItemSpacing.y;
  };
  float height = heightOf(title) + heightOf(remedy) + 2.0f * style.WindowPadding.y;
  if (font == nullptr) font = ImGui::GetFont();
  ImGui::PushFont(font);
  height += heightOf(words.c_str());
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour);
  ImGui::BeginChild(title, {0.0f, height}, true);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(title);
  ImGui::PushFont(font);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopFont();
  if (*remedy != '\0') ImGui::TextUnformatted(remedy);
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

void App::drawPanels() {
  ImGui::BeginChild("panels");
  const Frame frame = makeFrame();
  constexpr const char* kTitles[kTabs] = {"Progress", "Samples", "Paths", "Compare", "View"};
  if (ImGui::BeginTabBar("tabs")) {
    for (int k = 0; k < kTabs; ++k) {
      const auto tab = static_cast<Tab>(k);
      const bool open = openTab_ == tab;
      if (!ImGui::BeginTabItem(kTitles[k], nullptr, open ? ImGuiTabItemFlags_SetSelected : 0))
        continue;
      tab_ = tab;
      ImGui::BeginChild("panel");
      if (tab == Tab::kView)
        drawView();
      else
        panels_->draw(tab, frame);
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  openTab_.reset();
  ImGui::EndChild();
}

// The scene, and how it is seen.
void App::drawView() {
  if (state_->scene) {
    const LoadedScene& scene = state_->scene->loaded;
    ImGui::TextUnformatted(scene.name.c_str());
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextDisabled("%s", scene.caption.c_str());
    for (const std::string& note : scene.notes) ImGui::TextDisabled("%s", note.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::Separator();
  auto stops = static_cast<float>(stops_);
  if (ImGui::SliderFloat("stops", &stops, -10.0f, 10.0f, "%+.1f")) stops_ = stops;
  ImGui::SameLine();
  ImGui::TextDisabled("exposure");
  panels_->drawDisplay();
  auto seed = static_cast<std::int64_t>(request_.seed);
  constexpr std::int64_t kStep = 1, kFastStep = 100;
  if (ImGui::InputScalar("seed", ImGuiDataType_S64, &seed, &kStep, &kFastStep)) {
    request_.seed = static_cast<std::uint64_t>(std::max(seed, std::int64_t{0}));
    apply();
  }
  ImGui::Separator();
  const bool warmUp = request_.made.estimator == Estimator::kWarmUp;
  if (pathsField_.draw(state_->scene ? &state_->scene->loaded.flat : nullptr, warmUp)) {
    request_.paths = pathsField_.expression();
    apply();
  }
  ImGui::Separator();
  ImGui::TextUnformatted("What the coursework has printed:");
  ImGui::BeginChild("printed", {0.0f, 0.0f}, true, ImGuiWindowFlags_HorizontalScrollbar);
  if (state_->printed.empty())
    ImGui::TextDisabled("nothing");
  else
    ImGui::TextUnformatted(state_->printed.c_str());
  ImGui::EndChild();
}

void App::drawStatus() {
  std::string text = state_->building ? "compiling" : activityName(state_->activity);
  if (state_->picture) {
    const Picture& p = *state_->picture;
    text += fmt::format("   {:.4g} rays per pixel   {}   {:.1f} million rays/s", p.raysPerPixel,
                        shortTime(p.seconds), 1e-6 * p.raysPerSecond);
    if (noiseOf_ != p.version) {
      noiseOf_ = p.version;
      noise_ = expectedError(p.image, nullptr);
    }
    if (noise_) text += fmt::format("   noise {:.2g} %", 100.0 * std::sqrt(*noise_));
    if (const std::string_view way = wayWords(p.made); !way.empty())
      text += fmt::format("   {}", way);
    if (!p.paths.empty()) text += fmt::format("   light paths {}", p.paths);
    if (p.invalid.count() > 0)
      text += fmt::format("   {} no radiance (magenta)", p.invalid.count());
    if (area_.hovered()) {
      const auto [column, row] = *area_.hovered();
      const auto value = p.image.pixel(column, row);
      text += fmt::format("   column {}, row {}: {:.4g} {:.4g} {:.4g}", column, row, value[0],
                          value[1], value[2]);
    }
  }
  ImGui::TextUnformatted(text.c_str());
}

void App::drawHelp() {
  const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
  ImGui::SetNextWindowPos(middle, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::Begin("Shortcuts", &help_,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
  if (ImGui::BeginTable("keys", 2)) {
    for (const auto& [key, meaning] : kShortcuts) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(key);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(meaning);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

void App::drawToast() {
  if (ImGui::GetTime() > toastUntil_) return;
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos({0.5f * io.DisplaySize.x, 0.9f * io.DisplaySize.y}, ImGuiCond_Always,
                          {0.5f, 0.5f});
  ImGui::Begin("toast", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextUnformatted(toast_.c_str());
  ImGui::End();
}

}  // namespace pathmark::preview
