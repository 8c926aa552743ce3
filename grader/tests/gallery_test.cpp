// The mistake gallery: what it says of pictures, how it draws them, and what it chooses.
#include "film/image_formats.h"
#include "gallery/gallery_chapter.h"
#include "gallery/gallery_sheet.h"
#include "gallery/make_gallery.h"
#include "gallery/palette_png.h"
#include "gallery/what_shows.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pathmark::test {
namespace {

using gallery::lookFor;
using gallery::whatShows;
using marking::Measured;

constexpr int kSide = 48;

// Grey, with the same variance everywhere.
Measured flatPicture(float radiance, float variance) {
  Measured picture{{kSide, kSide}, 1.0, 16};
  picture.image.rgb.assign(3 * kSide * kSide, radiance);
  picture.image.variance.assign(3 * kSide * kSide, variance);
  return picture;
}

TEST(WhatShows, SaysHowMuchBrighterAPictureIs) {
  const std::string words = lookFor(whatShows(flatPicture(0.6f, 1e-6f), flatPicture(0.5f, 1e-6f)));
  EXPECT_EQ(words, "On the whole 20 % brighter, everywhere alike.");
}

TEST(WhatShows, SaysWhereAPictureIsDarker) {
  Measured wrong = flatPicture(0.5f, 1e-6f);
  for (std::size_t row = 0; row < kSide / 3; ++row)
    for (std::size_t v = 0; v < 3 * (kSide / 3); ++v) wrong.image.rgb[row * 3 * kSide + v] = 0.25f;
  const std::string words = lookFor(whatShows(wrong, flatPicture(0.5f, 1e-6f)));
  EXPECT_NE(words.find("50 % darker at the top left"), std::string::npos) << words;
}

TEST(WhatShows, SaysWhereOnlyTheNoiseTells) {
  const std::string words = lookFor(whatShows(flatPicture(0.5f, 4e-4f), flatPicture(0.5f, 1e-4f)));
  EXPECT_EQ(words, "Right in the mean, and noisier. The noise is 2.0 times the correct picture's.");
}

TEST(WhatShows, SaysWhereNothingShows) {
  const std::string words = lookFor(whatShows(flatPicture(0.5f, 1e-4f), flatPicture(0.5f, 1e-4f)));
  EXPECT_EQ(words, "The picture alone does not show this.");
}

// All colours of a smooth picture: more than the palette holds.
std::vector<std::uint8_t> manyColours() {
  std::vector<std::uint8_t> bytes;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column)
      for (const int value : {4 * row, 4 * column, 2 * (row + column)})
        bytes.push_back(static_cast<std::uint8_t>(value));
  return bytes;
}

TEST(PalettePng, IsAPictureOfNearlyTheSameColours) {
  const std::vector<std::uint8_t> bytes = manyColours();
  const std::string png = gallery::encodePalettePng(64, 64, bytes);
  const Image back = decodePng(png);
  ASSERT_EQ(back.width, 64);
  ASSERT_EQ(back.height, 64);
  const Image exact = decodePng(encodePngBytes(64, 64, bytes));
  double largest = 0.0;
  for (std::size_t v = 0; v < bytes.size(); ++v)
    largest = std::max(largest, std::abs(double{std::pow(back.rgb[v], 1.0f / 2.4f)} -
                                         double{std::pow(exact.rgb[v], 1.0f / 2.4f)}));
  EXPECT_LT(largest, 0.1);
  EXPECT_LT(png.size(), bytes.size() / 3);
}

// As the kit's guard wants it: no text, no times.
TEST(PalettePng, HasNoChunksButThePicture) {
  const std::string png = gallery::encodePalettePng(1, 1, std::vector<std::uint8_t>{9, 9, 9});
  std::string kinds;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k)
      length = length * 256 + static_cast<unsigned char>(png[at + k]);
    kinds += png.substr(at + 4, 4) + " ";
    at += 12 + length;
  }
  EXPECT_EQ(kinds, "IHDR PLTE IDAT IEND ");
}

std::vector<Variant> variantsNamed(const std::vector<std::string>& names) {
  std::vector<Variant> some;
  for (const Variant& variant : allVariants())
    if (std::find(names.begin(), names.end(), variant.name) != names.end()) some.push_back(variant);
  return some;
}

TEST(Gallery, ShowsWhatTheMeanShowsWithManyRaysAndTheRestWithFew) {
  const TemporaryFolder scratch;
  const std::vector<Variant> variants =
      variantsNamed({"part3_density_uniform", "part3_both_sides"});
  ASSERT_EQ(variants.size(), 2u);
  const gallery::Gallery made =
      gallery::makeGallery(variants, {.threads = 2, .scratch = scratch.path()},
                           [](std::size_t, const std::string&) { return true; });
  ASSERT_EQ(made.specimens.size(), 2u);
  const gallery::Specimen &hidden = made.specimens[0], &plain = made.specimens[1];
  EXPECT_EQ(hidden.variant.name, "part3_both_sides");
  EXPECT_EQ(hidden.rays, gallery::kFewRays);
  EXPECT_EQ(hidden.words, "The picture alone does not show this.");
  EXPECT_EQ(plain.rays, gallery::kManyRays);
  EXPECT_NE(plain.words.find("brighter"), std::string::npos) << plain.words;
  EXPECT_EQ(plain.picture.width, 96);

  const std::vector<gallery::Group> groups = gallery::groupsOf(made, 3);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].numbers, std::vector<int>{2});
  EXPECT_EQ(groups[1].numbers, std::vector<int>{1});
  EXPECT_GT(decodePng(gallery::sheetPng(groups)).width, 2 * 96);
  const std::string chapter =
      gallery::galleryChapter(made, "# Title\n\nBy hand.\n\n## Part 0: old\n");
  EXPECT_TRUE(chapter.starts_with("# Title\n\nBy hand.\n\n## Part 3: ")) << chapter;
  for (const Variant& variant : variants)
    EXPECT_NE(chapter.find(variant.what), std::string::npos) << variant.what;
  EXPECT_NE(chapter.find("figures/mistakes_part3.png"), std::string::npos);
}

}  // namespace
}  // namespace pathmark::test
