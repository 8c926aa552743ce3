// The preview as a student uses it: the real window on a virtual display, real files saved.
#include "film/image_file.h"
#include "preview/real_window.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string_view>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

// Grey where tracePath says so; in a room without anything.
constexpr const char* kBright = "  return Colour(0.8f);";
constexpr const char* kDark = "  return Colour(0.1f);";

// In the middle of the picture, whatever the window's size.
std::array<double, 3> pictureOf(const Image& window) {
  return meanOf(window, window.width / 4, window.height / 2, 16, 16);
}

class Preview : public ::testing::Test {
 protected:
  // A window with the test's own coursework.
  RealWindow open(std::vector<std::string> more = {"--after-rays", "128"}) {
    std::vector<std::string> arguments{
        "empty_furnace", "--with", coursework_.folder().string(), "--tab", "view",
        "--stop-after",  "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RealWindow(display_, arguments);
  }

  VirtualDisplay display_;
  TestCoursework coursework_;
};

TEST_F(Preview, ShowsThePictureThatRenderMakes) {
  coursework_.setTracePath("  return Colour(sampler.next1D(), sampler.next1D(), 0.5f);");
  const std::string with = coursework_.folder().string();
  TemporaryFolder folder;
  RealWindow window = open({"--after-rays", "64", "--picture", (folder / "seen.exr").string(),
                            "--screenshot", (folder / "window.png").string()});
  EXPECT_EQ(window.wait(), 0) << window.log();
  const ProcessResult rendered =
      run({PATHMARK_PROGRAM, "render", "empty_furnace", "--with", with, "--rays-per-pixel", "64",
           "--output", (folder / "rendered.exr").string()});
  ASSERT_EQ(rendered.exitCode, 0) << rendered.output;
  EXPECT_EQ(readImage(folder / "seen.exr").image.rgb, readImage(folder / "rendered.exr").image.rgb);
  const auto mean = pictureOf(readImage(folder / "window.png").image);
  EXPECT_NEAR(mean[2], 0.5, 0.02);
  EXPECT_NEAR(mean[0], 0.5, 0.1);
}

TEST_F(Preview, OfPart8ShowsThePictureOfTracePathMis) {
  coursework_.setTracePath(kDark);
  coursework_.setFile("part8_mis.cpp", R"(
float powerHeuristic(float, float) { return 0.5f; }
float solidAnglePdf(const Point&, const LightSample&) { return 1.0f; }
Colour LitScene::tracePathMIS(const Ray&, Sampler& sampler) const {
  return Colour(sampler.next1D(), 0.25f, 0.75f);
})");
  TemporaryFolder folder;
  RealWindow window =
      open({"--part", "8", "--after-rays", "64", "--picture", (folder / "seen.exr").string()});
  EXPECT_EQ(window.wait(), 0) << window.log();
  const ProcessResult rendered =
      run({PATHMARK_PROGRAM, "render", "empty_furnace", "--with", coursework_.folder().string(),
           "--mis", "--rays-per-pixel", "64", "--output", (folder / "rendered.exr").string()});
  ASSERT_EQ(rendered.exitCode, 0) << rendered.output;
  const Image seen = readImage(folder / "seen.exr").image;
  EXPECT_EQ(seen.rgb, readImage(folder / "rendered.exr").image.rgb);
  EXPECT_EQ(seen.pixel(0, 0)[2], 0.75f);
}

TEST_F(Preview, RendersAnewAfterASave) {
  coursework_.setTracePath(kBright);
  RealWindow window = open();
  window.waitForTitle("128 rays");
  EXPECT_NEAR(pictureOf(window.screenshot())[0], 0.8, 0.02);
  coursework_.setTracePath(kDark);
  EXPECT_TRUE(waitFor([&] { return pictureOf(window.screenshot())[0] < 0.2; }));
  EXPECT_NEAR(pictureOf(window.screenshot())[0], 0.1, 0.02);
}

TEST_F(Preview, KeepsThePictureWhileAFileDoesNotCompile) {
  coursework_.setTracePath(kBright);
  RealWindow window = open();
  window.waitForTitle("128 rays");
  const Image before = window.screenshot();
  coursework_.setTracePath("  return nonsense;");
  window.waitForTitle("does not compile");
  const Image during = window.screenshot();
  EXPECT_NEAR(pictureOf(during)[0], 0.8, 0.02);
  // The banner lies above the picture.
  EXPECT_NE(meanOf(before, 100, 40, 300, 40), meanOf(during, 100, 40, 300, 40));
  coursework_.setTracePath(kDark);
  EXPECT_TRUE(window.waitForTitleWithout("does not compile"));
  EXPECT_TRUE(waitFor([&] { return pictureOf(window.screenshot())[0] < 0.2; }));
}

TEST_F(Preview, SurvivesACrashAndAnEndlessLoop) {
  coursework_.setTracePath(kBright);
  RealWindow window = open();
  window.waitForTitle("128 rays");
  for (const char* body : {"  volatile int* p = nullptr; *p = 1; return Colour(0.0f);",
                           "  for (volatile int i = 0;; i = i) {}"}) {
    coursework_.setTracePath(body);
    window.waitForTitle("stopped");
    EXPECT_NEAR(pictureOf(window.screenshot())[0], 0.8, 0.02);
    coursework_.setTracePath(kBright);
    EXPECT_TRUE(window.waitForTitleWithout("stopped"));
  }
  coursework_.setTracePath(kDark);
  EXPECT_TRUE(waitFor([&] { return pictureOf(window.screenshot())[0] < 0.2; }));
  EXPECT_TRUE(window.running());
}

// tracePath shows the direction of the ray.
TEST_F(Preview, MovesTheCameraWithTheMouseAndBackWithAKey) {
  coursework_.setTracePath("  return 0.5f * ray.direction + Colour(0.5f);");
  RealWindow window = open();
  window.waitForTitle("128 rays");
  const auto before = pictureOf(window.screenshot());
  window.drag(400, 400, 600, 400);
  const auto differs = [&] {
    const auto now = pictureOf(window.screenshot());
    return std::abs(now[0] - before[0]) + std::abs(now[2] - before[2]) > 0.1;
  };
  EXPECT_TRUE(waitFor(differs));
  window.press("c");
  EXPECT_TRUE(waitFor([&] { return !differs(); }));
}

TEST_F(Preview, AnswersToItsKeys) {
  coursework_.setTracePath(kDark);
  RealWindow window = open();
  window.waitForTitle("128 rays");
  const Image before = window.screenshot();
  window.press("question");
  // The list of keys covers the middle of the window.
  EXPECT_TRUE(waitFor([&] {
    return meanOf(window.screenshot(), 500, 300, 250, 200) != meanOf(before, 500, 300, 250, 200);
  }));
  window.press("Escape");
  const double dark = pictureOf(before)[0];
  for (int k = 0; k < 4; ++k) window.press("plus");
  EXPECT_TRUE(waitFor([&] { return pictureOf(window.screenshot())[0] > 3.0 * dark; }));
  window.press("shift+F12");
  EXPECT_TRUE(waitFor([&] { return fs::exists(window.file("pathmark_empty_furnace_001.exr")); }));
  window.press("ctrl+q");
  EXPECT_EQ(window.wait(), 0);
}

TEST_F(Preview, BeforeTheFirstPictureThereIsNoneToSave) {
  coursework_.setTracePath("  return nonsense;");
  RealWindow window = open();
  window.press("shift+F12");
  window.press("ctrl+q");
  EXPECT_EQ(window.wait(), 0) << window.log();
}

TEST_F(Preview, SavesThePictureUnderANumberOfWhichThereIsNoFileOfEitherKind) {
  coursework_.setTracePath(kDark);
  RealWindow window = open();
  window.waitForTitle("128 rays");
  std::ofstream(window.file("pathmark_empty_furnace_001.exr")) << "mine";
  window.press("shift+F12");
  EXPECT_TRUE(waitFor([&] { return fs::exists(window.file("pathmark_empty_furnace_002.exr")); }));
  EXPECT_TRUE(fs::exists(window.file("pathmark_empty_furnace_002.png")));
  EXPECT_EQ(textOf(window.file("pathmark_empty_furnace_001.exr")), "mine");
}

TEST_F(Preview, AfterAFileThatCouldNotBeWrittenClosingIsNoFault) {
  coursework_.setTracePath(kDark);
  TemporaryFolder folder;
  // With what a picture's name has besides, it is longer than a name can be.
  const fs::path scene = folder / (std::string(250, 'a') + ".json");
  fs::copy_file(fs::path(PATHMARK_ROOT) / "scenes/empty_furnace.json", scene);
  RealWindow window(
      display_, {scene.string(), "--with", coursework_.folder().string(), "--after-rays", "128"});
  window.waitForTitle("128 rays");
  window.press("shift+F12");
  window.press("ctrl+q");
  EXPECT_EQ(window.wait(), 0) << window.log();
}

TEST_F(Preview, TakesLettersAsTheKeyboardHasThem) {
  display_.setKeyboard("fr");
  coursework_.setTracePath(kDark);
  RealWindow window = open();
  window.waitForTitle("128 rays");
  window.press("ctrl+a");
  EXPECT_GT(window.screenshot().width, 0);
  window.press("ctrl+q");
  EXPECT_EQ(window.wait(), 0);
}

// As + is on Swiss keyboards.
TEST_F(Preview, WithShiftADigitsKeyChoosesNoPanel) {
  coursework_.setTracePath(kDark);
  RealWindow window = open();
  window.waitForTitle("128 rays");
  const Image before = window.screenshot();
  window.press("exclam");
  const Image after = window.screenshot();
  EXPECT_EQ(meanOf(before, before.width * 7 / 8, 60, 100, 300),
            meanOf(after, after.width * 7 / 8, 60, 100, 300));
  window.press("1");
  const Image other = window.screenshot();
  EXPECT_NE(meanOf(before, before.width * 7 / 8, 60, 100, 300),
            meanOf(other, other.width * 7 / 8, 60, 100, 300));
}

TEST_F(Preview, IsAsLargeAsItWasLastTimeAlsoOnAHighDensityScreen) {
  coursework_.setTracePath(kDark);
  const VirtualDisplay dense(1600, 1200, 192);
  RealWindow window(dense,
                    {"empty_furnace", "--with", coursework_.folder().string(), "--after-rays", "1"},
                    R"({"width": 700, "height": 500})");
  window.waitForTitle("rays");
  const Image shot = window.screenshot();
  EXPECT_EQ(shot.width, 700);
  EXPECT_EQ(shot.height, 500);
  window.press("ctrl+q");
  EXPECT_EQ(window.wait(), 0);
  EXPECT_NE(window.remembered().find("\"width\": 700"), std::string::npos) << window.remembered();
}

TEST_F(Preview, ShowsTheSceneThatIsSaved) {
  coursework_.setTracePath("  return 0.5f * ray.direction + Colour(0.5f);");
  TemporaryFolder folder;
  const fs::path scene = folder / "own.json";
  std::string text = textOf(fs::path(PATHMARK_ROOT) / "scenes/empty_furnace.json");
  std::ofstream(scene) << text;
  RealWindow window(
      display_, {scene.string(), "--with", coursework_.folder().string(), "--after-rays", "128"});
  window.waitForTitle("128 rays");
  std::ofstream(scene) << "{";
  window.waitForTitle("scene");
  std::ofstream(scene) << text;
  EXPECT_TRUE(window.waitForTitleWithout("scene"));
}

// Red tells where the camera looks, green how many bounces the scene has.
TEST_F(Preview, KeepsAMovedCameraWhenASceneIsSavedThatHasItsOwnWhereItWas) {
  coursework_.setTracePath(
      "  return {0.5f * ray.direction.x + 0.5f, 0.1f * static_cast<float>(maxBounces()), 0.0f};");
  TemporaryFolder folder;
  const fs::path scene = folder / "own.json";
  const std::string text = textOf(fs::path(PATHMARK_ROOT) / "scenes/empty_furnace.json");
  const auto withBounces = [&](const std::string& number) {
    constexpr std::string_view kBounces = "\"maxBounces\": 8";
    std::string changed = text;
    return changed.replace(changed.find(kBounces), kBounces.size(), "\"maxBounces\": " + number);
  };
  std::ofstream(scene) << withBounces("8");
  RealWindow window(display_, {scene.string(), "--with", coursework_.folder().string(), "--tab",
                               "view", "--after-rays", "128"});
  window.waitForTitle("128 rays");
  const double ahead = pictureOf(window.screenshot())[0];
  window.drag(400, 400, 600, 400);
  const auto hasMoved = [&](double red) { return std::abs(red - ahead) > 0.1; };
  ASSERT_TRUE(waitFor([&] { return hasMoved(pictureOf(window.screenshot())[0]); }));
  const double green = pictureOf(window.screenshot())[1];
  std::ofstream(scene) << withBounces("2");
  std::array<double, 3> now{};
  ASSERT_TRUE(waitFor([&] {
    now = pictureOf(window.screenshot());
    return now[1] < 0.5 * green;
  }));
  EXPECT_TRUE(hasMoved(now[0])) << now[0] << " " << ahead;
}

TEST_F(Preview, FillsAHighDensityWindow) {
  coursework_.setTracePath(kBright);
  TemporaryFolder folder;
  for (const std::string scale : {"1", "2"}) {
    RealWindow window = open({"--scale", scale, "--after-rays", "1", "--screenshot",
                              (folder / ("scale" + scale + ".png")).string()});
    EXPECT_EQ(window.wait(), 0) << window.log();
  }
  // Below the menu of scale 1 there is still some of that of scale 2, which is lighter than the
  // rest.
  const auto below = [&](const char* file) {
    return meanOf(readImage(folder / file).image, 1, 26, 5, 8)[0];
  };
  EXPECT_GT(below("scale2.png"), 2.0 * below("scale1.png"));
}

ProcessResult previewWithoutDisplay() {
  return run({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", PATHMARK_PROGRAM, "preview",
              "--with", "student"});
}

TEST(PreviewWithoutDisplay, SaysSo) {
  expectSays(previewWithoutDisplay(), 3,
             "There is no display to open a window on (DISPLAY is not set)");
}

// With the command that is recommended then, also beside another such command, and when the last
// window is closed before the program ends.
TEST(PreviewWithoutDisplay, TheProgramsExitCodeIsKept) {
  const std::string sentence = previewWithoutDisplay().output;
  const std::size_t begin = sentence.find("xvfb-run"), end = sentence.find(" ./pathmark");
  ASSERT_TRUE(begin != std::string::npos && end != std::string::npos && begin < end) << sentence;
  const std::string command = sentence.substr(begin, end - begin);
  TemporaryFolder folder;
  const ProcessResult result =
      run({"/bin/sh", "-c",
           command + " sleep 3 & sleep 1; " + command +
               " sh -c 'xdotool getmouselocation; sleep 0.3; exit 7'; code=$?; wait; exit $code"},
          folder.path());
  EXPECT_EQ(result.exitCode, 7) << result.output;
}

TEST(PreviewCommand, RefusesWhatItCannotDo) {
  const auto preview = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {PATHMARK_PROGRAM, "preview"});
    return run(arguments);
  };
  expectSays(preview({"no_such_scene"}), 2, "There is no scene no_such_scene");
  expectSays(preview({"--tab", "nothing"}), 2, "it is one of progress, samples");
  expectSays(preview({"--screenshot", "a.png"}), 2, "--after-rays");
  expectSays(preview({"--after-rays", "1", "--screenshot", "a.jpg"}), 2,
             "--screenshot a.jpg: the name ends in .png.");
  expectSays(preview({"--part", "7"}), 2, "allowed is 0 to 6, 8 or 9");
  expectSays(preview({"--size", "large"}), 2, "such as 1280x800");
  for (const char* option : {"--exposure", "--scale"})
    for (const char* value : {"nan", "inf", "1e9"})
      expectSays(preview({option, value}), 2, std::string("found ") + value + ", allowed is");
  expectSays(preview({"--help"}), 0, "Examples:");
}

}  // namespace
}  // namespace pathmark::test
