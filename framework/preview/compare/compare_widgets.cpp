#include "preview/compare/compare_widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark::preview {

namespace {

const ImVec4 kBlue{0.45f, 0.70f, 1.00f, 1.0f}, kOrange{1.00f, 0.65f, 0.20f, 1.0f},
    kGrey{0.70f, 0.70f, 0.70f, 1.0f};

// Line by line, broken at spaces only: Dear ImGui's own wrapping would break numbers at their
// point.
void wrapped(const std::string& text) {
  const float width = ImGui::GetContentRegionAvail().x;
  std::string line;
  const auto put = [&] {
    ImGui::TextUnformatted(line.c_str());
    line.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > width) {
      put();
      line = word;
    } else {
      line = longer;
    }
    if (end < text.size() && text[end] == '\n') put();
    at = end + 1;
  }
  if (!line.empty()) put();
}

void wrappedDim(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  wrapped(text);
  ImGui::PopStyleColor();
}

std::string withoutLastBreak(std::string text) {
  if (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

const char* meaningOf(View view) {
  switch (view) {
    case View::kError:
      return "Yours minus the reference, of the channel that differs most";
    case View::kScores:
      return "Difference of each tile, in standard errors; what noise can hardly explain has full "
             "colour";
    default:
      return "Standard error of each pixel, relative to its value";
  }
}

std::string numberAt(const FalseColours& colours, double place) {
  const double value = colours.scale.valueAt(place);
  if (colours.view == View::kNoise) return fmt::format("{:.2g} %", 100.0 * value);
  return value == 0.0 ? "0" : fmt::format("{:+.2g}", value);
}

void row(const char* name, const std::array<std::string, 3>& cells) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  for (const std::string& cell : cells) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(cell.c_str());
  }
}

// In percent of the reference; a dash where that is black.
std::string inPercent(const RegionResult& channel, double value) {
  return channel.b > 0.0 ? fmt::format("{:.2g}", 100.0 * value / channel.b) : "-";
}

}  // namespace

void drawViewChoice(View& view, bool hasReference) {
  constexpr const char* kNames[] = {"picture", "reference",  "slider",
                                    "error",   "z of tiles", "noise"};
  if (!ImGui::BeginTable("views", 3)) return;
  for (int k = 0; k < 6; ++k) {
    const auto choice = static_cast<View>(k);
    ImGui::TableNextColumn();
    // What is chosen stays so while the reference is away.
    ImGui::BeginDisabled(needsReference(choice) && !hasReference && view != choice);
    if (ImGui::RadioButton(kNames[k], view == choice)) view = choice;
    ImGui::EndDisabled();
  }
  ImGui::EndTable();
}

void drawColourBar(View view, const CompareResult* result, float scale) {
  if (result == nullptr || result->view != view) return ImGui::TextDisabled("...");
  const FalseColours& colours = result->colours;
  if (colours.view != view) return wrappedDim(result->whyNoColours);
  wrappedDim(meaningOf(view));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = 14.0f * scale;
  const float font = ImGui::GetFontSize();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int kSteps = 64;
  for (int k = 0; k < kSteps; ++k) {
    const auto c = colours.scale.colour(colours.scale.valueAt((k + 0.5) / kSteps));
    const float left = corner.x + width * static_cast<float>(k) / kSteps;
    const float right = corner.x + width * static_cast<float>(k + 1) / kSteps;
    list.AddRectFilled({left, corner.y}, {right, corner.y + height},
                       IM_COL32(c[0], c[1], c[2], 255));
  }
  constexpr int kNumbers = 4;
  for (int k = 0; k <= kNumbers; ++k) {
    const double place = static_cast<double>(k) / kNumbers;
    const std::string text = numberAt(colours, place);
    const float textWidth = ImGui::CalcTextSize(text.c_str()).x;
    const auto share = static_cast<float>(place);
    list.AddText({corner.x + share * (width - textWidth), corner.y + height + 2.0f * scale},
                 ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  }
  ImGui::Dummy({width, height + 2.0f * scale + font});
  if (colours.scale.isSigned)
    wrappedDim("Red: yours is brighter. Blue: yours is darker. Magenta: no valid value.");
}

void drawFound(const FoundReference& found) {
  if (!found.reference) return wrapped(found.why);
  wrappedDim("Compared with " + found.reference->name + ".");
  if (!found.note.empty()) wrappedDim(found.note);
}

// A mark and a word beside the colour.
void drawVerdict(const CompareResult& result, float scale) {
  const Verdict& verdict = result.verdict;
  const bool differs = verdict.judgement == Judgement::kDiffers;
  const bool same = verdict.judgement == Judgement::kSame;
  const ImVec4& colour = differs ? kOrange : same ? kBlue : kGrey;
  ImGui::Dummy({0.0f, 2.0f * scale});
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  wrapped((differs ? "!  " : same ? "=  " : "...  ") + verdict.headline);
  ImGui::PopStyleColor();
  if (!verdict.detail.empty()) wrapped(withoutLastBreak(verdict.detail));
  if (!differs && !same) return;
  const std::string next = same ? fmt::format(", next at {:.4g}", result.nextLook) : "";
  wrappedDim(
      fmt::format("Judged whenever the rays have doubled: here at {:.4g} rays per pixel{}. "
                  "Noise alone makes at most 1 of {:.0f} correct series differ.",
                  verdict.raysPerPixel, next, 1.0 / kAlpha));
}

void drawNumbers(const CompareResult& result) {
  const std::vector<RegionResult>& whole = result.comparison->whole;
  if (whole.size() == 3 && ImGui::BeginTable("means", 4)) {
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
    std::array<std::string, 3> yours, reference, difference, error;
    for (std::size_t c = 0; c < 3; ++c) {
      yours[c] = fmt::format("{:.4g}", whole[c].a);
      reference[c] = fmt::format("{:.4g}", whole[c].b);
      difference[c] = inPercent(whole[c], whole[c].a - whole[c].b);
      error[c] = inPercent(whole[c], std::hypot(whole[c].errorA, whole[c].errorB));
    }
    row("mean", {"red", "green", "blue"});
    row("yours", yours);
    row("reference", reference);
    row("difference %", difference);
    if (result.noiseKnown) row("\u00b1 %", error);
    ImGui::EndTable();
  }
  const std::vector<ErrorPoint>& points = result.curves.current().points;
  std::string text =
      fmt::format("Relative mean squared error {:.3g}", result.comparison->relativeMse);
  if (!points.empty() && points.back().measured && points.back().expected)
    text += fmt::format(", from noise alone about {:.3g}",
                        *points.back().expected + result.referenceNoise.value_or(0.0));
  wrapped(text + ".");
}

}  // namespace pathmark::preview
