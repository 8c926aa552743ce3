// What is seen in the picture area, and when it is made anew.
#include "preview/compare/shown.h"

#include "support/test_pictures.h"

#include <gtest/gtest.h>

#include <vector>

namespace pathmark::test {
namespace {

using namespace preview;

constexpr int kWidth = 10, kHeight = 3;

Image filled(float value) {
  return {kWidth, kHeight, std::vector<float>(3 * kWidth * kHeight, value)};
}

// The picture is black, the reference white.
class ShownTest : public ::testing::Test {
 protected:
  ShownTest() {
    request_.picture =
        std::make_shared<const Picture>(pictureOf(testScene(kWidth, kHeight), filled(0.0f)));
    CompareResult result;
    result.picture = request_.picture;
    result.wish = request_.wish = 5;
    result.found.reference = std::make_shared<const Reference>(
        Reference{std::make_shared<const Image>(filled(1.0f)), 0, "white", 0, 1});
    request_.result = std::make_shared<const CompareResult>(std::move(result));
  }

  // Red of each column of the first row; the other rows must be the same.
  std::vector<int> columns(const Shown& shown) {
    std::vector<int> first;
    for (std::size_t i = 0; i < shown.rgba.size() / 4; ++i) {
      if (i < kWidth) first.push_back(shown.rgba[4 * i]);
      EXPECT_EQ(shown.rgba[4 * i], first[i % kWidth]) << i;
    }
    return first;
  }

  ShownRequest request_;
  ShownMaker maker_;
};

TEST_F(ShownTest, TheSliderHasThePictureOnItsLeftAndTheReferenceOnItsRight) {
  request_.view = View::kSlider;
  for (const auto& [slider, split] :
       {std::pair(0.0, 0), {0.31, 3}, {0.5, 5}, {1.0, 10}, {7.0, 10}}) {
    request_.slider = slider;
    const std::vector<int> row = columns(maker_.make(request_));
    for (int column = 0; column < kWidth; ++column)
      EXPECT_EQ(row[static_cast<std::size_t>(column)], column < split ? 0 : 255)
          << slider << ", column " << column;
  }
}

TEST_F(ShownTest, ThePictureAndTheReferenceAreShownAlone) {
  EXPECT_EQ(columns(maker_.make(request_)), std::vector<int>(kWidth, 0));
  request_.view = View::kReference;
  EXPECT_EQ(columns(maker_.make(request_)), std::vector<int>(kWidth, 255));
}

TEST_F(ShownTest, ItIsMadeAnewOnlyWhenThereIsSomethingElseToSee) {
  request_.view = View::kSlider;
  std::uint64_t version = maker_.make(request_).version;
  EXPECT_EQ(maker_.make(request_).version, version);
  // The same result in another object.
  request_.result = std::make_shared<const CompareResult>(*request_.result);
  request_.slider = 0.501;
  EXPECT_EQ(maker_.make(request_).version, version);
  const auto expectsAnother = [&](const char* what) {
    const std::uint64_t now = maker_.make(request_).version;
    EXPECT_NE(now, version) << what;
    version = now;
  };
  request_.slider = 0.8;
  expectsAnother("slider");
  request_.display.exposure = 2.0;
  expectsAnother("exposure");
  request_.display.curve = ToneCurve::kFilmic;
  expectsAnother("tone curve");
  Picture newer = *request_.picture;
  newer.version = 2;
  newer.image = filled(0.5f);
  request_.picture = std::make_shared<const Picture>(newer);
  expectsAnother("picture");
  EXPECT_GT(columns(maker_.make(request_))[0], 0);
  CompareResult result = *request_.result;
  result.found.reference = std::make_shared<const Reference>(
      Reference{std::make_shared<const Image>(filled(0.0f)), 0, "black", 0, 2});
  request_.result = std::make_shared<const CompareResult>(result);
  expectsAnother("reference");
  EXPECT_EQ(columns(maker_.make(request_))[9], 0);
  request_.view = View::kPicture;
  expectsAnother("view");
}

TEST_F(ShownTest, WithoutAReferenceThePictureIsShown) {
  const auto expectsThePicture = [&] {
    for (const View view : {View::kReference, View::kSlider, View::kError, View::kScores}) {
      request_.view = view;
      EXPECT_EQ(columns(maker_.make(request_)), std::vector<int>(kWidth, 0));
      EXPECT_EQ(maker_.view(), View::kPicture);
    }
  };
  const auto result = request_.result;
  request_.wish = 6;  // what is there is not what is wished for now
  expectsThePicture();
  request_.wish = 5;
  CompareResult other = *result;
  const Image wide{2 * kWidth, kHeight, std::vector<float>(6 * kWidth * kHeight, 1.0f)};
  other.found.reference = std::make_shared<const Reference>(
      Reference{std::make_shared<const Image>(wide), 0, "wide", 0, 3});
  request_.result = std::make_shared<const CompareResult>(other);
  expectsThePicture();
  request_.result = nullptr;
  expectsThePicture();
}

TEST_F(ShownTest, NumbersAreShownInTheirColours) {
  CompareResult result = *request_.result;
  Image picture = filled(0.0f);
  picture.variance.assign(picture.rgb.size(), 1.0f);
  result.colours = noiseColours(picture);
  request_.result = std::make_shared<const CompareResult>(result);
  request_.view = View::kNoise;
  EXPECT_EQ(maker_.make(request_).rgba, result.colours.rgba);
  EXPECT_EQ(maker_.view(), View::kNoise);
}

TEST(Shown, WithoutAPictureThereIsNothing) {
  ShownMaker maker;
  EXPECT_EQ(maker.make({}).width, 0);
}

}  // namespace
}  // namespace pathmark::test
