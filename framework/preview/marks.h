// Marks of outcomes: a shape and a colour each, that differ for those who see few colours too.
#pragma once

#include "preview/checker.h"

#include <imgui.h>

namespace pathmark::preview {

ImU32 colourOf(Outcome outcome);

// Around the centre, in the current window.
void drawMark(ImVec2 centre, float radius, Outcome outcome);

}  // namespace pathmark::preview
