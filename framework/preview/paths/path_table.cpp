#include "preview/paths/path_table.h"

#include "preview/paths/path_colour.h"
#include "preview/paths/path_remarks.h"
#include "preview/paths/path_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace pathmark::preview {

namespace {

constexpr ImU32 kBar = IM_COL32(86, 140, 200, 110);
constexpr ImU32 kPointedAt = IM_COL32(120, 110, 60, 255);

void text(const std::string& words) { ImGui::TextUnformatted(words.c_str()); }

void cell(const std::string& words) {
  ImGui::TableNextColumn();
  text(words);
}

void colourCell(const Colour& c) { cell(shortNumber(luminance(c))); }

double brightest(const PathAnswer& answer) {
  double most = 0.0;
  for (const TracedPath& path : answer.paths) most = std::max(most, luminance(path.radiance));
  return most;
}

// The radiance as a bar behind the row: one path that outshines all others is seen at once.
void radianceBar(double share) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const auto part = static_cast<float>(std::clamp(share, 0.0, 1.0));
  ImGui::GetWindowDrawList()->AddRectFilled(
      corner, {corner.x + part * width, corner.y + ImGui::GetTextLineHeight()}, kBar);
}

void vertexRow(const TracedPath& path, const PathAccount& account, std::size_t k,
               const LoadedScene& scene) {
  const PathVertex& vertex = path.vertices[k];
  const VertexAccount& v = account.vertices[k];
  cell(surfaceName(vertex, scene));
  colourCell(v.throughput);
  if (vertex.direct)
    cell(shortNumber(luminance(*vertex.direct)) + (v.directFits ? "" : " !"));
  else if (v.found)
    cell(shortNumber(luminance(*v.found)));
  else
    ImGui::TableNextColumn();
  if (!vertex.next) {
    for (int column = 0; column < 4; ++column) ImGui::TableNextColumn();
    return;
  }
  cell(vertex.next->f ? shortNumber(luminance(*vertex.next->f)) : "");
  cell(shortNumber(static_cast<double>(vertex.next->cosine)));
  cell(shortNumber(static_cast<double>(vertex.next->pdf)) + (v.stepFits ? "" : " !"));
  if (!vertex.roulette)
    ImGui::TableNextColumn();
  else
    cell(vertex.roulette->survives
             ? "\u00d7" + shortNumber(static_cast<double>(vertex.roulette->weight))
             : "ends");
}

}  // namespace

int pathList(const PathAnswer& answer, std::span<const int> order, int chosen, float scale) {
  constexpr int kRows = 7;
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                     ImGuiTableFlags_BordersOuter |
                                     ImGuiTableFlags_SizingStretchProp;
  const float height = ImGui::GetTextLineHeightWithSpacing() * (kRows + 1) + 4.0f * scale;
  if (!ImGui::BeginTable("paths", 4, kFlags, {0.0f, height})) return chosen;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("path", ImGuiTableColumnFlags_None, 1.0f);
  ImGui::TableSetupColumn("radiance", ImGuiTableColumnFlags_None, 2.4f);
  ImGui::TableSetupColumn("vertices", ImGuiTableColumnFlags_None, 1.2f);
  ImGui::TableSetupColumn("ends by", ImGuiTableColumnFlags_None, 1.8f);
  ImGui::TableHeadersRow();
  const double most = brightest(answer);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(order.size()));
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const int number = order[static_cast<std::size_t>(row)];
      const TracedPath& path = answer.paths[static_cast<std::size_t>(number)];
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      const bool fits = answer.accounts[static_cast<std::size_t>(number)].remarks.empty();
      if (ImGui::Selectable(fmt::format("{}{}", number, fits ? "" : " !").c_str(), number == chosen,
                            ImGuiSelectableFlags_SpanAllColumns))
        chosen = number;
      ImGui::TableNextColumn();
      if (most > 0.0) radianceBar(luminance(path.radiance) / most);
      text(shortNumber(luminance(path.radiance)));
      cell(fmt::format("{}", path.vertices.size()));
      cell(endOf(path));
    }
  ImGui::EndTable();
  return chosen;
}

int vertexTable(const PathAnswer& answer, int number, int pointedAt, float scale) {
  const auto i = static_cast<std::size_t>(number);
  const TracedPath& path = answer.paths[i];
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter |
                                     ImGuiTableFlags_SizingFixedFit;
  constexpr std::size_t kMostRows = 9;
  const auto rows = static_cast<float>(std::min(path.vertices.size(), kMostRows) + 1);
  const float height = ImGui::GetTextLineHeightWithSpacing() * (rows + 0.3f) +
                       ImGui::GetStyle().ScrollbarSize + 2.0f * scale;
  if (!ImGui::BeginTable("vertices", 8, kFlags, {0.0f, height})) return -1;
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const char* name : {"", "on", "throughput", "direct", "f", "cos", "pdf", "roulette"})
    ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  int hovered = -1;
  for (std::size_t k = 0; k < path.vertices.size(); ++k) {
    ImGui::TableNextRow();
    if (static_cast<int>(k) == pointedAt)
      ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, kPointedAt);
    ImGui::TableNextColumn();
    ImGui::Selectable(fmt::format("{}", k + 1).c_str(), false, ImGuiSelectableFlags_SpanAllColumns);
    if (ImGui::IsItemHovered()) hovered = static_cast<int>(k);
    vertexRow(path, answer.accounts[i], k, answer.request.scene->loaded);
  }
  ImGui::EndTable();
  return hovered;
}

void describeVertexHere(const PathAnswer& answer, int path, int vertex, float width) {
  const auto i = static_cast<std::size_t>(path);
  const auto lines = describeVertex(answer.paths[i], answer.accounts[i],
                                    static_cast<std::size_t>(vertex), answer.request.scene->loaded);
  for (const std::string& line : lines) wrappedText(line, width);
}

void wrappedText(const std::string& sentence, float width) {
  std::string line;
  for (std::size_t at = 0; at < sentence.size();) {
    const std::size_t end = std::min(sentence.find(' ', at + 1), sentence.size());
    const std::string longer = line + sentence.substr(at, end - at);
    if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > width) {
      text(line);
      line = sentence.substr(at + 1, end - at - 1);
    } else {
      line = longer;
    }
    at = end;
  }
  text(line);
}

void throughputBar(float scale) {
  constexpr int kSteps = 48;
  const float height = 8.0f * scale, width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  for (int k = 0; k < kSteps; ++k) {
    const Rgb8 c = colourAt((k + 0.5) / kSteps);
    const auto x = [&](int step) { return corner.x + width * static_cast<float>(step) / kSteps; };
    ImGui::GetWindowDrawList()->AddRectFilled({x(k), corner.y}, {x(k + 1), corner.y + height},
                                              IM_COL32(c.r, c.g, c.b, 255));
  }
  ImGui::Dummy({width, height});
  const float left = ImGui::GetCursorPosX();
  const auto label = [&](const std::string& words, float place) {
    const float room = width - ImGui::CalcTextSize(words.c_str()).x;
    ImGui::SameLine(left + place * std::max(room, 0.0f));
    text(words);
  };
  ImGui::NewLine();
  label(shortNumber(kDarkestThroughput), 0.0f);
  label("throughput", 0.5f);
  label(shortNumber(kBrightestThroughput) + " and more", 1.0f);
}

}  // namespace pathmark::preview
