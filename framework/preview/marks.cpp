#include "preview/marks.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace pathmark::preview {

namespace {

constexpr ImU32 kDark = IM_COL32(20, 20, 22, 255);

// In units of the radius around the centre.
struct Pen {
  ImDrawList* list;
  ImVec2 centre;
  float radius;

  ImVec2 at(float x, float y) const { return {centre.x + x * radius, centre.y + y * radius}; }
  void stroke(std::initializer_list<ImVec2> points, ImU32 colour) const {
    for (const ImVec2& p : points) list->PathLineTo(at(p.x, p.y));
    list->PathStroke(colour, ImDrawFlags_None, 0.28f * radius);
  }
  void dot(float x, float y, float size, ImU32 colour) const {
    list->AddCircleFilled(at(x, y), size * radius, colour);
  }
  void ring(ImU32 colour) const {
    list->AddCircle(centre, 0.85f * radius, colour, 0, 0.22f * radius);
  }
};

void drawQuestion(const Pen& pen, ImU32 colour) {
  pen.list->PathArcTo(pen.at(0.0f, -0.22f), 0.3f * pen.radius, std::numbers::pi_v<float>,
                      2.5f * std::numbers::pi_v<float>);
  pen.list->PathLineTo(pen.at(0.0f, 0.28f));
  pen.list->PathStroke(colour, ImDrawFlags_None, 0.22f * pen.radius);
  pen.dot(0.0f, 0.56f, 0.14f, colour);
}

void drawTriangle(const Pen& pen, ImU32 colour) {
  pen.list->AddTriangleFilled(pen.at(0.0f, -1.0f), pen.at(1.05f, 0.9f), pen.at(-1.05f, 0.9f),
                              colour);
  pen.stroke({{0.0f, -0.4f}, {0.0f, 0.3f}}, kDark);
  pen.dot(0.0f, 0.6f, 0.16f, kDark);
}

}  // namespace

// Of the palette of Okabe & Ito, "Color Universal Design", 2008.
ImU32 colourOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPass:
      return IM_COL32(86, 180, 233, 255);
    case Outcome::kFail:
    case Outcome::kBroken:
      return IM_COL32(230, 159, 0, 255);
    case Outcome::kUndecided:
      return IM_COL32(240, 228, 66, 255);
    case Outcome::kNotWritten:
    case Outcome::kBlocked:
    case Outcome::kUnknown:
      break;
  }
  return IM_COL32(150, 150, 156, 255);
}

void drawMark(ImVec2 centre, float radius, Outcome outcome) {
  const Pen pen{ImGui::GetWindowDrawList(), centre, radius};
  const ImU32 colour = ImGui::GetColorU32(colourOf(outcome));
  switch (outcome) {
    case Outcome::kPass:
      pen.dot(0.0f, 0.0f, 1.0f, colour);
      return pen.stroke({{-0.45f, 0.02f}, {-0.12f, 0.38f}, {0.48f, -0.36f}}, kDark);
    case Outcome::kFail:
      pen.list->AddRectFilled(pen.at(-0.9f, -0.9f), pen.at(0.9f, 0.9f), colour, 0.2f * radius);
      pen.stroke({{-0.42f, -0.42f}, {0.42f, 0.42f}}, kDark);
      return pen.stroke({{-0.42f, 0.42f}, {0.42f, -0.42f}}, kDark);
    case Outcome::kBroken:
      return drawTriangle(pen, colour);
    case Outcome::kUndecided:
      return drawQuestion(pen, colour);
    case Outcome::kBlocked:
      pen.ring(colour);
      return pen.stroke({{-0.55f, 0.55f}, {0.55f, -0.55f}}, colour);
    case Outcome::kNotWritten:
      return pen.ring(colour);
    case Outcome::kUnknown:
      break;
  }
  for (const float x : {-0.6f, 0.0f, 0.6f}) pen.dot(x, 0.0f, 0.16f, colour);
}

}  // namespace pathmark::preview
