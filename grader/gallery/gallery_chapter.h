// The gallery as a chapter of the handouts.
#pragma once

#include "gallery/make_gallery.h"

#include <string>

namespace pathmark::gallery {

// "mistakes_part3.png", beside other figures.
std::string sheetName(int part);

// Markdown, with the sheets in `figures/`.
std::string galleryChapter(const Gallery& gallery);

}  // namespace pathmark::gallery
