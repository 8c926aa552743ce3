#include "preview/paths/path_panel.h"

#include "preview/paths/path_remarks.h"
#include "preview/paths/path_table.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pathmark::preview {

namespace {

constexpr ImU32 kWarning = IM_COL32(255, 170, 80, 255);
constexpr int kMostRays = 256;

// Rays of a request are those of the picture if these are the same.
bool madeLike(const PathRequest& request, const Picture& picture) {
  return request.made.estimator == picture.made.estimator && request.sampler == picture.sampler &&
         request.seed == picture.seed && request.automaton == picture.automaton &&
         request.raysPerPass == picture.raysPerPass;
}

void makeLike(PathRequest& request, const Picture& picture) {
  request.made = picture.made;
  request.sampler = picture.sampler;
  request.automaton = picture.automaton;
  request.seed = picture.seed;
  request.raysPerPass = picture.raysPerPass;
}

void say(const std::string& sentence) { wrappedText(sentence, ImGui::GetContentRegionAvail().x); }

void warn(const std::string& sentence) {
  ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
  say("! " + sentence);
  ImGui::PopStyleColor();
}

// The first is often the reason of the others.
void drawRemarks(const PathAccount& account) {
  constexpr std::size_t kMost = 2;
  const std::size_t count = account.remarks.size();
  for (std::size_t i = 0; i < std::min(count, kMost); ++i) warn(account.remarks[i]);
  if (count > kMost) warn(fmt::format("{} more like that", count - kMost));
  if (count > 0) return;
  say(account.known
          ? "Its parts add up to that, and each step is f cos / pdf."
          : "Each step is f cos / pdf. Whether the parts add up is not known, as where one "
            "of several lights is chosen with a probability that only your code knows.");
}

void legend() {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped(
      "Point at a vertex, here or in the picture, for all its numbers; a colour has one number "
      "here, its luminance. Dashes lead to points of lights; they are orange, with a cross, where "
      "something is in the way. Arrows are normals. ! marks what does not fit.");
  ImGui::PopStyleColor();
}

}  // namespace

void PathPanel::pick(int column, int row) { picked_ = {column, row}; }

// Called by whatever draws first in a frame.
void PathPanel::follow(const Frame& frame) {
  const auto& build = frame.coursework->build;
  if (!coursework_ || (build && !build->worker.empty())) coursework_ = frame.coursework;
  if (frame.picture) followPicture(frame);
  if (request_ && request_->coursework->number != coursework_->number) {
    request_->coursework = coursework_;
    engine_.ask(*request_, *frame.wake);
  }
  takeAnswer();
}

void PathPanel::followPicture(const Frame& frame) {
  const std::shared_ptr<const Picture> before = std::exchange(picture_, frame.picture);
  const Picture& now = *picture_;
  if (request_ && request_->scene->hash != now.scene->hash) forget();
  if (request_ && !madeLike(*request_, now)) {
    makeLike(*request_, now);
    engine_.ask(*request_, *frame.wake);
  }
  if (picked_) followPick(before && before->scene == now.scene ? *before : now, frame);
}

void PathPanel::followPick(const Picture& seen, const Frame& frame) {
  const auto [column, row] = *std::exchange(picked_, std::nullopt);
  const FlatCamera& camera = seen.camera;
  note_.clear();
  if (column < 0 || row < 0 || column >= static_cast<int>(camera.width) ||
      row >= static_cast<int>(camera.height)) {
    note_ = fmt::format("Pixel {}, {} is not in the picture, which has {} x {} pixels.", column,
                        row, camera.width, camera.height);
    return;
  }
  request_ = PathRequest{};
  request_->scene = seen.scene;
  request_->camera = camera;
  request_->coursework = coursework_;
  makeLike(*request_, seen);
  request_->rays = static_cast<std::uint32_t>(rays_);
  request_->column = column;
  request_->row = row;
  engine_.ask(*request_, *frame.wake);
}

void PathPanel::forget() {
  request_.reset();
  answer_.reset();
  engine_.forget();
}

// The chosen path stays if it is of the same pixel: other code sends it another way, and that is
// what somebody wants to see.
void PathPanel::takeAnswer() {
  const auto answer = engine_.answer();
  if (!request_ || !answer || answer == answer_) return;
  const bool samePixel = answer_ && answer_->request.column == answer->request.column &&
                         answer_->request.row == answer->request.row;
  answer_ = answer;
  sortPaths();
  const auto paths = static_cast<int>(answer_->paths.size());
  if (!samePixel || selection_.path < 0 || selection_.path >= paths)
    selection_.path = order_.empty() ? -1 : order_.front();
}

void PathPanel::sortPaths() {
  order_.resize(answer_->paths.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (!brightestFirst_) return;
  std::stable_sort(order_.begin(), order_.end(), [this](int a, int b) {
    const auto brightness = [this](int i) {
      const double value = luminance(answer_->paths[static_cast<std::size_t>(i)].radiance);
      return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
    };
    return brightness(a) > brightness(b);
  });
}

void PathPanel::draw(const Frame& frame) {
  follow(frame);
  if (!note_.empty()) warn(note_);
  if (!request_) {
    ImGui::TextWrapped(
        "Click a pixel of the picture: the paths that are traced through it are drawn in the "
        "scene, with their numbers here.");
    return;
  }
  drawHead();
  if (!request_) return;
  drawControls(frame);
  if (!answer_) return;
  if (!answer_->failure.empty()) return warn(answer_->failure);
  if (answer_->paths.empty()) return;
  const int before = selection_.path;
  selection_.path = pathList(*answer_, order_, selection_.path, frame.scale);
  if (selection_.path != before) selection_.vertex = vertexInTable_ = -1;
  drawChosen(frame);
}

void PathPanel::drawHead() {
  ImGui::AlignTextToFramePadding();
  ImGui::Text("Pixel %d, %d%s", request_->column, request_->row,
              engine_.working() ? "  (recording)" : "");
  const float width = ImGui::CalcTextSize("Clear").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  if (ImGui::Button("Clear")) return forget();
  if (!answer_ || !answer_->failure.empty()) return;
  say(fmt::format("Mean of these {} paths: {}", answer_->paths.size(), shortColour(answer_->mean)));
  if (!answer_->remark.empty()) warn(answer_->remark);
}

void PathPanel::drawControls(const Frame& frame) {
  ImGui::SetNextItemWidth(std::min(160.0f * frame.scale, ImGui::GetContentRegionAvail().x * 0.4f));
  if (ImGui::SliderInt("paths", &rays_, 1, kMostRays, "%d", ImGuiSliderFlags_AlwaysClamp)) {
    request_->rays = static_cast<std::uint32_t>(rays_);
    engine_.ask(*request_, *frame.wake);
  }
  ImGui::SameLine();
  ImGui::Checkbox("draw all", &selection_.all);
  if (ImGui::Checkbox("brightest first", &brightestFirst_) && answer_) sortPaths();
}

void PathPanel::drawChosen(const Frame& frame) {
  if (selection_.path < 0) return;
  const auto i = static_cast<std::size_t>(selection_.path);
  const TracedPath& path = answer_->paths[i];
  const PathAccount& account = answer_->accounts[i];
  ImGui::Spacing();
  say(fmt::format("Path {} returned {}.", selection_.path, shortColour(path.radiance)));
  drawRemarks(account);
  if (answer_->request.made.estimator == Estimator::kWarmUp)
    say("Part 0: f and pdf are those of the task, as your own cannot be seen.");
  if (answer_->request.made.estimator == Estimator::kMis)
    say("Part 8: light samples, and lights that are met, count by the power heuristic's weights.");
  throughputBar(frame.scale);
  vertexInTable_ = vertexTable(*answer_, selection_.path, selection_.vertex, frame.scale);
  const int told = vertexInTable_ >= 0 ? vertexInTable_ : selection_.vertex;
  if (told >= 0 && told < static_cast<int>(path.vertices.size()))
    describeVertexHere(*answer_, selection_.path, told, ImGui::GetContentRegionAvail().x);
  else
    legend();
}

bool PathPanel::cameraIsThatOf(const Picture& picture) const {
  const FlatCamera &a = request_->camera, &b = picture.camera;
  return a.eye == b.eye && a.topLeft == b.topLeft && a.pixelRight == b.pixelRight &&
         a.pixelDown == b.pixelDown;
}

void PathPanel::drawOver(const Frame& frame, const Placement& placement) {
  follow(frame);
  if (!request_ || !frame.picture) return;
  const PathOverlay overlay(frame, placement);
  if (cameraIsThatOf(*frame.picture)) overlay.markPixel(request_->column, request_->row);
  if (!answer_ || !answer_->failure.empty()) return;
  const auto chosen = static_cast<std::size_t>(selection_.path);
  const bool any = selection_.path >= 0 && chosen < answer_->paths.size();
  const int atMouse =
      any && ImGui::IsWindowHovered() ? overlay.vertexAtMouse(answer_->paths[chosen]) : -1;
  if (atMouse >= 0) {
    ImGui::BeginTooltip();
    describeVertexHere(*answer_, selection_.path, atMouse, 420.0f * frame.scale);
    ImGui::EndTooltip();
  }
  selection_.vertex = atMouse >= 0 ? atMouse : vertexInTable_;
  overlay.draw(*answer_, selection_);
}

}  // namespace pathmark::preview
