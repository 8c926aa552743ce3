// Text of panels that breaks at the panel's edge.
#pragma once

#include <imgui.h>

#include <string_view>

namespace pathmark::preview {

inline void drawWrapped(std::string_view text) {
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
}

inline void drawDim(std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  drawWrapped(text);
  ImGui::PopStyleColor();
}

}  // namespace pathmark::preview
