// Colours of the sample view; those of marks.h for what is right and wrong.
#pragma once

#include <imgui.h>

namespace pathmark::preview {

inline constexpr ImU32 kPaper = IM_COL32(24, 25, 29, 255);
inline constexpr ImU32 kGoodColour = IM_COL32(86, 180, 233, 255);
inline constexpr ImU32 kBadColour = IM_COL32(230, 159, 0, 255);
inline constexpr ImU32 kNeutralColour = IM_COL32(165, 168, 176, 255);
inline constexpr ImU32 kTextColour = IM_COL32(225, 227, 232, 255);

// From dark blue to light yellow, ever lighter. place in [0,1], alpha in [0,1].
ImU32 rampColour(float place, float alpha);

inline ImU32 faded(ImU32 colour, float alpha) {
  const float old = static_cast<float>(colour >> IM_COL32_A_SHIFT) * alpha;
  return (colour & ~IM_COL32_A_MASK) | (static_cast<ImU32>(old) << IM_COL32_A_SHIFT);
}

}  // namespace pathmark::preview
