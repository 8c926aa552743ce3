// sameCamera: whether pictures show a scene from the same place, in the same size.
#pragma once

#include "scene/flat_scene.h"

namespace pathmark::preview {

inline bool sameCamera(const FlatCamera& a, const FlatCamera& b) {
  return a.eye == b.eye && a.topLeft == b.topLeft && a.pixelRight == b.pixelRight &&
         a.pixelDown == b.pixelDown && a.width == b.width && a.height == b.height;
}

}  // namespace pathmark::preview
