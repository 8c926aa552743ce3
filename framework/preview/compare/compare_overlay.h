// What lies over the picture while it is compared.
#pragma once

#include "preview/compare/compare_session.h"
#include "preview/frame.h"

namespace pathmark::preview {

struct CompareOverlay {
  const Frame& frame;  // with a picture
  const Placement& placement;
  View view = View::kPicture;             // that is seen
  const CompareResult* result = nullptr;  // may be null
};

// The slider's line, which can be dragged and then changes `slider`; labels; the numbers of the
// tile or the pixel under the mouse, in views of numbers; the worst tile, if the verdict names one.
void drawCompareOverlay(const CompareOverlay& overlay, float& slider);

}  // namespace pathmark::preview
