// What is said about a picture and its reference.
#include "preview/compare/compare_session.h"

#include "preview/compare/known_noise.h"
#include "support/test_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pathmark::test {
namespace {

using namespace preview;
using testing::Uniforms;

constexpr int kSide = 32;

double uneven(int column, int row) { return 1.0 + (column * 7 + row * 3) % 11; }

class CompareSessionTest : public ::testing::Test {
 protected:
  // Compares with a kept picture of 8 x 64 passes with the means of `uneven`.
  CompareSessionTest() : scene_(testScene(kSide, kSide)) {
    NoisySeries reference(scene_, 1000, random_, uneven);
    reference.addPasses(64);
    wish_ = {.source = ReferenceSource::kKept, .kept = reference.picture(), .number = 1};
  }

  std::shared_ptr<const CompareResult> compare(std::shared_ptr<const Picture> picture,
                                               View view = View::kPicture) {
    return session_.compare({std::move(picture), wish_, view});
  }

  Uniforms random_{31};
  std::shared_ptr<const PreviewScene> scene_;
  ReferenceWish wish_;
  CompareSession session_;
};

// The standard error of the tile's mean is 0.6 %, so that 10 % are 16 of them; that any of the 15
// other tiles is called different has a probability below 1e-3 / 2.
TEST_F(CompareSessionTest, TheMapOfScoresMarksATileThatIsOffAndNoOther) {
  const auto biased = [](int column, int row) {
    const bool inTile = column >= 24 && row >= 8 && row < 16;
    return uneven(column, row) * (inTile && column < 32 ? 1.1 : 1.0);
  };
  NoisySeries series(scene_, 1, random_, biased);
  series.addPasses(64);
  const auto result = compare(series.picture(), View::kScores);
  ASSERT_EQ(result->colours.view, View::kScores);
  const double full = result->colours.scale.to;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const auto pixel = static_cast<std::size_t>(row * kSide + column);
      const bool inTile = column >= 24 && row >= 8 && row < 16;
      const double z = static_cast<double>(result->colours.values[pixel]);
      EXPECT_EQ(z > full, inTile) << column << ", " << row << ": " << z;
      EXPECT_GT(z, -full);
    }
  EXPECT_EQ(result->verdict.judgement, Judgement::kDiffers);
  EXPECT_EQ(result->verdict.worst.left, 24);
  EXPECT_EQ(result->verdict.worst.top, 8);
  EXPECT_NE(result->verdict.detail.find("1 of 16 tiles differs"), std::string::npos)
      << result->verdict.detail;
  EXPECT_NE(result->verdict.detail.find("columns 24 to 31, rows 8 to 15"), std::string::npos)
      << result->verdict.detail;
}

TEST_F(CompareSessionTest, ItIsTooEarlyToTellWhileTheNoiseIsUnknown) {
  NoisySeries series(
      scene_, 1, random_, [](int, int) { return 5.0; }, 4);
  series.addPasses(4);
  const auto judge = [&](const Picture& picture) {
    return compare(std::make_shared<Picture>(picture), View::kScores);
  };
  Picture fewRays = *series.picture();
  fewRays.raysPerPixel = 4.0 * kRaysOfReplicate - 1.0;
  const auto early = judge(fewRays);
  EXPECT_EQ(early->verdict.judgement, Judgement::kTooEarly);
  EXPECT_FALSE(early->noiseKnown);
  EXPECT_EQ(early->colours.view, View::kPicture);
  EXPECT_FALSE(early->whyNoColours.empty());
  for (const RegionResult& tile : early->comparison->tiles) EXPECT_FALSE(tile.differs);
  Picture without = *series.picture();
  without.image.variance.clear();
  without.replicates = 0;
  EXPECT_EQ(judge(without)->verdict.judgement, Judgement::kTooEarly);
  Picture unknownInOne = *series.picture();
  unknownInOne.image.variance[5] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(judge(unknownInOne)->verdict.judgement, Judgement::kTooEarly);
  EXPECT_EQ(judge(*series.picture())->verdict.judgement, Judgement::kDiffers);
}

TEST_F(CompareSessionTest, VerdictsAreMadeWhenTheRaysHaveDoubled) {
  NoisySeries series(scene_, 1, random_, uneven);
  std::vector<double> judged;
  for (int passes = 1; passes <= 20; ++passes) {
    series.addPasses(1);
    const auto result = compare(series.picture());
    EXPECT_EQ(result->verdict.judgement, Judgement::kSame);
    if (judged.empty() || judged.back() != result->verdict.raysPerPixel)
      judged.push_back(result->verdict.raysPerPixel);
    EXPECT_EQ(result->nextLook, 2.0 * judged.back());
  }
  constexpr double kFirst = 8.0 * NoisySeries::kRaysOfPass;
  EXPECT_EQ(judged, (std::vector<double>{kFirst, 2 * kFirst, 4 * kFirst, 8 * kFirst, 16 * kFirst}));
}

TEST_F(CompareSessionTest, ADifferenceThatWasFoundStaysFoundUntilTheNextSeries) {
  NoisySeries wrong(scene_, 1, random_, [](int, int) { return 9.0; });
  wrong.addPasses(1);
  ASSERT_EQ(compare(wrong.picture())->verdict.judgement, Judgement::kDiffers);
  NoisySeries right(scene_, 1, random_, uneven);
  right.addPasses(64);
  EXPECT_EQ(compare(right.picture())->verdict.judgement, Judgement::kDiffers);
  EXPECT_EQ(compare(right.picture())->verdict.raysPerPixel, 8.0 * NoisySeries::kRaysOfPass);
  NoisySeries next(scene_, 2, random_, uneven);
  next.addPasses(64);
  EXPECT_EQ(compare(next.picture())->verdict.judgement, Judgement::kSame);
}

TEST_F(CompareSessionTest, LooksGoOnAfterAnotherReferenceWasChosenMeanwhile) {
  NoisySeries series(scene_, 1, random_, uneven);
  series.addPasses(1);
  const double first = compare(series.picture())->verdict.raysPerPixel;
  const ReferenceWish kept = wish_;
  wish_ = {.source = ReferenceSource::kShipped, .number = 2};
  series.addPasses(1);
  EXPECT_EQ(compare(series.picture())->verdict.judgement, Judgement::kNone);
  wish_ = kept;
  wish_.number = 3;
  EXPECT_EQ(compare(series.picture())->nextLook, 4.0 * first);
  EXPECT_EQ(compare(series.picture())->nextLook, 4.0 * first);
}

TEST_F(CompareSessionTest, APictureIsNotJudgedByItself) {
  NoisySeries series(scene_, 1, random_, uneven);
  series.addPasses(4);
  wish_ = {.source = ReferenceSource::kKept, .kept = series.picture(), .number = 2};
  series.addPasses(4);
  const auto result = compare(series.picture(), View::kScores);
  EXPECT_EQ(result->verdict.judgement, Judgement::kNone);
  EXPECT_EQ(result->colours.view, View::kPicture);
  EXPECT_FALSE(result->whyNoColours.empty());
  EXPECT_FALSE(result->curves.current().points.back().measured);
}

TEST_F(CompareSessionTest, PixelsThatNeverHaveAValueAreADifferenceAndDoNotDelayTheVerdict) {
  NoisySeries series(scene_, 1, random_, uneven);
  series.addPasses(64);
  Picture picture = *series.picture();
  picture.invalid.nan = 20;
  picture.image.variance[30] = std::numeric_limits<float>::infinity();
  const auto result = compare(std::make_shared<Picture>(picture));
  EXPECT_EQ(result->verdict.judgement, Judgement::kDiffers);
  EXPECT_NE(result->verdict.detail.find("1 pixel has no valid value"), std::string::npos)
      << result->verdict.detail;
}

TEST_F(CompareSessionTest, ErrorsAreThoseOfTheDefinitionAndWhatNoiseExplains) {
  NoisySeries series(scene_, 1, random_, uneven);
  series.addPasses(32);
  const auto result = compare(series.picture());
  const ErrorPoint& point = result->curves.current().points.back();
  EXPECT_EQ(point.measured, result->comparison->relativeMse);
  // 3072 values: a relative standard deviation of 2.6 %.
  EXPECT_NEAR(*point.measured / (*point.expected + *result->referenceNoise), 1.0, 0.2);
}

TEST_F(CompareSessionTest, WithoutAReferenceThereIsNoiseAndAReason) {
  wish_ = {.source = ReferenceSource::kShipped, .number = 2};
  NoisySeries series(scene_, 1, random_, uneven);
  series.addPasses(4);
  const auto noise = compare(series.picture(), View::kNoise);
  EXPECT_FALSE(noise->comparison);
  EXPECT_EQ(noise->colours.view, View::kNoise);
  EXPECT_TRUE(noise->curves.current().points.back().expected);
  EXPECT_EQ(noise->verdict.judgement, Judgement::kNone);
  const auto error = compare(series.picture(), View::kError);
  EXPECT_EQ(error->whyNoColours, error->found.why);
  EXPECT_FALSE(error->found.why.empty());
}

}  // namespace
}  // namespace pathmark::test
