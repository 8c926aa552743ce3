#include "preview/progress/progress_panel.h"

#include "host/session.h"
#include "preview/marks.h"
#include "preview/panel_text.h"
#include "preview/row_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

namespace pathmark::preview {

namespace {

// Right, wrong and undecided side by side; the rest stays empty.
void drawBar(const Progress& progress) {
  const float width = ImGui::GetContentRegionAvail().x, height = 0.7f * ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  list->AddRectFilled(corner, {corner.x + width, corner.y + height},
                      ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
  float left = corner.x;
  for (const Outcome outcome :
       {Outcome::kPass, Outcome::kUndecided, Outcome::kFail, Outcome::kBroken}) {
    const int count = progress.count(outcome);
    if (count == 0) continue;
    const float right =
        left + width * static_cast<float>(count) / static_cast<float>(progress.functions());
    list->AddRectFilled({left, corner.y}, {right, corner.y + height}, colourOf(outcome), rounding);
    left = right;
  }
  ImGui::Dummy({width, height});
}

std::string countsInWords(const Progress& progress) {
  std::string text;
  for (const Outcome outcome : {Outcome::kFail, Outcome::kBroken, Outcome::kUndecided,
                                Outcome::kBlocked, Outcome::kNotWritten, Outcome::kUnknown}) {
    const int count = progress.count(outcome);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, wordOf(outcome));
  }
  return text;
}

}  // namespace

ProgressPanel::ProgressPanel(HintSource hints) : details_(std::move(hints)) {}

void ProgressPanel::update(const Frame& frame) {
  if (frame.coursework == coursework_ && frame.checks == checks_) return;
  const bool sameFolder = coursework_ && coursework_->build && frame.coursework->build &&
                          coursework_->build->folder == frame.coursework->build->folder;
  if (!sameFolder) {
    known_.reset();
    firstOfFolder_ = frame.coursework->number;
  }
  coursework_ = frame.coursework;
  checkImages_ = "./pathmark check images";
  if (coursework_->build) checkImages_ += withOption(coursework_->build->folder);
  if (frame.checks && frame.checks != checks_ && frame.checks->build >= firstOfFolder_)
    known_ = withOlder(*frame.checks, known_ ? &*known_ : nullptr);
  checks_ = frame.checks;
  progress_ = progressOf(*coursework_, known_ ? &*known_ : nullptr);
}

bool ProgressPanel::busy(const Frame& frame) {
  const CheckReport* checks = frame.checks.get();
  if (!frame.coursework->build) return false;
  return checks == nullptr || !checks->finished || checks->build != frame.coursework->number;
}

void ProgressPanel::choose(CourseworkFunction function) {
  chosen_ = chosen_ == function ? std::nullopt : std::optional(function);
  if (chosen_ && onChoose) onChoose(function);
}

void ProgressPanel::draw(const Frame& frame) {
  update(frame);
  drawHead();
  ImGui::Separator();
  ImGui::BeginChild("parts");
  for (const PartRow& part : progress_.parts) drawPart(part, frame);
  ImGui::EndChild();
}

void ProgressPanel::drawHead() {
  ImGui::Text("%d of %d functions are right", progress_.count(Outcome::kPass),
              progress_.functions());
  drawBar(progress_);
  const bool finished = !progress_.checking && !progress_.status.empty();
  if (const std::string words = finished ? progress_.status : countsInWords(progress_);
      !words.empty())
    drawDim(words);
  drawNext();
  if (!progress_.checking) return;
  ImGui::ProgressBar(static_cast<float>(progress_.fraction), {-1.0f, 0.0f});
  drawDim(progress_.status.empty() ? "Preparing to check" : progress_.status);
}

void ProgressPanel::drawNext() {
  if (!progress_.next.empty()) {
    drawWrapped("Next: " + progress_.next);
  } else if (progress_.count(Outcome::kPass) == progress_.functions()) {
    drawWrapped("Every function is right by itself. Now the pictures: " + checkImages_);
    if (ImGui::SmallButton("copy command")) ImGui::SetClipboardText(checkImages_.c_str());
  }
  if (!progress_.nextFunction) return;
  const CourseworkFunction next = *progress_.nextFunction;
  const bool show = ImGui::SmallButton("show it");
  ImGui::SameLine();
  const bool hint = ImGui::SmallButton("hint");
  if (hint) details_.giveHint(next);
  if (!show && !hint) return;
  if (chosen_ != next) choose(next);
  scrollToChosen_ = true;
}

bool ProgressPanel::wantsOpen(const PartRow& part, int chosenPart) const {
  if (const auto& said = opened_[static_cast<std::size_t>(part.part.part)]) return *said;
  if (part.part.part == chosenPart || !part.failure.empty()) return true;
  return std::any_of(part.functions.begin(), part.functions.end(), [&](const FunctionRow& row) {
    return row.outcome == Outcome::kFail || row.outcome == Outcome::kBroken ||
           row.outcome == Outcome::kUndecided || row.function.function == progress_.nextFunction ||
           row.function.function == chosen_;
  });
}

void ProgressPanel::drawPart(const PartRow& part, const Frame& frame) {
  const auto number = static_cast<std::size_t>(part.part.part);
  ImGui::PushID(part.part.part);
  const bool wanted = wantsOpen(part, frame.part);
  ImGui::SetNextItemOpen(wanted, ImGuiCond_Always);
  const std::string title =
      fmt::format("Part {}   {}   {}###part", part.part.part,
                  part.bonusNotBegun()
                      ? std::string("bonus")
                      : fmt::format("{}/{}", part.count(Outcome::kPass), part.functions.size()),
                  part.part.title);
  const bool open = ImGui::CollapsingHeader(title.c_str());
  if (ImGui::IsItemToggledOpen()) opened_[number] = !wanted;
  if (open) {
    drawDim(part.part.file);
    if (!part.failure.empty()) {
      const float height = ImGui::GetFontSize();
      const ImVec2 corner = ImGui::GetCursorScreenPos();
      drawMark({corner.x + 0.5f * height, corner.y + 0.5f * height}, 0.4f * height,
               Outcome::kBroken);
      ImGui::SetCursorScreenPos({corner.x + 1.4f * height, corner.y});
      drawWrapped(fmt::format("This file {}", part.failure));
    }
    for (const FunctionRow& row : part.functions) drawRow(row, frame.scale);
  }
  ImGui::PopID();
}

void ProgressPanel::drawRow(const FunctionRow& row, float scale) {
  ImGui::PushID(static_cast<int>(row.function.function));
  const RowText text(row);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool isChosen = chosen_ == row.function.function;
  if (ImGui::Selectable("##row", isChosen, ImGuiSelectableFlags_None, {0.0f, text.height(scale)}))
    choose(row.function.function);
  if (isChosen && std::exchange(scrollToChosen_, false)) ImGui::SetScrollHereY(0.15f);
  text.draw(corner, scale);
  if (chosen_ == row.function.function) details_.draw(row, scale);
  ImGui::PopID();
}

}  // namespace pathmark::preview
