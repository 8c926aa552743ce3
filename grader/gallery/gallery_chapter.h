// The gallery as a chapter of the handouts.
#pragma once

#include "gallery/make_gallery.h"

#include <string>
#include <string_view>

namespace pathmark::gallery {

// "mistakes_part3.png", beside other figures.
std::string sheetName(int part);

// Markdown, with the sheets in `figures/`. What stands above the parts in the chapter that was
// there before is kept: it is written by hand.
std::string galleryChapter(const Gallery& gallery, std::string_view before);

}  // namespace pathmark::gallery
