// From radiance to the screen's bytes.
#include "preview/compare/display.h"

#include "film/image_formats.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <stb_image.h>

namespace pathmark::test {
namespace {

using preview::DisplaySettings;
using preview::ToneCurve;
using testing::Uniforms;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr ToneCurve kCurves[] = {ToneCurve::kClip, ToneCurve::kReinhard, ToneCurve::kFilmic};

std::vector<std::uint8_t> shown(const Image& image, const DisplaySettings& settings) {
  std::vector<std::uint8_t> rgba;
  preview::displayImage(image, settings, rgba);
  return rgba;
}

// Radiances from 1e-4 to 1e3, and values that are none.
Image wildImage() {
  Uniforms random(7);
  Image image{64, 64};
  for (int i = 0; i < 3 * 64 * 64; ++i)
    image.rgb.push_back(static_cast<float>(std::pow(10.0, random.between(-4.0, 3.0))));
  image.rgb[10] = kNan;
  image.rgb[100] = kInfinity;
  image.rgb[1000] = -1.0f;
  image.rgb[1003] = -kInfinity;
  image.invalid.assign(64 * 64, 0);
  image.invalid[77] = 1;
  return image;
}

std::vector<std::uint8_t> pngBytes(const Image& image, double exposure) {
  const std::string png = encodePng(image, exposure);
  int width = 0, height = 0, channels = 0;
  unsigned char* data =
      stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                            static_cast<int>(png.size()), &width, &height, &channels, 4);
  std::vector<std::uint8_t> bytes(data, data + 4 * image.width * image.height);
  stbi_image_free(data);
  return bytes;
}

TEST(Display, WithoutAToneCurveTheBytesAreThoseOfThePng) {
  const Image image = wildImage();
  for (const double exposure : {0.01, 0.7, 1.0, 30.0})
    EXPECT_EQ(shown(image, {.exposure = exposure}), pngBytes(image, exposure)) << exposure;
}

TEST(Display, PixelsWithoutAValueAreMagentaWithEveryCurve) {
  const Image image = wildImage();
  for (const ToneCurve curve : kCurves) {
    const auto rgba = shown(image, {.curve = curve});
    for (const std::size_t pixel : {std::size_t{3}, std::size_t{77}}) {
      const std::vector<std::uint8_t> colour(&rgba[4 * pixel], &rgba[4 * pixel] + 4);
      EXPECT_EQ(colour, (std::vector<std::uint8_t>{255, 0, 255, 255}));
    }
  }
}

TEST(Display, CurvesBeginAtZeroAndNeverFall) {
  for (const ToneCurve curve : kCurves) {
    const DisplaySettings settings{.curve = curve};
    EXPECT_EQ(preview::toneMapped(0.0, settings), 0.0);
    double before = 0.0;
    for (double x = 1e-6; x < 1e4; x *= 1.01) {
      const double now = preview::toneMapped(x, settings);
      EXPECT_GT(now, before) << x;
      before = now;
    }
  }
}

TEST(Display, BytesOfBrighterGreysAreNeverDarker) {
  Image greys{1000, 1};
  for (int i = 0; i < 1000; ++i)
    greys.rgb.insert(greys.rgb.end(), 3, static_cast<float>(1e-4 * std::pow(1.025, i)));
  greys.rgb[2997] = greys.rgb[2998] = greys.rgb[2999] = kInfinity;
  for (const ToneCurve curve : kCurves) {
    const auto rgba = shown(greys, {.curve = curve});
    for (std::size_t i = 4; i < rgba.size(); ++i) EXPECT_GE(rgba[i], rgba[i - 4]) << i;
    EXPECT_EQ(rgba[3996], 255);
  }
}

TEST(Display, CurvesHaveTheirPublishedValues) {
  const DisplaySettings reinhard{.curve = ToneCurve::kReinhard, .white = 4.0};
  EXPECT_NEAR(preview::toneMapped(4.0, reinhard), 1.0, 1e-12);
  EXPECT_NEAR(preview::toneMapped(1.0, reinhard), (1.0 + 1.0 / 16.0) / 2.0, 1e-12);
  const DisplaySettings filmic{.curve = ToneCurve::kFilmic};
  EXPECT_NEAR(preview::toneMapped(1.0, filmic), 2.54 / 3.16, 1e-12);
}

TEST(Display, ReinhardKeepsTheHueOfBrightColours) {
  const Image orange{1, 1, {2.0f, 1.0f, 0.5f}};
  const double luminance = 0.2126 * 2.0 + 0.7152 + 0.0722 * 0.5;
  const DisplaySettings settings{.curve = ToneCurve::kReinhard, .white = 4.0};
  const double factor = preview::toneMapped(luminance, settings) / luminance;
  const Image dimmed{1,
                     1,
                     {static_cast<float>(2.0 * factor), static_cast<float>(factor),
                      static_cast<float>(0.5 * factor)}};
  const auto direct = shown(orange, settings), byFactor = shown(dimmed, {});
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(direct[c], byFactor[c], 1) << c;
}

}  // namespace
}  // namespace pathmark::test
