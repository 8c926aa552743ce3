#include "gallery/gallery_sheet.h"

#include "film/canvas.h"
#include "film/srgb.h"
#include "gallery/gallery_scenes.h"
#include "gallery/palette_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace pathmark::gallery {

namespace {

constexpr int kColumns = 8;
constexpr int kMargin = 8, kGap = 3;                                       // pixels
constexpr double kDot = 1.0;                                               // of the font
constexpr int kPaper = 246, kMissing = 205, kInk = 40, kCorrectInk = 110;  // levels of grey

int heightOf(const Group& group) { return group.correct->picture.height; }

int rowsOf(const Group& group) {
  return (static_cast<int>(group.specimens.size()) + kColumns - 1) / kColumns;
}

int tileHeight(const Group& group) { return heightOf(group) + kGap + textHeight(kDot) + kMargin; }

int groupHeight(const Group& group) {
  return textHeight(kDot) + kGap + rowsOf(group) * tileHeight(group) + kMargin;
}

void drawCentred(Image& sheet, const std::string& text, int left, int y, int level) {
  drawText(sheet, text, left + (kPixels - textWidth(text, kDot)) / 2, y, kDot, greyOfLevel(level));
}

// The first column holds the correct picture, and in further rows nothing.
int leftOf(int column) { return kMargin + column * (kPixels + kMargin); }

void drawGroup(Image& sheet, const Group& group, int top) {
  drawText(sheet, titleOf(*group.correct), kMargin, top, kDot, greyOfLevel(kInk));
  top += textHeight(kDot) + kGap;
  drawImage(sheet, group.correct->picture, group.correct->exposure, leftOf(0), top);
  drawCentred(sheet, "correct", leftOf(0), top + heightOf(group) + kGap, kCorrectInk);
  for (std::size_t k = 0; k < group.specimens.size(); ++k) {
    const Specimen& specimen = *group.specimens[k];
    const int left = leftOf(1 + static_cast<int>(k) % kColumns);
    const int y = top + static_cast<int>(k) / kColumns * tileHeight(group);
    if (specimen.picture.rgb.empty()) {
      fillRectangle(sheet, left, y, kPixels, heightOf(group), greyOfLevel(kMissing));
      drawCentred(sheet, specimen.failure, left, y + heightOf(group) / 2, kInk);
    } else {
      drawImage(sheet, specimen.picture, specimen.exposure, left, y);
    }
    drawCentred(sheet, fmt::format("{}", group.numbers[k]), left, y + heightOf(group) + kGap, kInk);
  }
}

// What is no number is magenta, as in other pictures.
std::string encode(const Image& sheet) {
  const SrgbBytes& table = SrgbBytes::table();
  std::vector<std::uint8_t> bytes(sheet.rgb.size());
  for (std::size_t v = 0; v < bytes.size(); ++v) bytes[v] = table(double{sheet.rgb[v]});
  for (std::size_t p = 0; p < sheet.invalid.size(); ++p)
    if (sheet.invalid[p] != 0) {
      bytes[3 * p] = bytes[3 * p + 2] = 255;
      bytes[3 * p + 1] = 0;
    }
  return encodePalettePng(sheet.width, sheet.height, bytes);
}

}  // namespace

std::vector<Group> groupsOf(const Gallery& gallery, int part) {
  std::vector<Group> groups;
  for (const CorrectView& view : gallery.correct)
    if (view.part == part) groups.push_back({&view, {}, {}});
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.correct->rays > b.correct->rays;
  });
  for (Group& group : groups) {
    int number = 0;
    for (const Specimen& s : gallery.specimens) {
      if (s.variant.part != part) continue;
      ++number;
      if (s.scene != group.correct->scene || s.rays != group.correct->rays) continue;
      group.specimens.push_back(&s);
      group.numbers.push_back(number);
    }
  }
  return groups;
}

std::string titleOf(const CorrectView& view) {
  return fmt::format("{}, {} rays per pixel", view.scene, view.rays);
}

std::string sheetPng(const std::vector<Group>& groups) {
  std::size_t widest = 0;
  int height = kMargin;
  for (const Group& group : groups) {
    widest = std::max(widest, std::min<std::size_t>(group.specimens.size(), kColumns));
    height += groupHeight(group);
  }
  Image sheet = makeCanvas(leftOf(1 + static_cast<int>(widest)), height, greyOfLevel(kPaper));
  int top = kMargin;
  for (const Group& group : groups) {
    drawGroup(sheet, group, top);
    top += groupHeight(group);
  }
  return encode(sheet);
}

}  // namespace pathmark::gallery
