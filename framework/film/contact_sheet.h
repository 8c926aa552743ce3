// drawContactSheet: many small pictures on one, each with its name.
//
//   SheetTile        one picture, or the reason why there is none
//   thumbnailSize    how many pixels a picture of some shape gets
//   sheetLabels      names for scene files that tell them apart
#pragma once

#include "film/image.h"

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pathmark {

struct SheetTile {
  std::string label;
  std::optional<Image> picture{};
  double exposure = 1.0;
  std::string reason{};  // a word or two, shown in the place of a picture
};

// Width and height with the longer one `thumbnail`, each at least 1.
std::array<int, 2> thumbnailSize(int width, int height, int thumbnail);

// A grid half as wide again as high, or a little more. Pictures must be of thumbnailSize. To be
// written as a PNG of exposure 1.
Image drawContactSheet(std::span<const SheetTile> tiles, int thumbnail);

// The files' names without ending. Where several are equal, the nearest folder that tells one of
// them from another is put before it: anna/my_scene.
std::vector<std::string> sheetLabels(std::span<const std::filesystem::path> files);

}  // namespace pathmark
