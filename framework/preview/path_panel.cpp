#include "preview/path_panel.h"

#include "preview/path_remarks.h"
#include "preview/path_table.h"

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

void warn(const std::string& sentence) {
  ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
  ImGui::TextWrapped("! %s", sentence.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void PathPanel::pick(int column, int row) { picked_ = {column, row}; }

// Called by whatever draws first in a frame.
void PathPanel::follow(const Frame& frame) {
  if (frame.picture) followPicture(frame);
  if (request_ && frame.coursework->number != request_->coursework->number &&
      frame.coursework->build && frame.coursework->build->complete()) {
    request_->coursework = frame.coursework;
    engine_.ask(*request_, *frame.wake);
  }
  takeAnswer();
}

void PathPanel::followPicture(const Frame& frame) {
  const std::shared_ptr<const Picture> before = std::exchange(picture_, frame.picture);
  if (request_ && request_->scene->hash != picture_->scene->hash) {
    request_.reset();
    answer_.reset();
    engine_.forget();
  }
  if (request_ && request_->estimator != picture_->estimator) {
    request_->estimator = picture_->estimator;
    engine_.ask(*request_, *frame.wake);
  }
  if (!picked_) return;
  // What was clicked at is the picture that was there before this frame.
  const Picture& seen = before && before->scene == picture_->scene ? *before : *picture_;
  const auto [column, row] = *std::exchange(picked_, std::nullopt);
  if (column < 0 || row < 0 || column >= static_cast<int>(seen.camera.width) ||
      row >= static_cast<int>(seen.camera.height))
    return;
  request_ = PathRequest{};
  request_->scene = seen.scene;
  request_->camera = seen.camera;
  request_->coursework = frame.coursework;
  request_->estimator = seen.estimator;
  request_->sampler = seen.sampler;
  request_->seed = seen.seed;
  request_->raysPerPass = seen.raysPerPass;
  request_->rays = static_cast<std::uint32_t>(rays_);
  request_->column = column;
  request_->row = row;
  engine_.ask(*request_, *frame.wake);
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
  if (!request_) {
    ImGui::TextWrapped(
        "Click a pixel of the picture: the paths that are traced through it are drawn in the "
        "scene, with their numbers here.");
    return;
  }
  drawHead();
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
  const std::string busy = engine_.working() ? "  (recording)" : "";
  ImGui::TextWrapped("Pixel %d, %d%s", request_->column, request_->row, busy.c_str());
  if (!answer_ || !answer_->failure.empty()) return;
  ImGui::TextWrapped("Mean of these %zu paths: %s", answer_->paths.size(),
                     shortColour(answer_->mean).c_str());
  if (!answer_->remark.empty()) warn(answer_->remark);
}

void PathPanel::drawControls(const Frame& frame) {
  ImGui::SetNextItemWidth(std::min(160.0f * frame.scale, ImGui::GetContentRegionAvail().x * 0.4f));
  if (ImGui::SliderInt("paths", &rays_, 1, kMostRays, "%d", ImGuiSliderFlags_AlwaysClamp)) {
    request_->rays = static_cast<std::uint32_t>(rays_);
    engine_.ask(*request_, *frame.wake);
  }
  ImGui::SameLine();
  if (ImGui::Checkbox("brightest first", &brightestFirst_) && answer_) sortPaths();
}

void PathPanel::drawChosen(const Frame& frame) {
  if (selection_.path < 0) return;
  const auto i = static_cast<std::size_t>(selection_.path);
  const TracedPath& path = answer_->paths[i];
  const PathAccount& account = answer_->accounts[i];
  ImGui::Spacing();
  ImGui::TextWrapped("Path %d returned %s.", selection_.path, shortColour(path.radiance).c_str());
  for (const std::string& remark : account.remarks) warn(remark);
  if (account.remarks.empty())
    ImGui::TextWrapped("Its parts add up to that, and each step is f cos / pdf.");
  if (answer_->request.estimator == Estimator::kWarmUp)
    ImGui::TextWrapped("Part 0: f and pdf are those of the task, as your own cannot be seen.");
  throughputBar(frame.scale);
  vertexInTable_ = vertexTable(*answer_, selection_.path, selection_.vertex, frame.scale);
  const int told = vertexInTable_ >= 0 ? vertexInTable_ : selection_.vertex;
  if (told >= 0 && told < static_cast<int>(path.vertices.size()))
    describeVertexHere(*answer_, selection_.path, told);
  else
    ImGui::TextDisabled("Point at a vertex, here or in the picture.");
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
    ImGui::PushTextWrapPos(420.0f * frame.scale);
    describeVertexHere(*answer_, selection_.path, atMouse);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  selection_.vertex = atMouse >= 0 ? atMouse : vertexInTable_;
  overlay.draw(*answer_, selection_);
}

}  // namespace pathmark::preview
