// Verdicts in words.
#include "preview/compare/verdict.h"

#include "support/test_images.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

using namespace preview;

Verdict verdict(const Image& a, const Image& b) {
  return verdictOf(compareImages(a, b, {8, 8}, {.alpha = 1e-3}), 64.0);
}

void expectHas(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(Verdict, EqualPicturesAreTheSame) {
  const Image image = gradientImage(16, 16, 1e-4f);
  const Verdict v = verdict(image, image);
  EXPECT_EQ(v.judgement, Judgement::kSame);
  expectHas(v.headline, "every value is equal");
  EXPECT_EQ(v.raysPerPixel, 64.0);
}

TEST(Verdict, OfPicturesThatNoiseTellsApartSaysWhatWouldHaveBeenFound) {
  const Image image = gradientImage(16, 16, 1e-4f);
  Image other = image;
  other.rgb[0] += 0.01f;
  const Verdict v = verdict(other, image);
  EXPECT_EQ(v.judgement, Judgement::kSame);
  expectHas(v.headline, "beyond noise so far");
  // The mean is 0.5 and its standard error sqrt(2e-4 / 256) = 8.8e-4, of which 3.76 + 2 are
  // needed: 1.0 %.
  expectHas(v.detail, "off by 1 %");
}

TEST(Verdict, NamesTheChannelAndTheWorstTile) {
  const Image image{16, 16, std::vector<float>(768, 1.0f), {}, std::vector<float>(768, 1e-4f)};
  Image other = image;
  for (std::size_t i = 1; i < 768; i += 3) other.rgb[i] = 0.98f;  // green
  for (std::size_t row = 8; row < 16; ++row)
    for (std::size_t column = 0; column < 8; ++column)
      other.rgb[3 * (16 * row + column) + 1] = 0.9f;
  const Verdict v = verdict(other, image);
  EXPECT_EQ(v.judgement, Judgement::kDiffers);
  expectHas(v.detail, "Whole image: green 0.96 instead of 1 (-4 %)");
  expectHas(v.detail, "4 of 4 tiles differ.");
  expectHas(v.detail, "columns 0 to 7, rows 8 to 15, green 0.9 instead of 1 (-10 %)");
  EXPECT_EQ(v.worst.top, 8);
}

TEST(Verdict, SaysWhereOnlyTheWholeDiffers) {
  // 1024 tiles, each 2 standard errors off.
  const std::size_t n = 3 * 256 * 256;
  const Image image{256, 256, std::vector<float>(n, 1.0f), {}, std::vector<float>(n, 1e-2f)};
  Image other = image;
  for (float& value : other.rgb) value = 1.03f;
  const Verdict v = verdict(other, image);
  EXPECT_EQ(v.judgement, Judgement::kDiffers);
  expectHas(v.detail, "Whole image");
  expectHas(v.detail, "No tile by itself");
  EXPECT_EQ(v.worst.width, 0);
}

TEST(Verdict, CountsPixelsWithoutAValue) {
  Image image = gradientImage(16, 16, 1e-4f);
  const Image reference = image;
  image.invalid.assign(256, 0);
  image.invalid[3] = image.invalid[9] = 1;
  const Verdict v = verdict(image, reference);
  EXPECT_EQ(v.judgement, Judgement::kDiffers);
  expectHas(v.detail, "2 pixels have no valid value in your picture");
}

TEST(Verdict, PicturesWithoutAnyValueDoNotCrash) {
  Image image = gradientImage(16, 16, 1e-4f);
  image.invalid.assign(256, 1);
  EXPECT_EQ(verdict(image, gradientImage(16, 16, 1e-4f)).judgement, Judgement::kDiffers);
}

}  // namespace
}  // namespace pathmark::test
