#include "preview/paths/path_overlay.h"

#include "preview/paths/path_colour.h"
#include "preview/paths/path_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

constexpr ImU32 kShade = IM_COL32(0, 0, 0, 190);
constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kNormal = IM_COL32(140, 210, 255, 255);
constexpr ImU32 kLight = IM_COL32(255, 240, 170, 255);
constexpr ImU32 kBlocked = IM_COL32(255, 150, 60, 255);

constexpr float kDot = 5.0f, kArrow = 30.0f, kEscape = 90.0f, kReach = 10.0f;  // interface's units

ImU32 colourOf(const Colour& throughput, int alpha) {
  const Rgb8 c = colourAt(placeOfThroughput(luminance(throughput)));
  return IM_COL32(c.r, c.g, c.b, alpha);
}

void drawCross(ImDrawList& list, const ImVec2& p, float size, float thickness, ImU32 colour) {
  for (const auto& [shade, width] :
       {std::pair(kShade, 2.0f * thickness), std::pair(colour, thickness)}) {
    list.AddLine({p.x - size, p.y - size}, {p.x + size, p.y + size}, shade, width);
    list.AddLine({p.x - size, p.y + size}, {p.x + size, p.y - size}, shade, width);
  }
}

void drawDashes(ImDrawList& list, const ImVec2& from, const ImVec2& to, float dash, ImU32 colour,
                float thickness) {
  const float dx = to.x - from.x, dy = to.y - from.y;
  const float length = std::max(std::hypot(dx, dy), 1e-3f);
  const auto place = [&](float way) {
    const float share = std::min(way / length, 1.0f);
    return ImVec2(from.x + dx * share, from.y + dy * share);
  };
  const int dashes = static_cast<int>(length / (2.0f * dash)) + 1;
  for (int k = 0; k < dashes; ++k) {
    const float way = 2.0f * dash * static_cast<float>(k);
    list.AddLine(place(way), place(way + dash), colour, thickness);
  }
}

}  // namespace

PathOverlay::PathOverlay(const Frame& frame, const Placement& placement)
    : camera_(frame.picture->camera),
      placement_(placement),
      scale_(frame.scale),
      list_(*ImGui::GetWindowDrawList()) {}

void PathOverlay::draw(const PathAnswer& answer, const PathSelection& selection) const {
  list_.PushClipRect({placement_.left, placement_.top},
                     {placement_.x(camera_.width), placement_.y(camera_.height)}, true);
  for (std::size_t i = 0; selection.all && i < answer.paths.size(); ++i)
    if (static_cast<int>(i) != selection.path) drawPath(answer.paths[i], answer.accounts[i], false);
  if (selection.path >= 0 && selection.path < static_cast<int>(answer.paths.size())) {
    const auto i = static_cast<std::size_t>(selection.path);
    const TracedPath& path = answer.paths[i];
    for (const PathVertex& vertex : path.vertices) drawShadowRays(vertex);
    drawPath(path, answer.accounts[i], true);
    for (std::size_t k = path.vertices.size(); k-- > 0;)
      drawVertex(path, k, static_cast<int>(k) == selection.vertex);
  }
  list_.PopClipRect();
}

void PathOverlay::markPixel(int column, int row) const {
  const float margin = 2.0f * scale_;
  const ImVec2 low(placement_.x(column) - margin, placement_.y(row) - margin);
  const ImVec2 high(placement_.x(column + 1) + margin, placement_.y(row + 1) + margin);
  list_.AddRect(low, high, kShade, 0.0f, 0, 4.0f * scale_);
  list_.AddRect(low, high, kWhite, 0.0f, 0, 1.5f * scale_);
}

int PathOverlay::vertexAtMouse(const TracedPath& path) const {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  int nearest = -1;
  float best = kReach * scale_;
  for (std::size_t k = 0; k < path.vertices.size(); ++k)
    if (const auto p = at(glm::dvec3(path.vertices[k].p))) {
      const float distance = std::hypot(p->x - mouse.x, p->y - mouse.y);
      if (distance >= best) continue;
      best = distance;
      nearest = static_cast<int>(k);
    }
  return nearest;
}

void PathOverlay::drawPath(const TracedPath& path, const PathAccount& account, bool chosen) const {
  const int alpha = chosen ? 255 : 110;
  const float thickness = (chosen ? 3.0f : 1.0f) * scale_;
  for (std::size_t k = 0; k < path.vertices.size(); ++k) {
    const PathVertex& v = path.vertices[k];
    const glm::dvec3 from(v.origin), to(v.p);
    if (chosen) drawLine(from, to, kShade, thickness + 2.5f * scale_, Stroke::kWhole);
    drawLine(from, to, colourOf(account.vertices[k].throughput, alpha), thickness, Stroke::kWhole);
  }
  if (path.escape && chosen)
    drawArrow(glm::dvec3(path.escape->origin), glm::dvec3(path.escape->direction), kEscape, kWhite);
}

void PathOverlay::drawVertex(const TracedPath& path, std::size_t k, bool pointedAt) const {
  const PathVertex& vertex = path.vertices[k];
  drawArrow(glm::dvec3(vertex.p), glm::dvec3(vertex.n), kArrow, kNormal);
  const auto p = at(glm::dvec3(vertex.p));
  if (!p) return;
  const float radius = kDot * scale_ * (pointedAt ? 1.6f : 1.0f);
  list_.AddCircleFilled(*p, radius + 1.5f * scale_, kShade);
  list_.AddCircleFilled(*p, radius, pointedAt ? kLight : kWhite);
  const std::string number = fmt::format("{}", k + 1);
  const ImVec2 size = ImGui::CalcTextSize(number.c_str());
  const ImVec2 corner(p->x + radius + 3.0f * scale_, p->y - radius - size.y);
  list_.AddRectFilled({corner.x - 2.0f * scale_, corner.y},
                      {corner.x + size.x + 2.0f * scale_, corner.y + size.y}, kShade,
                      3.0f * scale_);
  list_.AddText(corner, kWhite, number.c_str());
}

void PathOverlay::drawShadowRays(const PathVertex& vertex) const {
  for (const ShadowRay& ray : vertex.shadowRays) {
    if (ray.pdf == 0.0f || !faceEachOther(vertex, ray)) continue;
    if (ray.visibility == Visibility::kLeftOut) continue;
    const glm::dvec3 from(vertex.p), to(ray.to);
    const bool blocked = ray.visibility == Visibility::kBlocked;
    const ImU32 colour = blocked ? kBlocked : kLight;
    drawLine(from, to, colour, 1.5f * scale_, Stroke::kDashed);
    const float size = 4.0f * scale_;
    if (const auto p = at(to)) {
      list_.AddQuadFilled({p->x - 1.5f * size, p->y}, {p->x, p->y - 1.5f * size},
                          {p->x + 1.5f * size, p->y}, {p->x, p->y + 1.5f * size}, kShade);
      list_.AddQuadFilled({p->x - size, p->y}, {p->x, p->y - size}, {p->x + size, p->y},
                          {p->x, p->y + size}, kLight);
    }
    if (!blocked) continue;
    if (const auto p = at(glm::dvec3(ray.blocker)))
      drawCross(list_, *p, size, 2.0f * scale_, kBlocked);
  }
}

void PathOverlay::drawLine(const glm::dvec3& from, const glm::dvec3& to, ImU32 colour,
                           float thickness, Stroke stroke) const {
  const auto projected = project(camera_, from, to);
  if (!projected) return;
  const auto seen = clip(*projected, camera_, 8.0);
  if (!seen) return;
  const ImVec2 a(placement_.x(seen->from.x), placement_.y(seen->from.y));
  const ImVec2 b(placement_.x(seen->to.x), placement_.y(seen->to.y));
  if (stroke == Stroke::kDashed)
    drawDashes(list_, a, b, 5.0f * scale_, colour, thickness);
  else
    list_.AddLine(a, b, colour, thickness);
}

// Of this length in the interface's units if it were seen from the side.
void PathOverlay::drawArrow(const glm::dvec3& from, const glm::dvec3& direction, float length,
                            ImU32 colour) const {
  const double size = pixelSizeAt(camera_, from) * static_cast<double>(length * scale_) /
                      static_cast<double>(placement_.zoom);
  const glm::dvec3 to = from + size * direction;
  const auto a = at(from), b = at(to);
  if (!a || !b) return;
  drawLine(from, to, kShade, 4.0f * scale_, Stroke::kWhole);
  drawLine(from, to, colour, 1.5f * scale_, Stroke::kWhole);
  const float dx = b->x - a->x, dy = b->y - a->y, seen = std::hypot(dx, dy);
  if (seen < 4.0f * scale_) return;
  const float head = 5.0f * scale_ / seen;
  for (const float side : {-0.6f, 0.6f})
    list_.AddLine(*b, {b->x - head * (dx + side * dy), b->y - head * (dy - side * dx)}, colour,
                  1.5f * scale_);
}

std::optional<ImVec2> PathOverlay::at(const glm::dvec3& point) const {
  const auto p = project(camera_, point);
  if (!p || !std::isfinite(p->x) || !std::isfinite(p->y)) return std::nullopt;
  return ImVec2(placement_.x(p->x), placement_.y(p->y));
}

}  // namespace pathmark::preview
