// Drawing on images, in linear radiance.
//
//   makeCanvas      an image of one colour
//   fillRectangle   a rectangle of one colour
//   drawImage       another image, at an exposure
//   drawText        a line of text at any size;  textWidth, textHeight: how large it becomes
//
// What reaches over the edge is cut off.
#pragma once

#include "film/image.h"

#include <array>
#include <string_view>

namespace pathmark {

using LinearRgb = std::array<float, 3>;

// The linear value that a PNG of exposure 1 shows as this level of 0 to 255.
LinearRgb greyOfLevel(int level);

Image makeCanvas(int width, int height, const LinearRgb& colour);

// Columns [x, x + width), rows [y, y + height).
void fillRectangle(Image& canvas, int x, int y, int width, int height, const LinearRgb& colour);

// With its top left pixel at (x, y). Invalid pixels stay invalid.
void drawImage(Image& canvas, const Image& image, double exposure, int x, int y);

// `dot` is the side of one dot of the font in pixels, of any fraction: pixels are inked by how
// much of them the letters cover.
void drawText(Image& canvas, std::string_view text, int x, int y, double dot,
              const LinearRgb& colour);
int textWidth(std::string_view text, double dot);
int textHeight(double dot);

}  // namespace pathmark
