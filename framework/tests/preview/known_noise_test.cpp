// Whether a picture's noise is known well enough.
#include "preview/compare/known_noise.h"

#include "support/test_images.h"
#include "support/test_pictures.h"

#include <gtest/gtest.h>

#include <limits>

namespace pathmark::test {
namespace {

using namespace preview;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class KnownNoise : public ::testing::Test {
 protected:
  std::shared_ptr<const Image> known() const {
    return imageWithKnownNoise(std::make_shared<Picture>(picture_));
  }

  Picture picture_ = pictureOf(testScene(8, 8), gradientImage(8, 8, 0.1f), 2);
};

TEST_F(KnownNoise, IsThatOfTwoReplicatesWithEnoughRays) {
  picture_.raysPerPixel = 2.0 * kRaysOfReplicate;
  ASSERT_NE(known(), nullptr);
  EXPECT_EQ(known()->rgb, picture_.image.rgb);
  EXPECT_TRUE(known()->invalid.empty());
  picture_.replicates = 3;
  EXPECT_EQ(known(), nullptr);
  picture_.replicates = 1;
  EXPECT_EQ(known(), nullptr);
  picture_.replicates = 2;
  picture_.image.variance.clear();
  EXPECT_EQ(known(), nullptr);
}

TEST_F(KnownNoise, MustBeThatOfAllPixelsThatHaveOnlyRadiance) {
  picture_.image.variance[50] = kInfinity;
  EXPECT_EQ(known(), nullptr);
  picture_.invalid.negative = 3;
  ASSERT_NE(known(), nullptr);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(known()->invalid[i], i == 16 ? 1 : 0);
  picture_.image.variance.assign(192, kInfinity);
  EXPECT_EQ(known(), nullptr);
}

}  // namespace
}  // namespace pathmark::test
