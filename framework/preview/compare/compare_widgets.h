// The parts of the compare panel that only show or choose something.
#pragma once

#include "preview/compare/compare_session.h"

namespace pathmark::preview {

void drawViewChoice(View& view, bool hasReference);

// The colours of numbers with the numbers, or why there are none. `result` may be null.
void drawColourBar(View view, const CompareResult* result, float scale);

// Which reference there is, or why there is none.
void drawFound(const FoundReference& found);

void drawVerdict(const CompareResult& result, float scale);

// Means and errors. The result must have a comparison.
void drawNumbers(const CompareResult& result);

// `byTime` is chosen here: over seconds, or over rays per pixel.
void drawErrorCurves(const CompareResult& result, bool& byTime, float height, float scale);

}  // namespace pathmark::preview
