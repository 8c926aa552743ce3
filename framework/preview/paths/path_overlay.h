// PathOverlay: draws paths over the picture, as the picture's camera sees them.
#pragma once

#include "preview/frame.h"
#include "preview/paths/path_engine.h"

#include <imgui.h>

namespace pathmark::preview {

// What is seen of an answer.
struct PathSelection {
  int path = -1;    // chosen; its number in the answer, or -1
  int vertex = -1;  // pointed at, of the chosen path, or -1
  bool all = true;  // the others too
};

class PathOverlay {
 public:
  PathOverlay(const Frame& frame, const Placement& placement);

  // All paths thin, the chosen one with all that is known of it.
  void draw(const PathAnswer& answer, const PathSelection& selection) const;

  // A mark on the pixel, whose camera is the picture's.
  void markPixel(int column, int row) const;

  // The vertex of the path at the mouse; -1 if there is none.
  int vertexAtMouse(const TracedPath& path) const;

 private:
  enum class Stroke { kWhole, kDashed };

  void drawPath(const TracedPath& path, const PathAccount& account, bool chosen) const;
  void drawVertex(const TracedPath& path, std::size_t k, bool pointedAt) const;
  void drawShadowRays(const PathVertex& vertex) const;
  void drawLine(const glm::dvec3& from, const glm::dvec3& to, ImU32 colour, float thickness,
                Stroke stroke) const;
  void drawArrow(const glm::dvec3& from, const glm::dvec3& direction, float length,
                 ImU32 colour) const;
  std::optional<ImVec2> at(const glm::dvec3& point) const;

  const FlatCamera& camera_;
  const Placement& placement_;
  float scale_;
  ImDrawList& list_;
};

}  // namespace pathmark::preview
