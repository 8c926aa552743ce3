// Small pictures, for pages that show many.
#pragma once

#include <string>
#include <string_view>

namespace pathmark::report {

// A PNG of at most so many pixels on each side, made by averaging radiance over blocks of pixels;
// the bytes as they are if they are small enough, nothing if they are no PNG.
std::string thumbnail(std::string_view png, int longestSide);

}  // namespace pathmark::report
