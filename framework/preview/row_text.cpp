#include "preview/row_text.h"

#include "preview/marks.h"

#include <fmt/format.h>

namespace pathmark::preview {

namespace {

constexpr float kSpacing = 4.0f;

float widthOf(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

}  // namespace

RowText::RowText(const FunctionRow& row)
    : row_(row),
      name_(fmt::format("{}  {}", row.function.section, row.function.name)),
      word_(fmt::format("{}{}", wordOf(row.outcome), row.older ? " (before)" : "")),
      size_(ImGui::GetFontSize()),
      width_(ImGui::GetContentRegionAvail().x),
      inset_(1.6f * size_),
      wordFits_(inset_ + widthOf(name_) + size_ + widthOf(word_) < width_) {
  if (row.outcome == Outcome::kBlocked && row.verdict != nullptr) blocker_ = row.verdict->blocker;
}

float RowText::height(float scale) const {
  const float wrap = width_ - inset_;
  const float below =
      blocker_.empty() ? 0.0f : ImGui::CalcTextSize(blocker_.c_str(), nullptr, false, wrap).y;
  return (wordFits_ ? 1.0f : 2.0f) * size_ + below + kSpacing * scale;
}

void RowText::draw(ImVec2 corner, float scale) const {
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, row_.older ? 0.5f : 1.0f);
  ImDrawList* list = ImGui::GetWindowDrawList();
  float top = corner.y + 0.5f * kSpacing * scale;
  drawMark({corner.x + 0.6f * size_, top + 0.5f * size_}, 0.4f * size_, row_.outcome);
  list->AddText({corner.x + inset_, top}, ImGui::GetColorU32(ImGuiCol_Text), name_.c_str());
  if (!wordFits_) top += size_;
  const float left = wordFits_ ? corner.x + width_ - widthOf(word_) : corner.x + inset_;
  list->AddText({left, top}, ImGui::GetColorU32(colourOf(row_.outcome)), word_.c_str());
  top += size_;
  if (!blocker_.empty())
    list->AddText(ImGui::GetFont(), size_, {corner.x + inset_, top},
                  ImGui::GetColorU32(ImGuiCol_TextDisabled), blocker_.c_str(), nullptr,
                  width_ - inset_);
  ImGui::PopStyleVar();
}

}  // namespace pathmark::preview
