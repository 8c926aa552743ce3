// How often a series of verdicts calls noise a difference.
#include "preview/compare/looks.h"
#include "preview/compare/compare_session.h"

#include "support/test_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pathmark::test {
namespace {

using namespace preview;
using testing::Uniforms;

TEST(Looks, TheirRatesAddUpToTheWhole) {
  const Looks looks(0.01);
  double sum = 0.0;
  for (int k = 1; k <= 100000; ++k) sum += looks.alphaOf(k);
  EXPECT_LT(sum, 0.01);
  EXPECT_NEAR(sum, 0.01, 1e-6);
}

TEST(Looks, TheyAreTakenWhenTheRaysHaveDoubled) {
  Looks looks(0.01);
  EXPECT_TRUE(looks.due(3.0));
  looks.take(3.0);
  EXPECT_FALSE(looks.due(5.9));
  EXPECT_TRUE(looks.due(6.0));
  looks.take(100.0);
  EXPECT_FALSE(looks.due(199.0));
  EXPECT_EQ(looks.taken(), 2);
}

constexpr double kRate = 0.2;
constexpr int kSeries = 1000;

// Whether any verdict of a series of six looks is that they differ.
bool everDiffers(CompareSession& session, const ReferenceWish& wish, NoisySeries& series) {
  bool differs = false;
  for (int passes = 1, before = 0; passes <= 32; before = passes, passes *= 2) {
    series.addPasses(passes - before);
    const auto result = session.compare({series.picture(), wish, View::kPicture});
    differs = differs || result->verdict.judgement == Judgement::kDiffers;
  }
  return differs;
}

class SeriesOfLooks : public ::testing::TestWithParam<std::uint32_t> {};

// The bound is five standard deviations of the count above the declared rate: exceeded with a
// probability below 1e-6. Tests that are repeated at the whole rate have one of about 0.3.
TEST_P(SeriesOfLooks, RaisesNoMoreFalseAlarmsThanDeclared) {
  Uniforms random(41 + GetParam());
  const auto scene = testScene(8, 8);
  const auto mean = [](int column, int row) { return 1.0 + (column * 7 + row * 3) % 11; };
  NoisySeries reference(scene, 1000000, random, mean, 16);
  reference.addPasses(512);
  const ReferenceWish wish{
      .source = ReferenceSource::kKept, .kept = reference.picture(), .number = 1};
  CompareSession session(kRate);
  int alarms = 0;
  for (int k = 1; k <= kSeries; ++k) {
    NoisySeries series(scene, static_cast<std::uint64_t>(k), random, mean, GetParam());
    alarms += everDiffers(session, wish, series) ? 1 : 0;
  }
  const double rate = static_cast<double>(alarms) / kSeries;
  RecordProperty("rate", std::to_string(rate));
  EXPECT_LE(rate, kRate + 5.0 * std::sqrt(kRate * (1.0 - kRate) / kSeries));
}

INSTANTIATE_TEST_SUITE_P(Replicates, SeriesOfLooks, ::testing::Values(4u, 8u));

// At the end each pixel has a standard error of 6 %, the mean of 100 of them one of 0.6 %: 10 % are
// overlooked with a probability below 1e-9.
TEST(SeriesOfLooks, FindsADifference) {
  Uniforms random(43);
  const auto scene = testScene(10, 10);
  NoisySeries reference(
      scene, 2, random, [](int, int) { return 1.0; }, 16);
  reference.addPasses(512);
  CompareSession session(kRate);
  NoisySeries series(scene, 1, random, [](int, int) { return 1.1; });
  EXPECT_TRUE(everDiffers(
      session, {.source = ReferenceSource::kKept, .kept = reference.picture(), .number = 1},
      series));
}

}  // namespace
}  // namespace pathmark::test
