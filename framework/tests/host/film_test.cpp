// Images: what is written can be read again, and nothing is ever half written.
#include "film/atomic_file.h"
#include "film/image_file.h"
#include "film/image_formats.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include <stb_image.h>

namespace pathmark::test {
namespace {

Image gradient(int width, int height) {
  Image image{width, height, {}, {}};
  for (int i = 0; i < width * height * 3; ++i)
    image.rgb.push_back(static_cast<float>(i) / static_cast<float>(width * height * 3 - 1));
  return image;
}

std::vector<unsigned char> decode(const std::string& png, int& width, int& height) {
  int channels = 0;
  unsigned char* data =
      stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                            static_cast<int>(png.size()), &width, &height, &channels, 3);
  EXPECT_NE(data, nullptr);
  std::vector<unsigned char> bytes(data, data + 3 * width * height);
  stbi_image_free(data);
  return bytes;
}

TEST(Film, MeansAreSumsDividedByRaysInDouble) {
  const std::vector<FilmPixel> film{{{3.0, 6.0, 0x1p24 + 1.0}, 3.0}, {{0, 0, 0}, 0.0}};
  const Image image = imageFromFilm(2, 1, film);
  EXPECT_EQ(image.rgb[0], 1.0f);
  EXPECT_EQ(image.rgb[1], 2.0f);
  EXPECT_EQ(image.rgb[2], static_cast<float>((0x1p24 + 1.0) / 3.0));
  EXPECT_EQ(image.invalid, (std::vector<std::uint8_t>{0, 1}));
}

TEST(Film, PfmKeepsEveryBit) {
  TemporaryFolder folder;
  const Image image = gradient(7, 5);
  writeImage(folder / "image.pfm", image, 30.0);
  const Image read = readPfm(folder / "image.pfm");
  EXPECT_EQ(read.width, 7);
  EXPECT_EQ(read.height, 5);
  EXPECT_EQ(read.rgb, image.rgb);
}

TEST(Film, PngIsTheSrgbCurveOfExposureTimesRadiance) {
  Image image{4,
              1,
              {0.0f, 0.001f, 0.0031308f, 0.5f, 0.25f, 0.75f, 1.0f, 2.0f, 100.0f, 0.1f, 0.1f, 0.1f},
              {}};
  int width = 0, height = 0;
  const auto bytes = decode(encodePng(image, 1.0), width, height);
  EXPECT_EQ(width, 4);
  EXPECT_EQ(height, 1);
  // IEC 61966-2-1, to the nearest of 255 steps.
  EXPECT_EQ(bytes,
            (std::vector<unsigned char>{0, 3, 10, 188, 137, 225, 255, 255, 255, 89, 89, 89}));
  const auto brighter = decode(encodePng(image, 2.5), width, height);
  EXPECT_EQ(brighter[9], 137);
}

TEST(Film, PngStartsAtTheTopLeft) {
  Image image{2, 2, std::vector<float>(12, 0.0f), {}};
  image.rgb[0] = 1.0f;   // red, top left
  image.rgb[11] = 1.0f;  // blue, bottom right
  int width = 0, height = 0;
  const auto bytes = decode(encodePng(image, 1.0), width, height);
  EXPECT_EQ(bytes[0], 255);
  EXPECT_EQ(bytes[11], 255);
}

TEST(Film, InvalidPixelsAreMagentaInPng) {
  Image image{2, 1, std::vector<float>(6, 0.0f), {0, 1}};
  int width = 0, height = 0;
  const auto bytes = decode(encodePng(image, 1.0), width, height);
  EXPECT_EQ(bytes, (std::vector<unsigned char>{0, 0, 0, 255, 0, 255}));
}

TEST(Film, UnknownEndingsAreRefusedWithASentence) {
  std::string why;
  EXPECT_FALSE(imageFormatKnown("picture.jpeg", why));
  EXPECT_NE(why.find(".png or .pfm"), std::string::npos);
  EXPECT_TRUE(imageFormatKnown("A.PNG", why));
}

TEST(Film, AFileThatCannotBeWrittenLeavesNothingBehind) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken.png");
  EXPECT_THROW(writeImage(folder / "taken.png", gradient(2, 2), 1.0), ImageError);
  EXPECT_THROW(writeImage(folder / "no/such/folder.png", gradient(2, 2), 1.0), ImageError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Film, AnExistingFileIsReplacedAsAWhole) {
  TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "old and long";
  writeFileAtomically(folder / "a.txt", "new");
  std::ifstream in(folder / "a.txt");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "new");
}

TEST(Film, BrokenPfmFilesAreRefusedWithASentence) {
  TemporaryFolder folder;
  for (const char* text : {"", "PF", "PF\n2 2\n-1.0\nabc", "Pf\n2 2\n-1.0\n", "PF\n-3 2\n-1.0\n",
                           "PF\n2 2\n1.0\n", "PF\n99999999 99999999\n-1.0\n"}) {
    std::ofstream(folder / "a.pfm") << text;
    EXPECT_THROW(readPfm(folder / "a.pfm"), ImageError) << text;
  }
  EXPECT_THROW(readPfm(folder / "nothing.pfm"), ImageError);
}

}  // namespace
}  // namespace pathmark::test
