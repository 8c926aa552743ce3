#include "film/contact_sheet.h"

#include "film/ascii_text.h"
#include "film/canvas.h"

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

constexpr int kPaper = 246, kMissing = 205, kInk = 40;  // levels of grey

// Lengths in pixels.
struct SheetLayout {
  int thumbnail, margin;
  double dot;  // of the font
  int columns, rows;

  SheetLayout(int tiles, int side)
      : thumbnail(side),
        margin(std::max(side / 12, 2)),
        dot(std::max(side / 120.0, 0.75)),
        columns(std::max(static_cast<int>(std::ceil(std::sqrt(1.5 * tiles))), 1)),
        rows(std::max((tiles + columns - 1) / columns, 1)) {}

  int labelGap() const { return std::max(thumbnail / 25, 1); }
  int tileHeight() const { return thumbnail + labelGap() + textHeight(dot); }
  int width() const { return columns * thumbnail + (columns + 1) * margin; }
  int height() const { return rows * tileHeight() + (rows + 1) * margin; }
  int left(int tile) const { return margin + tile % columns * (thumbnail + margin); }
  int top(int tile) const { return margin + tile / columns * (tileHeight() + margin); }
};

// Shortened until it is no wider than the thumbnail.
std::string fitting(std::string text, const SheetLayout& layout) {
  if (textWidth(text, layout.dot) <= layout.thumbnail) return text;
  while (!text.empty() && textWidth(text + "...", layout.dot) > layout.thumbnail) text.pop_back();
  return text + "...";
}

void drawCentred(Image& sheet, const std::string& text, int left, int y,
                 const SheetLayout& layout) {
  // In the font's letters first: of others only a part of the bytes might fit.
  const std::string shown = fitting(asciiText(text), layout);
  drawText(sheet, shown, left + (layout.thumbnail - textWidth(shown, layout.dot)) / 2, y,
           layout.dot, greyOfLevel(kInk));
}

// In the middle of the tile's square.
void drawPicture(Image& sheet, const SheetTile& tile, int left, int top,
                 const SheetLayout& layout) {
  const int side = layout.thumbnail;
  if (!tile.picture) {
    fillRectangle(sheet, left, top, side, side, greyOfLevel(kMissing));
    drawCentred(sheet, tile.reason, left, top + (side - textHeight(layout.dot)) / 2, layout);
    return;
  }
  drawImage(sheet, *tile.picture, tile.exposure, left + (side - tile.picture->width) / 2,
            top + (side - tile.picture->height) / 2);
}

std::string folderAbove(const std::filesystem::path& file, int levels) {
  std::filesystem::path folder = std::filesystem::absolute(file).lexically_normal();
  for (int k = 0; k < levels; ++k) folder = folder.parent_path();
  return folder.filename().string();
}

// Whether the files have the same folder so many levels above them.
bool agree(std::span<const std::filesystem::path> files, int levels) {
  return std::all_of(files.begin(), files.end(), [&](const std::filesystem::path& file) {
    return folderAbove(file, levels) == folderAbove(files.front(), levels);
  });
}

}  // namespace

std::array<int, 2> thumbnailSize(int width, int height, int thumbnail) {
  const double scale = static_cast<double>(thumbnail) / std::max(width, height);
  const auto scaled = [&](int length) {
    return std::max(static_cast<int>(std::lround(length * scale)), 1);
  };
  return {scaled(width), scaled(height)};
}

Image drawContactSheet(std::span<const SheetTile> tiles, int thumbnail) {
  const int count = static_cast<int>(tiles.size());
  const SheetLayout layout(count, thumbnail);
  Image sheet = makeCanvas(layout.width(), layout.height(), greyOfLevel(kPaper));
  for (int k = 0; k < count; ++k) {
    const SheetTile& tile = tiles[static_cast<std::size_t>(k)];
    const int left = layout.left(k), top = layout.top(k);
    drawPicture(sheet, tile, left, top, layout);
    drawCentred(sheet, tile.label, left, top + thumbnail + layout.labelGap(), layout);
  }
  return sheet;
}

std::vector<std::string> sheetLabels(std::span<const std::filesystem::path> files) {
  constexpr int kFarthestFolder = 16;
  std::vector<std::string> labels;
  for (const std::filesystem::path& file : files) {
    std::vector<std::filesystem::path> namesakes;
    std::copy_if(files.begin(), files.end(), std::back_inserter(namesakes),
                 [&](const auto& other) { return other.stem() == file.stem(); });
    int levels = 1;
    while (levels <= kFarthestFolder && agree(namesakes, levels)) ++levels;
    const std::string folder = levels <= kFarthestFolder ? folderAbove(file, levels) + "/" : "";
    labels.push_back(folder + file.stem().string());
  }
  return labels;
}

}  // namespace pathmark
