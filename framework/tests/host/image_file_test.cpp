// Image files: what each format keeps.
#include "film/image_file.h"
#include "film/image_formats.h"
#include "support/test_coursework_files.h"
#include "support/test_images.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfDoubleAttribute.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfStringAttribute.h>

namespace pathmark::test {
namespace {

using testing::Uniforms;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

const ImageOrigin kOrigin{.scene =
                              "K\xc3\xbc"
                              "che \xe2\x98\x83 \"1\"\n2",
                          .sceneHash = "0123456789abcdef0123456789abcdef",
                          .coursework = "\xe5\xad\xa6\xe7\x94\x9f",
                          .raysPerPixel = 1234.5,
                          .raysPerPass = 64,
                          .replicates = 16,
                          .pixelsPerBlock = 8,
                          .seed = std::numeric_limits<std::uint64_t>::max(),
                          .sampler = "stratified",
                          .paths = "LS+DE",
                          .seconds = 0.125};

Image noisyImage(int width, int height) {
  Uniforms random(1);
  Image image{width, height};
  for (int i = 0; i < 3 * width * height; ++i) {
    const double mean = 0.5 + random.nextDouble();
    const double error = 0.02 * mean * (0.5 + random.nextDouble());
    image.rgb.push_back(static_cast<float>(mean + error * random.nextNormal()));
    image.variance.push_back(static_cast<float>(error * error));
  }
  return image;
}

TEST(ImageFile, ExrKeepsEveryBitAndTheOrigin) {
  TemporaryFolder folder;
  Image image = gradientImage(37, 21);
  image.rgb[5] = std::numeric_limits<float>::denorm_min();
  image.rgb[6] = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.variance.push_back(1.0f / static_cast<float>(i + 3));
  image.invalid.assign(image.rgb.size() / 3, 0);
  image.invalid[7] = 1;
  writeImage(folder / "a.exr", image, 30.0, kOrigin);
  const ImageFile read = readImage(folder / "a.exr");
  EXPECT_EQ(read.image.width, 37);
  EXPECT_EQ(read.image.height, 21);
  EXPECT_EQ(read.image.rgb, image.rgb);
  EXPECT_EQ(read.image.variance, image.variance);
  EXPECT_EQ(read.image.invalid, image.invalid);
  EXPECT_EQ(read.origin.scene, kOrigin.scene);
  EXPECT_EQ(read.origin.sceneHash, kOrigin.sceneHash);
  EXPECT_EQ(read.origin.coursework, kOrigin.coursework);
  EXPECT_EQ(read.origin.raysPerPixel, kOrigin.raysPerPixel);
  EXPECT_EQ(read.origin.raysPerPass, kOrigin.raysPerPass);
  EXPECT_EQ(read.origin.replicates, kOrigin.replicates);
  EXPECT_EQ(read.origin.pixelsPerBlock, kOrigin.pixelsPerBlock);
  EXPECT_EQ(read.origin.seed, kOrigin.seed);
  EXPECT_EQ(read.origin.sampler, kOrigin.sampler);
  EXPECT_EQ(read.origin.paths, kOrigin.paths);
  EXPECT_EQ(read.origin.seconds, kOrigin.seconds);
}

TEST(ImageFile, ExrWithoutVarianceIsReadWithoutIt) {
  const ImageFile read = decodeExr(encodeExr(gradientImage(3, 2), {}));
  EXPECT_TRUE(read.image.variance.empty());
  EXPECT_TRUE(read.image.invalid.empty());
}

TEST(ImageFile, OpenExrItselfSeesChannelsAndAttributes) {
  TemporaryFolder folder;
  Image image = gradientImage(8, 4, 0.25f);
  image.invalid.assign(32, 1);
  writeImage(folder / "a.exr", image, 1.0, kOrigin);
  const Imf::InputFile file((folder / "a.exr").c_str());
  const Imf::Header& header = file.header();
  EXPECT_EQ(header.compression(), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(header.lineOrder(), Imf::INCREASING_Y);
  EXPECT_EQ(header.dataWindow(), Imath::Box2i({0, 0}, {7, 3}));
  for (const char* name : {"R", "G", "B", "variance.R", "variance.G", "variance.B"})
    EXPECT_EQ(header.channels()[name].type, Imf::FLOAT) << name;
  EXPECT_EQ(header.channels()["invalid"].type, Imf::UINT);
  const auto text = [&](const char* name) {
    return header.typedAttribute<Imf::StringAttribute>(name).value();
  };
  EXPECT_EQ(text("pathmark.scene"), kOrigin.scene);
  EXPECT_EQ(text("pathmark.sceneHash"), kOrigin.sceneHash);
  EXPECT_EQ(text("pathmark.coursework"), kOrigin.coursework);
  EXPECT_EQ(text("pathmark.seed"), "18446744073709551615");
  EXPECT_EQ(text("pathmark.sampler"), "stratified");
  EXPECT_EQ(text("pathmark.paths"), "LS+DE");
  EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("pathmark.raysPerPixel").value(), 1234.5);
  EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("pathmark.seconds").value(), 0.125);
  EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("pathmark.raysPerPass").value(), 64);
  EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("pathmark.replicates").value(), 16);
}

TEST(ImageFile, PixelsWithoutValueComeBackAsTheyWere) {
  Image image = gradientImage(4, 4);
  image.rgb[0] = std::numeric_limits<float>::quiet_NaN();
  image.rgb[3] = kInfinity;
  image.rgb[6] = -1.0f;
  for (const Image& read : {decodeExr(encodeExr(image, {})).image, decodePfm(encodePfm(image))}) {
    EXPECT_TRUE(std::isnan(read.rgb[0]));
    EXPECT_EQ(read.rgb[3], kInfinity);
    EXPECT_EQ(read.rgb[6], -1.0f);
  }
}

TEST(ImageFile, CompactExrIsSmallerAndMovesValuesByASixteenthOfTheirErrorAtMost) {
  const Image image = noisyImage(64, 64);
  const std::string full = encodeExr(image, kOrigin);
  const std::string compact = encodeExr(image, kOrigin, ExrBits::kAboveNoise);
  const Image read = decodeExr(compact).image;
  RecordProperty("bytes", static_cast<int>(full.size()));
  RecordProperty("compactBytes", static_cast<int>(compact.size()));
  EXPECT_LT(compact.size(), full.size() * 6 / 10);
  double sumOfZ = 0.0, sumOfSquares = 0.0;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const double error = std::sqrt(static_cast<double>(image.variance[i]));
    const double moved = (static_cast<double>(read.rgb[i]) - image.rgb[i]) / error;
    EXPECT_LE(std::abs(moved), 1.0 / 16.0 + 1e-6);
    EXPECT_NEAR(read.variance[i] / image.variance[i], 1.0, 1.0 / 16.0 + 1e-6);
    sumOfZ += moved;
    sumOfSquares += moved * moved;
  }
  // Variance at most that of rounding to eighths; a mean of 0 within five standard errors.
  const double n = static_cast<double>(image.rgb.size());
  EXPECT_LE(sumOfSquares / n, 1.0 / (8.0 * 8.0 * 12.0));
  EXPECT_NEAR(sumOfZ / n, 0.0, 5.0 * std::sqrt(sumOfSquares) / n);
}

TEST(ImageFile, CompactExrKeepsValuesOfUnknownOrNoVariance) {
  const Image plain = gradientImage(5, 5);
  EXPECT_EQ(decodeExr(encodeExr(plain, {}, ExrBits::kAboveNoise)).image.rgb, plain.rgb);
  Image exact = plain;
  exact.variance.assign(plain.rgb.size(), 0.0f);
  exact.variance[2] = std::numeric_limits<float>::quiet_NaN();
  exact.variance[3] = kInfinity;
  EXPECT_EQ(decodeExr(encodeExr(exact, {}, ExrBits::kAboveNoise)).image.rgb, plain.rgb);
}

TEST(ImageFile, PfmKeepsEveryBit) {
  TemporaryFolder folder;
  const Image image = gradientImage(7, 5);
  writeImage(folder / "a.PFM", image, 30.0);
  EXPECT_EQ(readImage(folder / "a.PFM").image.rgb, image.rgb);
}

// Widths around the limits within which rows come in runs.
TEST(ImageFile, HdrKeepsEightBitsOfTheLargestChannelWithoutBias) {
  TemporaryFolder folder;
  for (const int width : {1, 7, 8, 100, 32767, 32768}) {
    Image image = gradientImage(width, 3);
    if (width >= 100) std::fill(image.rgb.begin() + 30, image.rgb.begin() + 200, 0.25f);
    writeImage(folder / "a.hdr", image, 30.0);
    const Image read = readImage(folder / "a.hdr").image;
    ASSERT_EQ(read.rgb.size(), image.rgb.size()) << width;
    double sum = 0.0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      const std::size_t p = i - i % 3;
      const float largest = std::max({image.rgb[p], image.rgb[p + 1], image.rgb[p + 2]});
      EXPECT_NEAR(read.rgb[i], image.rgb[i], largest / 256.0f) << width;
      sum += static_cast<double>(read.rgb[i]) - image.rgb[i];
    }
    if (width < 100) continue;
    EXPECT_NEAR(sum / static_cast<double>(image.rgb.size()), 0.0, 3e-4);
  }
}

TEST(ImageFile, HdrTakesTheLargestAndSmallestValues) {
  const Image image{3, 1, {3e38f, 1.0f, kInfinity, 1e-36f, 0.0f, -5.0f, NAN, 0.999f, 0.001f}};
  const Image read = decodeHdr(encodeHdr(image));
  EXPECT_GT(read.rgb[0], 1e38f);
  EXPECT_TRUE(std::isfinite(read.rgb[2]));
  for (const std::size_t black : {3u, 4u, 5u, 6u}) EXPECT_EQ(read.rgb[black], 0.0f);
  EXPECT_NEAR(read.rgb[7], 0.999f, 1.0f / 256.0f);
}

TEST(ImageFile, PngGivesBackLinearValuesOfEightBits) {
  TemporaryFolder folder;
  const Image image = gradientImage(16, 16);
  writeImage(folder / "a.png", image, 0.5);
  const Image read = readImage(folder / "a.png").image;
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    // Half a step of the sRGB curve where it is steepest.
    EXPECT_NEAR(read.rgb[i], 0.5f * image.rgb[i], 0.5 / 255.0 * 2.3);
  // What was read is written as the same bytes again.
  EXPECT_EQ(encodePng(read, 1.0), encodePng(image, 0.5));
}

TEST(ImageFile, FormatsSayWhatTheyLose) {
  EXPECT_EQ(whatTheFormatLoses("a.exr"), "");
  EXPECT_EQ(whatTheFormatLoses("a.pfm"), "");
  EXPECT_NE(whatTheFormatLoses("a.Png").find("8 bits"), std::string::npos);
  EXPECT_NE(whatTheFormatLoses("a.hdr").find("8 bits"), std::string::npos);
}

TEST(ImageFile, NamesAreNotLostInTheTable) {
  TemporaryFolder folder;
  EXPECT_NE(sentenceOf([&] { readImage(folder / "a.jpg"); }).find(".exr, .hdr, .png or .pfm"),
            std::string::npos);
  EXPECT_NE(sentenceOf([&] {
              writeImage(folder / "a", gradientImage(1, 1), 1.0);
            }).find(".exr, .hdr, .png or .pfm"),
            std::string::npos);
}

}  // namespace
}  // namespace pathmark::test
