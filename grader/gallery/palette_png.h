// PNG files of at most 256 colours: a third of the size of those with all, and less.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace pathmark::gallery {

// From 3 x width x height bytes of sRGB. Where there are more than 256 colours, by median cut
// (Heckbert, "Color image quantization for frame buffer display", SIGGRAPH 1982), of colours that
// have been rounded to 32 levels in each channel.
std::string encodePalettePng(int width, int height, std::span<const std::uint8_t> srgb);

}  // namespace pathmark::gallery
