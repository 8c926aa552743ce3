// The paths of a pixel in the real window, while their code changes.
#include "preview/real_window.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

// One bounce in a grey picture.
constexpr const char* kBounce =
    "  Hit hit;\n"
    "  if (!intersect(ray, hit)) return Colour(0.0f);\n"
    "  const DirectionSample next = hit.brdf->reflection(-ray.direction, hit.n, 0, 0, 0);\n"
    "  hit.brdf->brdf(-ray.direction, next.wi, hit.n);\n"
    "  intersect(hit.spawnRay(next.wi), hit);\n"
    "  (void)sampler;\n"
    "  return Colour(0.2f);";

// Around the clicked pixel; no other part of the window is as bright there.
int whitePixels(const Image& window) {
  int count = 0;
  for (int row = 400; row < 600; ++row)
    for (int column = 300; column < 500; ++column) {
      const auto pixel = window.pixel(column, row);
      count += pixel[0] > 0.9f && pixel[1] > 0.9f && pixel[2] > 0.9f ? 1 : 0;
    }
  return count;
}

// The dot of a vertex and its number have more, the mark of the pixel has fewer.
constexpr int kFewest = 80;

TEST(PathsInTheWindow, AreRecordedAgainAfterEachSave) {
  const VirtualDisplay display;
  TestCoursework coursework;
  coursework.setTracePath(kBounce);
  RealWindow window(display, {"empty_furnace", "--with", coursework.folder().string(), "--tab",
                              "paths", "--after-rays", "64"});
  window.waitForTitle("64 rays");
  EXPECT_EQ(whitePixels(window.screenshot()), 0);
  window.click(400, 500);
  EXPECT_TRUE(waitFor([&] { return whitePixels(window.screenshot()) > kFewest; }));

  coursework.setTracePath("  volatile int* p = nullptr; *p = 1; return Colour(0.0f);");
  window.waitForTitle("stopped");
  EXPECT_TRUE(waitFor([&] { return whitePixels(window.screenshot()) < kFewest; }));

  coursework.setTracePath(kBounce);
  EXPECT_TRUE(window.waitForTitleWithout("stopped"));
  EXPECT_TRUE(waitFor([&] { return whitePixels(window.screenshot()) > kFewest; }));
}

}  // namespace
}  // namespace pathmark::test
