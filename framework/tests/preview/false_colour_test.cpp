// Numbers as colours.
#include "preview/compare/false_colour.h"

#include "film/signed_picture.h"
#include "support/test_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pathmark::test {
namespace {

using namespace preview;

TEST(FalseColour, ErrorsHaveTheColoursOfTheCompareCommand) {
  const Image a = gradientImage(8, 8);
  Image b = a;
  for (std::size_t i = 0; i < b.rgb.size(); ++i)
    b.rgb[i] += 0.01f * static_cast<float>(i % 7) - 0.03f;
  const FalseColours colours = errorColours(a, b, findUsablePixels(a, b));
  ASSERT_EQ(colours.values.size(), 64u);
  for (std::size_t i = 0; i < 64; ++i) {
    const auto colour = signedColour(static_cast<double>(colours.values[i]), colours.scale.to);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(colours.rgba[4 * i + c], colour[c]);
    EXPECT_EQ(colours.rgba[4 * i + 3], 255);
  }
}

TEST(FalseColour, NoiseIsTheRelativeStandardErrorOfAPixel) {
  Image image{2, 1, {1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f}};
  image.variance = {0.0101f, 0.0101f, 0.0101f, std::numeric_limits<float>::infinity(), 0.0f, 0.0f};
  const FalseColours colours = noiseColours(image);
  EXPECT_NEAR(colours.values[0], 0.1, 1e-6);
  EXPECT_TRUE(std::isnan(colours.values[1]));
  const auto colour = colours.scale.colour(0.1);
  EXPECT_EQ(colours.rgba[0], colour[0]);
  EXPECT_EQ(colours.rgba[4], 255);  // magenta
  EXPECT_EQ(colours.rgba[5], 0);
}

TEST(FalseColour, PlacesOnTheBarAreTheirNumbers) {
  const ColourScale error{true, -2.0, 2.0}, noise{false, 1e-3, 1.0};
  EXPECT_DOUBLE_EQ(error.valueAt(0.0), -2.0);
  EXPECT_DOUBLE_EQ(error.valueAt(0.5), 0.0);
  EXPECT_DOUBLE_EQ(error.valueAt(1.0), 2.0);
  EXPECT_DOUBLE_EQ(noise.valueAt(0.0), 1e-3);
  EXPECT_NEAR(noise.valueAt(2.0 / 3.0), 0.1, 1e-12);
  EXPECT_EQ(noise.colour(1e-9), noise.colour(1e-3));
  EXPECT_EQ(noise.colour(50.0), noise.colour(1.0));
}

TEST(FalseColour, MoreNoiseIsBrighter) {
  const ColourScale noise{false, 1e-3, 1.0};
  int before = 0;
  for (int k = 0; k <= 20; ++k) {
    const auto c = noise.colour(noise.valueAt(k / 20.0));
    const int luminance = 2126 * c[0] + 7152 * c[1] + 722 * c[2];
    EXPECT_GT(luminance, before) << k;
    before = luminance;
  }
}

}  // namespace
}  // namespace pathmark::test
