// The window's panels with coursework that is right, and with one that is not.
#include "film/image_file.h"
#include "preview/real_window.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

constexpr int kPanelLeft = 832;

// Pixels of the panels that are rather blue than grey: marks, bars, points and curves.
int bluePixels(const Image& window, int top, int bottom) {
  int count = 0;
  for (int row = top; row < bottom; ++row)
    for (int column = kPanelLeft; column < window.width; ++column) {
      const auto pixel = window.pixel(column, row);
      count += pixel[2] > 0.3f && pixel[2] > 2.0f * pixel[0] ? 1 : 0;
    }
  return count;
}

Image windowOf(const VirtualDisplay& display, std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  const fs::path shot = folder / "window.png";
  for (const std::string& word : {std::string("cornell_box"), std::string("--after-rays"),
                                  std::string("4"), std::string("--screenshot"), shot.string()})
    arguments.push_back(word);
  RealWindow window(display, arguments);
  EXPECT_EQ(window.wait(), 0) << window.log();
  return readImage(shot).image;
}

// The bar below the first line is as long as the share of functions that are right.
TEST(PreviewPanels, SayHowManyFunctionsAreRight) {
  const VirtualDisplay display;
  TestCoursework wrong;
  const Image right = windowOf(display, {"--with", "solutions", "--tab", "progress"});
  const Image other = windowOf(display, {"--with", wrong.folder().string(), "--tab", "progress"});
  EXPECT_GT(bluePixels(right, 70, 85), 4000);
  EXPECT_LT(bluePixels(other, 70, 85), 3000);
}

TEST(PreviewPanels, DrawSamplesWithTheirHistograms) {
  const VirtualDisplay display;
  const Image samples =
      windowOf(display, {"--with", "solutions", "--tab", "samples", "--part", "3"});
  EXPECT_GT(bluePixels(samples, 150, 450), 500);
  EXPECT_GT(bluePixels(samples, 580, 780), 2000);
}

TEST(PreviewPanels, DrawThePathsOfAClickedPixel) {
  const VirtualDisplay display;
  RealWindow window(display,
                    {"cornell_box", "--with", "solutions", "--tab", "view", "--after-rays", "4"});
  window.waitForTitle(" 4 rays");
  const Image before = window.screenshot();
  window.click(416, 600);
  // Lines from the clicked pixel over the picture above it.
  EXPECT_TRUE(waitFor([&] {
    return meanOf(window.screenshot(), 250, 150, 350, 350) != meanOf(before, 250, 150, 350, 350);
  }));
  window.press("5");
  EXPECT_TRUE(waitFor([&] {
    return meanOf(window.screenshot(), 250, 150, 350, 350) == meanOf(before, 250, 150, 350, 350);
  }));
}

TEST(PreviewPanels, CompareWithTheReference) {
  const VirtualDisplay display;
  const Image compared = windowOf(display, {"--with", "solutions", "--tab", "compare"});
  // The curve of errors.
  EXPECT_GT(bluePixels(compared, 500, 690), 50);
}

}  // namespace
}  // namespace pathmark::test
