// Drawing: what is drawn is where it was asked for, and nowhere else.
#include "film/canvas.h"
#include "film/ascii_text.h"
#include "film/contact_sheet.h"
#include "film/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace pathmark::test {
namespace {

constexpr LinearRgb kRed{1.0f, 0.0f, 0.0f}, kWhite{1.0f, 1.0f, 1.0f}, kBlack{0.0f, 0.0f, 0.0f};

LinearRgb at(const Image& image, int x, int y) {
  const auto p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}

double sumOfRed(const Image& image) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) sum += static_cast<double>(image.rgb[i]);
  return sum;
}

std::size_t dotsSet(const TextDots& dots) {
  return static_cast<std::size_t>(std::accumulate(dots.set.begin(), dots.set.end(), 0));
}

TEST(Canvas, ARectangleIsCutOffAtTheEdges) {
  Image canvas = makeCanvas(4, 3, kWhite);
  fillRectangle(canvas, -2, 1, 4, 10, kRed);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) EXPECT_EQ(at(canvas, x, y), x < 2 && y >= 1 ? kRed : kWhite);
}

TEST(Canvas, AnImageIsDrawnAtItsExposureAndCutOffAtTheEdges) {
  Image canvas = makeCanvas(3, 3, kBlack);
  const Image image = makeCanvas(2, 2, {0.25f, 0.5f, 0.125f});
  drawImage(canvas, image, 2.0, 2, -1);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      EXPECT_EQ(at(canvas, x, y), x == 2 && y == 0 ? (LinearRgb{0.5f, 1.0f, 0.25f}) : kBlack);
}

TEST(Canvas, InvalidPixelsStayInvalid) {
  Image canvas = makeCanvas(3, 1, kWhite);
  drawImage(canvas, Image{2, 1, std::vector<float>(6), {0, 1}}, 1.0, 1, 0);
  EXPECT_EQ(canvas.invalid, (std::vector<std::uint8_t>{0, 0, 1}));
}

TEST(Canvas, GreyLevelsAreThoseOfThePng) {
  EXPECT_EQ(greyOfLevel(0), kBlack);
  EXPECT_EQ(greyOfLevel(255), kWhite);
  // IEC 61966-2-1.
  EXPECT_NEAR(greyOfLevel(188)[0], 0.5029f, 1e-4f);
  EXPECT_NEAR(greyOfLevel(5)[1], 5.0f / 255.0f / 12.92f, 1e-7f);
}

TEST(Canvas, LettersHaveInkAndSpacesHaveNone) {
  EXPECT_EQ(dotsSet(textDots(" ")), 0u);
  for (char c = '!'; c < 127; ++c) EXPECT_GT(dotsSet(textDots(std::string(1, c))), 0u) << c;
  EXPECT_EQ(textDots("").width, 0);
}

TEST(Canvas, NoLetterReachesBelowTheTextHeight) {
  for (char c = '!'; c < 127; ++c) {
    Image canvas = makeCanvas(40, 2 * textHeight(1.0), kBlack);
    drawText(canvas, std::string(1, c), 0, 0, 1.0, kWhite);
    const double inside = sumOfRed(canvas);
    EXPECT_EQ(inside, static_cast<double>(dotsSet(textDots(std::string(1, c))))) << c;
  }
}

TEST(Canvas, LatinLettersAreShownWithoutTheirMarks) {
  EXPECT_EQ(textDots("caf\u00e9").set, textDots("cafe").set);
  EXPECT_EQ(asciiText("M\u00fcller, \u00d6zg\u00fcr, Stra\u00dfe, \u00c5se, S\u00f8ren"),
            "Muller, Ozgur, Strasse, Ase, Soren");
  EXPECT_EQ(
      asciiText("\u0141ukasz, \u0160i\u0161ka, Dvo\u0159\u00e1k, Erd\u0151s, \u0130n\u00f6n\u00fc"),
      "Lukasz, Siska, Dvorak, Erdos, Inonu");
  EXPECT_EQ(asciiText("\u00c0\u00ff\u0100\u017f\u0178\u017e\u0149\u0138"), "AyAsYz'nk");
  EXPECT_EQ(asciiText("Mu\u0308ller"), "Muller") << "with a mark of its own, as in file names";
}

TEST(Canvas, WhatTheFontHasNoLetterForIsAQuestionMark) {
  EXPECT_EQ(asciiText("\u674e \U0001f600 a\tb"), "? ? a?b");
  EXPECT_EQ(asciiText("M\xfcller"), "M?ller") << "in Latin-1, which is no UTF-8";
  EXPECT_EQ(asciiText("ab\xc3"), "ab?") << "cut off";
  EXPECT_EQ(asciiText(""), "");
}

// The letters cover the same part of the canvas at every size, up to its square.
TEST(Canvas, InkGrowsWithTheSquareOfTheSize) {
  const auto dots = static_cast<double>(dotsSet(textDots("veach_plates")));
  for (const double dot : {1.0, 1.3333, 2.0, 2.7}) {
    Image canvas = makeCanvas(textWidth("veach_plates", dot), textHeight(dot), kBlack);
    drawText(canvas, "veach_plates", 0, 0, dot, kWhite);
    EXPECT_NEAR(sumOfRed(canvas), dots * dot * dot, 1e-3 * dots * dot * dot) << dot;
  }
}

TEST(Canvas, TextIsCutOffAtTheEdges) {
  Image canvas = makeCanvas(5, 5, kBlack);
  drawText(canvas, "#####", -7, -3, 1.5, kWhite);
  EXPECT_GT(sumOfRed(canvas), 0.0);
}

TEST(ContactSheet, ThumbnailsKeepTheShapeOfThePicture) {
  EXPECT_EQ(thumbnailSize(256, 256, 160), (std::array{160, 160}));
  EXPECT_EQ(thumbnailSize(320, 240, 160), (std::array{160, 120}));
  EXPECT_EQ(thumbnailSize(100, 400, 160), (std::array{40, 160}));
  EXPECT_EQ(thumbnailSize(16384, 1, 160), (std::array{160, 1}));
}

TEST(ContactSheet, EveryPictureIsOnTheSheetAsAWhole) {
  for (const int count : {1, 2, 5, 15, 16, 200}) {
    std::vector<SheetTile> tiles;
    for (int k = 0; k < count; ++k) {
      Image picture = makeCanvas(k % 2 == 0 ? 16 : 8, 16, kBlack);
      // Brighter than anything else that is drawn.
      fillRectangle(picture, 0, 0, 8, 16, {2.0f, 2.0f, 2.0f});
      tiles.push_back({.label = "x", .picture = std::move(picture)});
    }
    const Image sheet = drawContactSheet(tiles, 16);
    EXPECT_EQ(std::count(sheet.rgb.begin(), sheet.rgb.end(), 2.0f), 3 * 8 * 16 * count);
  }
}

TEST(ContactSheet, IsWiderThanHigh) {
  for (const std::size_t count : {2u, 3u, 6u, 15u, 40u}) {
    const Image sheet = drawContactSheet(std::vector<SheetTile>(count), 160);
    EXPECT_GT(sheet.width, sheet.height) << count;
    EXPECT_LT(sheet.width, 3 * sheet.height) << count;
  }
}

TEST(ContactSheet, LongLabelsAndReasonsStayWithinTheirTile) {
  const std::string longText(500, 'M');
  const std::vector<SheetTile> tiles{{.label = longText, .reason = longText}, {.label = "b"}};
  const Image sheet = drawContactSheet(tiles, 160);
  const Image empty = drawContactSheet(std::vector<SheetTile>{{.label = ""}, {.label = "b"}}, 160);
  ASSERT_EQ(sheet.rgb.size(), empty.rgb.size());
  for (int y = 0; y < sheet.height; ++y)
    for (int x = sheet.width / 2; x < sheet.width; ++x)
      ASSERT_EQ(at(sheet, x, y), at(empty, x, y)) << x << " " << y;
}

// A label is cut between letters: the sheet is that of the same letters without marks.
TEST(ContactSheet, LongLabelsAreCutBetweenLetters) {
  std::string marked, plain;
  for (int k = 0; k < 200; ++k) {
    marked += "\u00fc";
    plain += "u";
  }
  EXPECT_EQ(drawContactSheet(std::vector<SheetTile>{{.label = marked}}, 160).rgb,
            drawContactSheet(std::vector<SheetTile>{{.label = plain}}, 160).rgb);
}

TEST(ContactSheet, NoTilesAreASheetToo) { EXPECT_GT(drawContactSheet({}, 16).width, 0); }

TEST(ContactSheet, LabelsTellNamesakesApart) {
  const std::vector<std::filesystem::path> files{
      "class/anna/scenes/my_scene.json", "class/bert/scenes/my_scene.json",
      "class/bert/scenes/other.json", "class/bert/scenes/other.json"};
  EXPECT_EQ(sheetLabels(files),
            (std::vector<std::string>{"anna/my_scene", "bert/my_scene", "other", "other"}));
}

}  // namespace
}  // namespace pathmark::test
