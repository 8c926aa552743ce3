#include "preview/samples/sketch_parts.h"

namespace pathmark::preview {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kCorners = 48;  // of a circle
constexpr int kMeridians = 12, kParallels = 6;

}  // namespace

Stroke circle(StrokeKind kind, const glm::dvec3& centre, const DirectionFrame& frame,
              double radius) {
  Stroke stroke{kind, {}};
  for (int k = 0; k <= kCorners; ++k)
    stroke.points.push_back(centre + radius * frame.direction(0.0, 2.0 * kPi * k / kCorners));
  return stroke;
}

void addWireSphere(Sketch& sketch, const glm::dvec3& centre, double radius,
                   const DirectionFrame& frame, bool half) {
  for (int ring = half ? kParallels / 2 : 1; ring < kParallels; ++ring) {
    const double height = -std::cos(kPi * ring / kParallels);
    const bool equator = 2 * ring == kParallels;
    sketch.strokes.push_back(circle(equator ? StrokeKind::kEdge : StrokeKind::kFaint,
                                    centre + radius * height * frame.n, frame,
                                    radius * std::sqrt(1.0 - height * height)));
  }
  for (int meridian = 0; meridian < kMeridians; ++meridian) {
    Stroke stroke{StrokeKind::kFaint, {}};
    const double from = half ? 0.5 * kPi : kPi;
    for (int k = 0; k <= kCorners / 2; ++k)
      stroke.points.push_back(centre + radius * frame.direction(std::cos(from * 2.0 * k / kCorners),
                                                                2.0 * kPi * meridian / kMeridians));
    sketch.strokes.push_back(std::move(stroke));
  }
}

void addArrow(Sketch& sketch, StrokeKind kind, const glm::dvec3& direction,
              const std::string& name) {
  sketch.strokes.push_back({kind, {glm::dvec3(0), direction}});
  sketch.captions.push_back({1.08 * direction, name});
}

void addNormal(Sketch& sketch, const glm::dvec3& normal) {
  addArrow(sketch, StrokeKind::kNormal, 1.15 * normal, "n");
  sketch.centre = 0.35 * normal;
}

void addAxes(Sketch& sketch, double length) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 end(0.0);
    end[axis] = length;
    sketch.strokes.push_back({StrokeKind::kFaint, {glm::dvec3(0), end}});
    sketch.captions.push_back({1.06 * end, std::string(1, "xyz"[axis])});
  }
}

}  // namespace pathmark::preview
