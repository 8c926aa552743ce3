// The numbers of paths, as tables.
//
//   pathList       the paths of the pixel
//   vertexTable    the vertices of one path, and what is known of one of them
//   throughputBar  what the colours mean
//   wrappedText    a sentence with numbers
#pragma once

#include "preview/paths/path_engine.h"

#include <span>
#include <string>

namespace pathmark::preview {

// Returns the path that has been chosen by now, by its number in the answer; `order` lists them.
int pathList(const PathAnswer& answer, std::span<const int> order, int chosen, float scale);

// Returns the vertex that the mouse points at, or -1.
int vertexTable(const PathAnswer& answer, int path, int pointedAt, float scale);

void describeVertexHere(const PathAnswer& answer, int path, int vertex, float width);

void throughputBar(float scale);

// In lines that end between words, and never within a number as ImGui's own.
void wrappedText(const std::string& sentence, float width);

}  // namespace pathmark::preview
