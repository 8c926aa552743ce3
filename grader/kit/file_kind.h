// whyNot: whether a file of a kit is what contents.txt says that it is.
#pragma once

#include "kit/manifest.h"

#include <string>
#include <string_view>

namespace pathmark::kit {

// Empty if it is; else what it is not, to follow "is". Text is UTF-8 without control characters. A
// picture is an OpenEXR file, or a PNG file that ends where its picture ends and whose notes are
// not compressed, so that they can be searched.
std::string whyNot(FileKind kind, std::string_view content);

}  // namespace pathmark::kit
