// Text of panels that breaks at the panel's edge.
#pragma once

#include <string_view>

namespace pathmark::preview {

// Breaks at spaces: Dear ImGui by itself would also break numbers and file names at their point.
void drawWrapped(std::string_view text);

// The same, for what is said by the way.
void drawDim(std::string_view text);

}  // namespace pathmark::preview
