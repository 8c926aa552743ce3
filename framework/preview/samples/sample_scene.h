// SampleScene: samples in their domain, in a view that can be turned.
#pragma once

#include "preview/samples/orbit.h"
#include "preview/samples/sample_colouring.h"
#include "preview/samples/sample_set.h"

#include <imgui.h>

#include <optional>

namespace pathmark::preview {

class SampleScene {
 public:
  struct Look {
    Colouring colouring = Colouring::kOrder;
    std::size_t shown = 0;  // of the samples, the first so many
    float scale = 1.0f;     // of the interface
    ImVec2 size;
  };

  // As the next item of the window. Drags turn it, the wheel zooms, a double click brings it back.
  void draw(const SampleSet& set, const Look& look);

 private:
  void control(const SampleSet& set, float height);

  CourseworkFunction function_ = CourseworkFunction::kRayTriangleIntersection;
  std::optional<Orbit> orbit_;
};

}  // namespace pathmark::preview
