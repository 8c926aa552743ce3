// RowText: a function's line in the progress panel: mark, section, name, and what is known of it.
#pragma once

#include "preview/progress/progress_model.h"

#include <imgui.h>

#include <string>

namespace pathmark::preview {

class RowText {
 public:
  // For the width that the current window has left.
  explicit RowText(const FunctionRow& row);

  float height(float scale) const;
  void draw(ImVec2 corner, float scale) const;

 private:
  const FunctionRow& row_;
  std::string name_, word_, blocker_;
  float size_, width_, inset_;
  bool wordFits_;  // beside the name; else it stands below
};

}  // namespace pathmark::preview
