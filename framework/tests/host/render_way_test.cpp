// How bench error is told to render: the words behind an estimator's name.
#include "bench/render_way.h"
#include "host/session.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pathmark::bench {
namespace {

RenderWay wayOf(std::string_view text, std::string_view rest = "solutions") {
  RenderWay way = takeWay(text);
  EXPECT_EQ(text, rest);
  return way;
}

TEST(RenderWay, WithoutWordsIsThatOfRender) {
  const RenderWay way = wayOf("solutions");
  EXPECT_EQ(way.estimator, Estimator::kPath);
  EXPECT_EQ(way.lightSampling, LightSampling::kByArea);
  EXPECT_EQ(way.words, "");
}

TEST(RenderWay, HasTheMeaningOfTheOptionsOfRender) {
  EXPECT_EQ(wayOf("solutions+mis").estimator, Estimator::kMis);
  EXPECT_EQ(wayOf("solutions+mis+solid-angle").lightSampling, LightSampling::kBySolidAngle);
  const RenderWay split = wayOf("solutions+split4+share-direct");
  EXPECT_EQ(split.estimator, Estimator::kSplit);
  EXPECT_EQ(split.sharing.pathsPerRay, 4u);
  EXPECT_EQ(split.sharing.directLight, 1u);
  EXPECT_EQ(split.words, "+split4+share-direct");
  const RenderWay reuse = wayOf("solutions+direct-paths2+reuse16");
  EXPECT_EQ(reuse.estimator, Estimator::kReuse);
  EXPECT_EQ(reuse.sharing.pixels, 16u);
  EXPECT_EQ(reuse.sharing.directPaths, 2u);
  EXPECT_EQ(wayOf("solutions+split1").estimator, Estimator::kPath);
  EXPECT_EQ(wayOf("solutions+reuse1").estimator, Estimator::kPath);
}

TEST(RenderWay, LeavesNamesAndFoldersWithPlusesAlone) {
  wayOf("mine=c++/student+reuse4", "mine=c++/student");
  wayOf("solutions+resue4", "solutions+resue4");
  wayOf("solutions+reuse", "solutions+reuse");
  wayOf("+mis", "");
}

TEST(RenderWay, RefusesWhatRenderDoesNotTake) {
  for (const char* text :
       {"solutions+reuse3", "solutions+reuse128", "solutions+split0", "solutions+split65",
        "solutions+split99999999999", "solutions+mis+split4", "solutions+reuse4+split4",
        "solutions+share-direct", "solutions+direct-paths4", "solutions+split4+split8",
        "solutions+split1+share-direct", "solutions+reuse1+direct-paths8"}) {
    std::string_view rest = text;
    EXPECT_THROW(takeWay(rest), UsageError) << text;
  }
}

}  // namespace
}  // namespace pathmark::bench
