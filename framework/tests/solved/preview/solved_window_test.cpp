// The window's panels with coursework that is right, and with one that is not.
#include "film/image_file.h"
#include "preview/real_window.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

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

// The middle of the field, without a window manager's frame.
constexpr std::pair<int, int> kPathsField{960, 264};

// Of the panels: sentences about mistakes.
int orangePixels(const Image& window) {
  int count = 0;
  for (int row = 0; row < window.height; ++row)
    for (int column = kPanelLeft; column < window.width; ++column) {
      const auto pixel = window.pixel(column, row);
      count += pixel[0] > 0.5f && pixel[2] < 0.3f * pixel[0] ? 1 : 0;
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

TEST(PreviewPanels, OfPart9BelongToThePictureWithLightsBySolidAngle) {
  const VirtualDisplay display;
  const TemporaryFolder folder;
  RealWindow window(display, {"cornell_box", "--with", "solutions", "--part", "9", "--after-rays",
                              "64", "--picture", (folder / "seen.exr").string()});
  EXPECT_EQ(window.wait(), 0) << window.log();
  const auto rendered = [&](std::vector<std::string> more) {
    const fs::path file = folder / "rendered.exr";
    std::vector<std::string> words{PATHMARK_PROGRAM, "render",           "cornell_box", "--with",
                                   "solutions",      "--rays-per-pixel", "64",          "--output",
                                   file.string()};
    words.insert(words.end(), more.begin(), more.end());
    const ProcessResult result = run(words);
    EXPECT_EQ(result.exitCode, 0) << result.output;
    return readImage(file).image.rgb;
  };
  const Image seen = readImage(folder / "seen.exr").image;
  EXPECT_EQ(seen.rgb, rendered({"--solid-angle"}));
  EXPECT_NE(seen.rgb, rendered({}));
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

// What is typed is shown at once, but for what is no expression.
TEST(PreviewPanels, ShowTheLightPathsThatAreTyped) {
  const VirtualDisplay display;
  RealWindow window(display,
                    {"cornell_phong", "--with", "solutions", "--tab", "view", "--after-rays", "4"});
  window.waitForTitle(" 4 rays");
  const Image all = window.screenshot();
  window.click(kPathsField.first, kPathsField.second);
  for (const char* key : {"L", "S", "E"}) window.press(key);
  EXPECT_TRUE(window.waitForTitle("light paths LSE"));
  EXPECT_TRUE(waitFor([&] {
    return meanOf(window.screenshot(), 200, 150, 400, 500)[0] <
           0.2 * meanOf(all, 200, 150, 400, 500)[0];
  }));
  window.press("D");
  EXPECT_TRUE(waitFor([&] { return orangePixels(window.screenshot()) > 100; }));
  EXPECT_NE(window.title().find("light paths LSE"), std::string::npos) << window.title();
  // A key that is down for less than a frame goes unseen.
  EXPECT_TRUE(waitFor([&] {
    window.press("BackSpace");
    return window.title().find("light paths") == std::string::npos;
  }));
}

// On the left of the line is the noisy picture, on its right the reference; the camera stays.
TEST(PreviewPanels, TheSliderIsDraggedOverThePicture) {
  const VirtualDisplay display;
  RealWindow window(
      display, {"cornell_box", "--with", "solutions", "--tab", "compare", "--after-rays", "4"});
  window.waitForTitle(" 4 rays");
  // On both sides of the line in the middle, at column 416.
  const auto left = [](const Image& shot) { return meanOf(shot, 270, 450, 120, 60); };
  const auto right = [](const Image& shot) { return meanOf(shot, 450, 450, 120, 60); };
  const Image picture = window.screenshot();
  // The choice is grey until the reference has been read.
  EXPECT_TRUE(waitFor([&] {
    window.click(1141, 67);
    return right(window.screenshot()) != right(picture);
  }));
  const Image halves = window.screenshot();
  EXPECT_EQ(left(halves), left(picture));
  window.drag(416, 400, 250, 300);
  EXPECT_TRUE(waitFor([&] { return left(window.screenshot()) != left(picture); }));
  EXPECT_EQ(right(window.screenshot()), right(halves));
}

}  // namespace
}  // namespace pathmark::test
