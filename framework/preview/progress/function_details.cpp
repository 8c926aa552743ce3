#include "preview/progress/function_details.h"

#include "preview/marks.h"
#include "preview/panel_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace pathmark::preview {

namespace {

// The check that tells most: the others usually follow from it.
const CheckLine* firstWrong(const FunctionVerdict* verdict) {
  if (verdict == nullptr) return nullptr;
  const auto with = [&](Outcome outcome) -> const CheckLine* {
    for (const CheckLine& line : verdict->checks)
      if (line.outcome == outcome) return &line;
    return nullptr;
  };
  return with(verdict->outcome == Outcome::kPass ? Outcome::kFail : verdict->outcome);
}

void drawField(const CheckLine::Field& field) {
  drawDim(field.name);
  ImGui::SameLine(6.0f * ImGui::GetFontSize());
  drawWrapped(field.value);
}

void drawCommand(const CheckLine& line) {
  drawDim("repeat");
  ImGui::SameLine(6.0f * ImGui::GetFontSize());
  drawWrapped(line.command);
  if (ImGui::SmallButton("copy command")) ImGui::SetClipboardText(line.command.c_str());
}

void drawCheck(const CheckLine& line, bool open) {
  ImGui::PushID(line.id.c_str());
  const float height = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  drawMark({corner.x + 0.5f * height, corner.y + 0.5f * height}, 0.36f * height, line.outcome);
  ImGui::SetCursorScreenPos({corner.x + 1.4f * height, corner.y});
  ImGui::BeginGroup();
  drawWrapped(fmt::format("{}: {}", line.id, line.statement));
  if (!line.note.empty()) drawDim("Note: " + line.note);
  if (line.outcome == Outcome::kBlocked) {
    for (const CheckLine::Field& field : line.fields)
      drawDim(fmt::format("{} {}", field.name, field.value));
  } else if (!line.fields.empty()) {
    ImGui::SetNextItemOpen(open, ImGuiCond_Appearing);
    if (ImGui::TreeNodeEx("what was found", ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
      for (const CheckLine::Field& field : line.fields) drawField(field);
      drawCommand(line);
    }
  }
  ImGui::EndGroup();
  ImGui::PopID();
}

}  // namespace

FunctionDetails::FunctionDetails(HintSource hints) : source_(std::move(hints)) {}

void FunctionDetails::giveHint(CourseworkFunction function) {
  const auto [place, isNew] = given_.try_emplace(function);
  Given& given = place->second;
  if (isNew) given.hints = source_(function);
  given.shown = std::min(given.shown + 1, given.hints.size());
}

void FunctionDetails::drawButtons(const FunctionRow& row) {
  const auto given = given_.find(row.function.function);
  const bool isNew = given == given_.end();
  const bool more = isNew || given->second.shown < given->second.hints.size();
  ImGui::BeginDisabled(!more);
  if (ImGui::SmallButton(isNew ? "hint" : more ? "another hint" : "no more hints"))
    giveHint(row.function.function);
  ImGui::EndDisabled();
}

void FunctionDetails::drawHints(CourseworkFunction function) const {
  const auto given = given_.find(function);
  if (given == given_.end()) return;
  for (std::size_t k = 0; k < given->second.shown; ++k)
    drawWrapped(fmt::format("{}  {}", k + 1, given->second.hints[k]));
}

void FunctionDetails::draw(const FunctionRow& row, float scale) {
  ImGui::PushID(static_cast<int>(row.function.function));
  ImGui::Indent(12.0f * scale);
  drawButtons(row);
  drawHints(row.function.function);
  if (row.older) drawDim("Of an older version of your code:");
  if (row.verdict != nullptr) {
    const CheckLine* told = firstWrong(row.verdict);
    for (const CheckLine& line : row.verdict->checks) drawCheck(line, &line == told);
  }
  if (row.verdict == nullptr || row.verdict->checks.empty())
    drawDim(row.outcome == Outcome::kNotWritten
                ? "The task stands above the function; write it, take away the line "
                  "PATHMARK_UNIMPLEMENTED, and save."
                : "Not checked yet.");
  ImGui::Unindent(12.0f * scale);
  ImGui::Spacing();
  ImGui::PopID();
}

}  // namespace pathmark::preview
