// Pictures of signed differences: which colour says what.
#include "film/signed_picture.h"
#include "film/image_formats.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include <stb_image.h>

namespace pathmark::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

using Colour8 = std::array<int, 3>;

std::vector<Colour8> coloursOf(const std::vector<float>& values, double scale) {
  const std::string png = encodeSignedPng(static_cast<int>(values.size()), 1, values, scale);
  int width = 0, height = 0, channels = 0;
  unsigned char* data =
      stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                            static_cast<int>(png.size()), &width, &height, &channels, 3);
  EXPECT_NE(data, nullptr);
  std::vector<Colour8> colours(values.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = {data[3 * i], data[3 * i + 1], data[3 * i + 2]};
  stbi_image_free(data);
  return colours;
}

TEST(SignedPicture, ZeroIsWhiteAboveIsRedAndBelowIsBlue) {
  const auto colours = coloursOf({0.0f, -0.0f, 1.0f, -1.0f, 2.0f, -1e30f, kNan}, 2.0);
  EXPECT_EQ(colours[0], (Colour8{255, 255, 255}));
  EXPECT_EQ(colours[1], (Colour8{255, 255, 255}));
  EXPECT_GT(colours[2][0], colours[2][2] + 50);
  EXPECT_GT(colours[3][2], colours[3][0] + 50);
  EXPECT_EQ(colours[4], (Colour8{103, 0, 31}));
  EXPECT_EQ(colours[5], (Colour8{5, 48, 97}));
  EXPECT_EQ(colours[6], (Colour8{255, 0, 255}));
}

TEST(SignedPicture, LargerIsDarkerOnBothSides) {
  std::vector<float> values;
  for (int i = 0; i <= 20; ++i) values.push_back(static_cast<float>(i));
  for (const float sign : {1.0f, -1.0f}) {
    for (float& value : values) value *= sign;
    const auto colours = coloursOf(values, 20.0);
    for (std::size_t i = 1; i < colours.size(); ++i)
      EXPECT_LT(colours[i][0] + colours[i][1] + colours[i][2],
                colours[i - 1][0] + colours[i - 1][1] + colours[i - 1][2]);
  }
}

TEST(SignedPicture, FullColourIsExceededByOnePercent) {
  std::vector<float> values;
  for (int i = -100; i <= 100; ++i) values.push_back(static_cast<float>(i));
  values.push_back(kNan);
  EXPECT_NEAR(fullColour(values), 99.0, 1.0);
  EXPECT_EQ(fullColour(std::vector<float>(5, 0.0f)), 1.0);
  EXPECT_EQ(fullColour(std::vector<float>{kNan}), 1.0);
  std::vector<float> one(1000, 0.0f);
  one[7] = -3.0f;
  EXPECT_EQ(fullColour(one), 3.0);
}

TEST(SignedPicture, OfThreeChannelsTheFurthestIsShownWithItsSign) {
  const float largest = std::numeric_limits<float>::max();
  Image a{3, 1, {1, 2, 3, 0, 0, 0, largest, 0, 0}};
  const Image b{3, 1, {1, 5, 1, 0, 0, 0, -largest, 0, 0}};
  a.invalid = {0, 1, 0};
  const UsablePixels pixels = findUsablePixels(a, b);
  const Image difference = differenceImage(a, b);
  EXPECT_EQ(difference.invalid, (std::vector<std::uint8_t>{0, 1, 0}));
  const std::vector<float> values = largestOfChannels(difference, pixels);
  EXPECT_EQ(values[0], -3.0f);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(values[2], largest);
}

}  // namespace
}  // namespace pathmark::test
