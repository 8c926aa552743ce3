#include "preview/compare/compare_panel.h"

#include "preview/compare/compare_overlay.h"
#include "preview/compare/compare_widgets.h"

#include <imgui.h>

namespace pathmark::preview {

namespace {

// Where nobody looks, only as often as the error curve needs points.
constexpr double kSpacingUnseen = 1.19;

constexpr float kPlotHeight = 190.0f;

}  // namespace

void ComparePanel::ask(const Frame& frame) {
  const Picture& picture = *frame.picture;
  const Asked now{picture.version, picture.series, wish_.number, picture.raysPerPixel, view_};
  const bool other = !asked_ || asked_->series != now.series || asked_->wish != now.wish ||
                     asked_->view != now.view;
  const bool seen = drawn_ || view_ != View::kPicture;
  const bool enough = seen ? asked_ && asked_->version != now.version
                           : asked_ && now.raysPerPixel > kSpacingUnseen * asked_->raysPerPixel;
  if (!other && !enough) return;
  if (!worker_)
    worker_ = std::make_unique<CompareWorker>(frame.wake != nullptr ? *frame.wake
                                                                    : std::function<void()>([] {}));
  worker_->ask({frame.picture, wish_, view_}, other);
  asked_ = now;
}

const Shown& ComparePanel::shown(const Frame& frame) {
  if (frame.picture) ask(frame);
  drawn_ = false;
  if (worker_) result_ = worker_->newest();
  DisplaySettings display = display_;
  display.exposure = frame.exposure;
  return maker_.make(
      {frame.picture, result_, wish_.number, view_, display, static_cast<double>(slider_)});
}

bool ComparePanel::busy(const Frame& frame) const {
  if (!frame.picture) return false;
  return !result_ || result_->picture->version != frame.picture->version ||
         result_->wish != wish_.number || result_->view != view_;
}

void ComparePanel::drawOver(const Frame& frame, const Placement& placement) {
  if (!frame.picture) return;
  const CompareResult* result = result_ && result_->wish == wish_.number ? result_.get() : nullptr;
  drawCompareOverlay({frame, placement, maker_.view(), result}, slider_);
}

void ComparePanel::drawDisplay() {
  constexpr const char* kCurves[] = {"clip, as in PNG files", "Reinhard", "filmic (ACES fit)"};
  int curve = static_cast<int>(display_.curve);
  ImGui::SetNextItemWidth(13.0f * ImGui::GetFontSize());
  if (ImGui::Combo("tone curve", &curve, kCurves, 3))
    display_.curve = static_cast<ToneCurve>(curve);
  if (display_.curve != ToneCurve::kReinhard) return;
  auto white = static_cast<float>(display_.white);
  ImGui::SetNextItemWidth(13.0f * ImGui::GetFontSize());
  if (ImGui::SliderFloat("white", &white, 1.0f, 100.0f, "%.1f",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
    display_.white = static_cast<double>(white);
}

void ComparePanel::wishFor(ReferenceSource source) {
  wish_.source = source;
  ++wish_.number;
}

// As of what the worker has found out about this series.
bool ComparePanel::canKeep(const Frame& frame) const {
  return frame.picture && result_ && result_->noiseKnown &&
         result_->picture->series == frame.picture->series;
}

void ComparePanel::drawFileField(const Frame& frame) {
  const float button = ImGui::CalcTextSize("Load").x + 3.0f * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x - 2.0f * frame.scale);
  bool load = ImGui::InputTextWithHint("##file", "path of an .exr, .pfm or .hdr file", path_.data(),
                                       path_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  load = ImGui::Button("Load") || load;
  if (!load) return;
  wish_.file = path_.data();
  ++wish_.loads;
  wishFor(ReferenceSource::kFile);
}

void ComparePanel::drawReferenceChoice(const Frame& frame) {
  ImGui::TextUnformatted("Reference");
  const auto choice = [&](const char* name, ReferenceSource source) {
    if (ImGui::RadioButton(name, wish_.source == source) && wish_.source != source) wishFor(source);
  };
  choice("of the scene", ReferenceSource::kShipped);
  ImGui::SameLine();
  choice("kept", ReferenceSource::kKept);
  ImGui::SameLine();
  choice("file", ReferenceSource::kFile);
  if (wish_.source == ReferenceSource::kFile) drawFileField(frame);
  const bool possible = canKeep(frame);
  ImGui::BeginDisabled(!possible);
  if (ImGui::Button("Keep this picture as the reference")) {
    wish_.kept = frame.picture;
    wishFor(ReferenceSource::kKept);
  }
  ImGui::EndDisabled();
  if (!possible && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    ImGui::SetTooltip("When its noise is known.");
}

void ComparePanel::draw(const Frame& frame) {
  drawn_ = true;
  if (!frame.picture) {
    ImGui::TextDisabled("There is no picture yet.");
    return;
  }
  const bool current = result_ && result_->wish == wish_.number;
  const CompareResult* result = current ? result_.get() : nullptr;
  drawViewChoice(view_, result != nullptr && result->found.reference != nullptr);
  ImGui::Separator();
  drawReferenceChoice(frame);
  ImGui::Separator();
  if (isFalseColour(view_)) drawColourBar(view_, result, frame.scale);
  if (result == nullptr) {
    ImGui::TextDisabled("Comparing ...");
    return;
  }
  drawFound(result->found);
  if (result->comparison) {
    drawVerdict(*result, frame.scale);
    drawNumbers(*result);
  }
  ImGui::Separator();
  drawErrorCurves(*result, byTime_, kPlotHeight * frame.scale, frame.scale);
}

}  // namespace pathmark::preview
