// Colours and lines of paths.
#include "preview/paths/path_colour.h"
#include "preview/paths/path_geometry.h"

#include <gtest/gtest.h>

#include <limits>

namespace pathmark::preview {
namespace {

double lightness(const Rgb8& c) { return 0.3 * c.r + 0.6 * c.g + 0.1 * c.b; }

TEST(PathColour, GrowsLighterWithTheThroughput) {
  double before = -1.0;
  for (const double throughput : {0.001, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8}) {
    const double now = lightness(colourAt(placeOfThroughput(throughput)));
    EXPECT_GT(now, before + 5.0) << throughput;
    before = now;
  }
}

TEST(PathColour, ShowsWhatIsOutsideAsTheNearestInside) {
  EXPECT_EQ(placeOfThroughput(0.0), 0.0);
  EXPECT_EQ(placeOfThroughput(-1.0), 0.0);
  EXPECT_EQ(placeOfThroughput(std::numeric_limits<double>::quiet_NaN()), 0.0);
  EXPECT_EQ(placeOfThroughput(1.0), 1.0);
  EXPECT_EQ(placeOfThroughput(std::numeric_limits<double>::infinity()), 1.0);
}

// Of 100 x 50 pixels, one of which is 0.1 wide at the distance 2.
FlatCamera camera() {
  FlatCamera c;
  c.topLeft = {-5.0f, 2.5f, 2.0f};
  c.pixelRight = {0.1f, 0.0f, 0.0f};
  c.pixelDown = {0.0f, -0.1f, 0.0f};
  c.width = 100;
  c.height = 50;
  return c;
}

TEST(PathGeometry, APixelGrowsWithTheDistance) {
  EXPECT_NEAR(pixelSizeAt(camera(), {0.0, 0.0, 2.0}), 0.1, 1e-6);
  EXPECT_NEAR(pixelSizeAt(camera(), {30.0, -10.0, 6.0}), 0.3, 1e-6);
  EXPECT_EQ(pixelSizeAt(camera(), {0.0, 0.0, -1.0}), 0.0);
}

TEST(PathGeometry, LinesAreCutAtTheEdgesOfThePicture) {
  const auto cut = clip({{-50.0, 25.0}, {250.0, 25.0}}, camera(), 0.0);
  ASSERT_TRUE(cut);
  EXPECT_DOUBLE_EQ(cut->from.x, 0.0);
  EXPECT_DOUBLE_EQ(cut->to.x, 100.0);
  EXPECT_DOUBLE_EQ(cut->to.y, 25.0);
  const auto whole = clip({{10.0, 10.0}, {90.0, 40.0}}, camera(), 0.0);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->from, glm::dvec2(10.0, 10.0));
  EXPECT_FALSE(clip({{-50.0, 60.0}, {250.0, 60.0}}, camera(), 0.0)) << "below it";
  EXPECT_TRUE(clip({{-50.0, 60.0}, {250.0, 60.0}}, camera(), 12.0)) << "in the margin";
  EXPECT_FALSE(clip({{-10.0, 45.0}, {5.0, 60.0}}, camera(), 0.0)) << "past its corner";
  EXPECT_FALSE(clip({{std::numeric_limits<double>::quiet_NaN(), 0.0}, {1.0, 1.0}}, camera(), 0.0));
}

}  // namespace
}  // namespace pathmark::preview
