#include "preview/panel_text.h"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace pathmark::preview {

namespace {

float widthOf(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

std::string brokenAtSpaces(std::string_view text, float width) {
  std::string broken;
  std::size_t lineStart = 0;  // in `broken`
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const std::size_t before = broken.size();
    if (before > lineStart) broken += ' ';
    broken += word;
    if (before > lineStart && widthOf(std::string_view(broken).substr(lineStart)) > width) {
      broken[before] = '\n';
      lineStart = before + 1;
    }
    if (end < text.size() && text[end] == '\n') {
      broken += '\n';
      lineStart = broken.size();
    }
    at = end + 1;
  }
  return broken;
}

}  // namespace

// A word that is wider than the panel is still broken by Dear ImGui, which must not break again
// where a line is as wide as the panel.
void drawWrapped(std::string_view text) {
  const std::string broken = brokenAtSpaces(text, ImGui::GetContentRegionAvail().x - 1.0f);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(broken.data(), broken.data() + broken.size());
  ImGui::PopTextWrapPos();
}

void drawDim(std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  drawWrapped(text);
  ImGui::PopStyleColor();
}

}  // namespace pathmark::preview
