// The sample view in the real window: points in sight, a view that turns, and a crash that is told.
#include "preview/real_window.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pathmark::test {
namespace {

// Within the view with the points, in a window of 1280 x 800, whatever stands above it.
constexpr int kLeft = 840, kTop = 270, kWidth = 290, kHeight = 180;

// How many of its pixels are as blue as points, and not as bright as lines and arrows.
int colouredPixels(const Image& window) {
  int count = 0;
  for (int y = kTop; y < kTop + kHeight; ++y)
    for (int x = kLeft; x < kLeft + kWidth; ++x) {
      const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(window.width) +
                           static_cast<std::size_t>(x));
      count += window.rgb[at] < 0.1f && window.rgb[at + 2] > 0.3f ? 1 : 0;
    }
  return count;
}

int differentPixels(const Image& a, const Image& b) {
  int count = 0;
  for (int y = kTop; y < kTop + kHeight; ++y)
    for (int x = kLeft; x < kLeft + kWidth; ++x) {
      const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                           static_cast<std::size_t>(x));
      count += std::abs(a.rgb[at + 1] - b.rgb[at + 1]) > 0.02f ? 1 : 0;
    }
  return count;
}

class SampleWindow : public ::testing::Test {
 protected:
  SampleWindow() {
    setReflection(
        "const vec2 c = std::sqrt(1.0f - t) * onUnitCircle(s);\n"
        "return {Frame(n).toWorld({c.x, std::sqrt(t), c.y}), std::sqrt(t) * kInvPi};");
  }

  void setReflection(const std::string& body) {
    coursework_.setFile(
        "part3_lambertian.cpp",
        "Colour lambertianBRDF::brdf(const Vector&, const Vector&, const Vector&) "
        "const { return Kd; }\n"
        "float lambertianBRDF::pdf(const Vector&, const Vector&, const Vector&) "
        "const { return 1.0f; }\n"
        "DirectionSample lambertianBRDF::reflection(const Vector&, const Vector& n, "
        "float s, float t, float) const {\n" +
            body + "\n}");
  }

  RealWindow open() {
    return RealWindow(display_, {"empty_furnace", "--with", coursework_.folder().string(), "--part",
                                 "3", "--tab", "samples", "--after-rays", "8"});
  }

  // Until it shows what is asked for, or after minutes.
  template <typename Condition>
  static bool eventually(RealWindow& window, Condition holds) {
    for (int trial = 0; trial < 400; ++trial)
      if (holds(window.screenshot())) return true;
    return false;
  }

  VirtualDisplay display_;
  TestCoursework coursework_;
};

TEST_F(SampleWindow, ShowsPointsAndTurnsThemWhenItIsDragged) {
  RealWindow window = open();
  ASSERT_TRUE(window.waitForTitle("8 rays")) << window.log();
  ASSERT_TRUE(eventually(window, [](const Image& i) { return colouredPixels(i) > 300; }));
  const Image before = window.screenshot();
  window.drag(900, 300, 1000, 330);
  const Image turned = window.screenshot();
  EXPECT_GT(differentPixels(before, turned), 1000);
  EXPECT_GT(colouredPixels(turned), 300);
}

TEST_F(SampleWindow, LosesThePointsInACrashAndHasThemAgainAfterTheNextSave) {
  RealWindow window = open();
  ASSERT_TRUE(window.waitForTitle("8 rays")) << window.log();
  ASSERT_TRUE(eventually(window, [](const Image& i) { return colouredPixels(i) > 300; }));
  setReflection("if (s >= 0.0f) *(volatile int*)16 = 1;\nreturn {n, t};");
  EXPECT_TRUE(eventually(window, [](const Image& i) { return colouredPixels(i) < 100; }));
  EXPECT_TRUE(window.running()) << window.log();
  setReflection(
      "const vec2 c = std::sqrt(1.0f - s) * onUnitCircle(t);\n"
      "return {Frame(n).toWorld({c.x, std::sqrt(s), c.y}), std::sqrt(s) * kInvPi};");
  EXPECT_TRUE(eventually(window, [](const Image& i) { return colouredPixels(i) > 300; }));
}

}  // namespace
}  // namespace pathmark::test
