// Part 5: how tracePath asks the roulette, and what it does with the answer. This program is
// linked with a stand-in for part 6 that ends seven paths of ten.
#include "sampling/pcg_sampler.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/edge_sampler.h"
#include "tests/support/expect.h"
#include "tests/support/test_rooms.h"

#include <gtest/gtest.h>

namespace pathmark {
namespace {

using namespace testing;

constexpr float kSurvival = 0.3f;

struct Question {
  Colour throughput;
  int depth;
};

std::vector<Question> asked;

// The furnace, whose throughput is halved at each scattering event and divided by the survival
// probability at each survival.
class TracePathWithRoulette : public ::testing::Test {
 protected:
  Colour trace(int bounces, int m) {
    sampler_.startRay(m);
    asked.clear();
    return scene_.lit(bounces).tracePath({{-1, 0.5f, 0.3f}, randomUnit(random_)}, sampler_);
  }

  void SetUp() override { sampler_.startPixel(0, 0, 0); }

  TestScene scene_{furnace()};
  PcgSampler sampler_{531};
  Uniforms random_{532};
};

TEST_F(TracePathWithRoulette, KeepsItsMean) {
  for (const int bounces : {2, 3, 8}) {
    stats::RunningMoments mean;
    for (int m = 0; m < 400000; ++m) mean.add(trace(bounces, m).x);
    EXPECT_TRUE(
        meanIs(mean, 1.0 - std::ldexp(1.0, -(bounces + 1)), {.alpha = kAlpha, .tolerance = 1e-5}))
        << bounces << " bounces";
  }
}

TEST_F(TracePathWithRoulette, TellsTheNumberOfScatteringEvents) {
  for (int m = 0; m < 2000; ++m) {
    trace(8, m);
    // The eighth event has no way on: asking there or not is the path tracer's business.
    ASSERT_GE(asked.size(), 1u);
    ASSERT_LE(asked.size(), 8u);
    for (std::size_t k = 0; k < asked.size(); ++k) ASSERT_EQ(asked[k].depth, int(k) + 1);
  }
}

TEST_F(TracePathWithRoulette, AsksWithTheUpdatedThroughput) {
  for (int m = 0; m < 2000; ++m) {
    trace(8, m);
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const double expected = 0.5 * std::pow(0.5 / double{kSurvival}, double(k));
      for (int c = 0; c < 3; ++c)
        ASSERT_TRUE(isClose(asked[k].throughput[c], expected, 1e-4)) << "event " << k + 1;
    }
  }
}

// A density of 0 says "no sample": dividing by it gives what is not a number, and a roulette that
// does not look at the throughput lets it through.
TEST_F(TracePathWithRoulette, EndsWhereThereIsNoSample) {
  EdgeSampler edges;
  for (int m = 0; m < 20000; ++m) {
    edges.startRay(m);
    asked.clear();
    const Ray ray{{-1, 0.5f, 0.3f}, randomUnit(random_)};
    ASSERT_TRUE(isFinite(scene_.lit(8).tracePath(ray, edges)));
    for (const Question& question : asked) ASSERT_TRUE(isFinite(question.throughput));
  }
}

}  // namespace

Roulette LitScene::RussianRoulette(const Colour& throughput, int depth, float u) const {
  asked.push_back({throughput, depth});
  if (u < kSurvival) return {true, 1.0f / kSurvival};
  return {false, 0.0f};
}

}  // namespace pathmark
