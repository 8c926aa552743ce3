#include "preview/samples/sample_scene.h"

#include "preview/panel_colours.h"

#include <fmt/format.h>
// For SetItemUsingMouseWheel, without which the wheel would scroll the panel as well.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pathmark::preview {

namespace {

constexpr std::size_t kNothing = static_cast<std::size_t>(-1);

// Of the item on the screen.
struct View {
  ImVec2 corner, size;
  const Orbit& orbit;
  float scale;

  // Side of the square in the corner.
  float inset() const { return std::clamp(0.26f * size.x, 64.0f * scale, 110.0f * scale); }

  struct Spot {
    ImVec2 at;
    float depth;  // 1 in front, -1 behind
  };
  Spot spot(const glm::dvec3& point) const {
    const glm::dvec3 p = orbit.project(point);
    const float half = 0.5f * std::min(size.x, size.y);
    return {{corner.x + std::max(0.5f * (size.x - inset()), half) + static_cast<float>(p.x) * half,
             corner.y + 0.5f * size.y - static_cast<float>(p.y) * half},
            static_cast<float>(std::clamp(p.z, -1.0, 1.0))};
  }
};

// Of what is at this depth; what is in the middle is nearly as bright as what is in front.
float brightness(float depth, float behind) {
  return behind + (1.0f - behind) * std::clamp((depth + 0.9f) / 1.1f, 0.0f, 1.0f);
}

ImU32 colourOf(StrokeKind kind) {
  switch (kind) {
    case StrokeKind::kEdge:
      return IM_COL32(200, 204, 214, 200);
    case StrokeKind::kNormal:
      return IM_COL32(240, 240, 240, 255);
    case StrokeKind::kOutgoing:
      return IM_COL32(120, 190, 255, 255);
    case StrokeKind::kMirror:
      return IM_COL32(255, 190, 110, 255);
    default:
      return IM_COL32(150, 155, 170, 95);
  }
}

void drawArrow(ImDrawList& list, const View& view, const Stroke& stroke) {
  const ImVec2 from = view.spot(stroke.points.front()).at, to = view.spot(stroke.points.back()).at;
  const ImU32 colour = colourOf(stroke.kind);
  list.AddLine(from, to, colour, 2.0f * view.scale);
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 1.0f) return;
  const float head = 9.0f * view.scale, x = dx / length * head, y = dy / length * head;
  list.AddTriangleFilled(to, {to.x - x - 0.4f * y, to.y - y + 0.4f * x},
                         {to.x - x + 0.4f * y, to.y - y - 0.4f * x}, colour);
}

// What is behind is dimmer, line by line.
void drawStroke(ImDrawList& list, const View& view, const Stroke& stroke) {
  if (stroke.kind != StrokeKind::kEdge && stroke.kind != StrokeKind::kFaint)
    return drawArrow(list, view, stroke);
  const float width = (stroke.kind == StrokeKind::kEdge ? 1.5f : 1.0f) * view.scale;
  for (std::size_t k = 1; k < stroke.points.size(); ++k) {
    const View::Spot a = view.spot(stroke.points[k - 1]), b = view.spot(stroke.points[k]);
    list.AddLine(a.at, b.at,
                 faded(colourOf(stroke.kind), brightness(0.5f * (a.depth + b.depth), 0.25f)),
                 width);
  }
}

void drawSketch(ImDrawList& list, const View& view, const Sketch& sketch) {
  for (const Stroke& stroke : sketch.strokes) drawStroke(list, view, stroke);
  for (const Caption& caption : sketch.captions) {
    const View::Spot spot = view.spot(caption.at);
    list.AddText(spot.at, faded(kTextColour, brightness(spot.depth, 0.4f)), caption.text.c_str());
  }
}

void drawCross(ImDrawList& list, ImVec2 at, float size, ImU32 colour, float width) {
  list.AddLine({at.x - size, at.y - size}, {at.x + size, at.y + size}, colour, width);
  list.AddLine({at.x - size, at.y + size}, {at.x + size, at.y - size}, colour, width);
}

float dotSize(std::size_t samples, float scale) {
  return (samples > 2000 ? 1.3f : samples > 600 ? 1.8f : 2.5f) * scale;
}

// From the back to the front.
std::vector<View::Spot> drawSamples(ImDrawList& list, const View& view, const SampleSet& set,
                                    const SampleColours& colours, std::size_t shown) {
  std::vector<View::Spot> spots;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool somewhere = set.samples[i].kind != SampleKind::kNoNumber;
    spots.push_back(somewhere ? view.spot(set.samples[i].shown) : View::Spot{{-1e6f, -1e6f}, -1});
  }
  std::vector<std::size_t> order(shown);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return spots[a].depth < spots[b].depth; });
  const float size = dotSize(set.samples.size(), view.scale);
  for (const std::size_t i : order) {
    const View::Spot& spot = spots[i];
    const float light = brightness(spot.depth, 0.25f), nearer = 1.0f + 0.25f * spot.depth;
    if (set.samples[i].kind == SampleKind::kAstray)
      drawCross(list, spot.at, 2.0f * size, faded(kBadColour, light), 1.5f * view.scale);
    else if (set.samples[i].kind == SampleKind::kGood)
      list.AddCircleFilled(spot.at, size * nearer, rampColour(colours.places[i], light), 8);
  }
  return spots;
}

std::size_t nearestTo(ImVec2 mouse, const std::vector<View::Spot>& spots, float reach) {
  std::size_t nearest = kNothing;
  float best = reach * reach;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const float dx = spots[i].at.x - mouse.x, dy = spots[i].at.y - mouse.y;
    // Of two at the same place the one in front.
    const float distance = dx * dx + dy * dy - 2.0f * spots[i].depth;
    if (distance >= best) continue;
    best = distance;
    nearest = i;
  }
  return nearest;
}

void tell(const SampleSet& set, std::size_t i) {
  const Sample& s = set.samples[i];
  std::string text = fmt::format("number {} of {}\n", i + 1, set.samples.size());
  if (set.settings.function != CourseworkFunction::kGetRandomNumbers)
    text += fmt::format("s = {:.4f}, t = {:.4f}\n", s.numbers.s, s.numbers.t);
  if (canShow(Colouring::kThirdNumber, set)) text += fmt::format("u = {:.4f}\n", s.numbers.u);
  text += fmt::format("at ({:.4g}, {:.4g}, {:.4g})\n", s.place.x, s.place.y, s.place.z);
  if (set.claims) text += fmt::format("density claimed {:.5g}, ", s.claimed);
  text += fmt::format("expected {:.5g}", s.expected);
  ImGui::SetTooltip("%s", text.c_str());
}

// The points that went in, in the corner, in the same colours.
void drawInputs(ImDrawList& list, const View& view, const SampleSet& set,
                const SampleColours& colours, std::size_t shown, std::size_t chosen) {
  if (!canShow(Colouring::kFirstNumber, set)) return;
  const float side = view.inset(), gap = 6.0f * view.scale;
  const ImVec2 low{view.corner.x + view.size.x - side - gap, view.corner.y + side + gap};
  list.AddRectFilled({low.x, low.y - side}, {low.x + side, low.y}, IM_COL32(12, 12, 14, 215));
  list.AddRect({low.x, low.y - side}, {low.x + side, low.y}, IM_COL32(150, 155, 170, 130));
  const float size = 0.6f * dotSize(set.samples.size(), view.scale);
  const auto place = [&](const CallNumbers& x) {
    return ImVec2{low.x + x.s * side, low.y - x.t * side};
  };
  for (std::size_t i = 0; i < shown; ++i)
    list.AddCircleFilled(place(set.samples[i].numbers), size, rampColour(colours.places[i], 1.0f),
                         6);
  if (chosen != kNothing)
    list.AddCircle(place(set.samples[chosen].numbers), 4.0f * view.scale, kTextColour, 0,
                   1.5f * view.scale);
  list.AddText({low.x, low.y + 1.0f}, kNeutralColour, "s, t");
}

}  // namespace

void SampleScene::control(const SampleSet& set, float height) {
  if (!orbit_ || function_ != set.settings.function) orbit_ = Orbit(set.sketch);
  function_ = set.settings.function;
  orbit_->lookAt(set.sketch);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0f))
    orbit_->drag({static_cast<double>(io.MouseDelta.x / height),
                  static_cast<double>(io.MouseDelta.y / height)});
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetItemUsingMouseWheel();
  if (io.MouseWheel != 0.0f) orbit_->zoom(static_cast<double>(io.MouseWheel));
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) orbit_ = Orbit(set.sketch);
}

void SampleScene::draw(const SampleSet& set, const Look& look) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("samples", look.size);
  control(set, look.size.y);
  const bool hovered = ImGui::IsItemHovered() && !ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + look.size.x, corner.y + look.size.y};
  const View view{corner, look.size, *orbit_, look.scale};
  const SampleColours colours = sampleColours(look.colouring, set);
  list.PushClipRect(corner, end, true);
  list.AddRectFilled(corner, end, kPaper);
  drawSketch(list, view, set.sketch);
  const auto spots = drawSamples(list, view, set, colours, look.shown);
  std::size_t chosen =
      hovered ? nearestTo(ImGui::GetIO().MousePos, spots, 8.0f * look.scale) : kNothing;
  if (chosen != kNothing) tell(set, chosen);
  // The one that has come last, while they appear one by one.
  else if (look.shown > 0 && look.shown < set.samples.size())
    chosen = look.shown - 1;
  if (chosen != kNothing)
    list.AddCircle(spots[chosen].at, 6.0f * look.scale, kTextColour, 0, 1.5f * look.scale);
  drawInputs(list, view, set, colours, look.shown, chosen);
  list.PopClipRect();
}

}  // namespace pathmark::preview
