// Part 6: Russian roulette.
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace pathmark {
namespace {

using namespace testing;

// The roulette belongs to a LitScene, and does not look at what is in it.
class RussianRoulette : public ::testing::Test {
 protected:
  TestScene emptyScene_{SceneBuilder()};
  LitScene scene_{emptyScene_.lit(8)};
};

std::vector<Colour> throughputs() {
  std::vector<Colour> result{
      Colour(1.0f),          Colour(0.5f),           Colour(0.2f, 0.01f, 0.3f),
      Colour(1e-3f),         Colour(1e-20f),         Colour(0.0f, 0.0f, 0.4f),
      Colour(1.5f, 0.1f, 0), Colour(0.999f, 0, 0),   Colour(0, 1e-6f, 0),
      Colour(3.0f),          Colour(0.04f, 0.05f, 0)};
  result.emplace_back(0.0f, std::numeric_limits<float>::denorm_min(), 0.0f);
  return result;
}

// In how many equal steps u goes from 0 to 1.
constexpr int kSteps = 4096;

struct Survival {
  double probability = 0.0;  // share of u that survives, to 1/kSteps
  double mean = 0.0;         // of survives * weight
};

Survival survival(const LitScene& scene, const Colour& throughput, int depth) {
  Survival result;
  for (int i = 0; i < kSteps; ++i) {
    const Roulette r = scene.RussianRoulette(throughput, depth, (float(i) + 0.5f) / kSteps);
    if (!r.survives) continue;
    result.probability += 1.0 / kSteps;
    result.mean += double{r.weight} / kSteps;
  }
  return result;
}

TEST_F(RussianRoulette, KeepsTheMeanForEveryThroughputAndDepth) {
  for (const Colour& throughput : throughputs()) {
    for (const int depth : {1, 2, 3, 4, 5, 8, 50, 1000}) {
      const Survival s = survival(scene_, throughput, depth);
      ASSERT_GT(s.probability, 0.0);
      // Half a step of u at the end of the interval, times the weight.
      EXPECT_NEAR(s.mean, 1.0, 0.51 / (kSteps * s.probability) + 1e-5)
          << throughput.x << " " << throughput.y << " " << throughput.z << ", depth " << depth;
    }
  }
}

TEST_F(RussianRoulette, HasOneWeightTheInverseOfItsProbability) {
  for (const Colour& throughput : throughputs()) {
    for (const int depth : {1, 4, 20}) {
      const double q = survival(scene_, throughput, depth).probability;
      for (const float u : kEdgeNumbers) {
        const Roulette r = scene_.RussianRoulette(throughput, depth, u);
        if (!r.survives) continue;
        EXPECT_TRUE(std::isfinite(r.weight));
        EXPECT_GE(r.weight, 1.0f);
        EXPECT_NEAR(1.0 / double{r.weight}, q, 1.0 / kSteps);
      }
    }
  }
}

TEST_F(RussianRoulette, EndsDarkPathsFromTheFourthScatteringOn) {
  for (const Colour& throughput : throughputs()) {
    if (std::max({throughput.x, throughput.y, throughput.z}) > 0.5f) continue;
    for (const int depth : {4, 5, 8, 50, 1000}) {
      const double q = survival(scene_, throughput, depth).probability;
      EXPECT_GE(q, 0.05 - 1.0 / kSteps);
      EXPECT_LE(q, 0.95 + 1.0 / kSteps);
    }
  }
}

TEST_F(RussianRoulette, EndsPathsThatCarryNothing) {
  for (const int depth : {1, 4, 100}) {
    for (const float u : kEdgeNumbers) {
      const Roulette r = scene_.RussianRoulette(Colour(0.0f), depth, u);
      EXPECT_FALSE(r.survives);
      EXPECT_EQ(r.weight, 0.0f);
    }
  }
}

TEST_F(RussianRoulette, AnswersTheSameTwice) {
  for (const Colour& throughput : throughputs()) {
    for (const float u : kEdgeNumbers) {
      const Roulette a = scene_.RussianRoulette(throughput, 5, u);
      const Roulette b = scene_.RussianRoulette(throughput, 5, u);
      EXPECT_EQ(a.survives, b.survives);
      EXPECT_EQ(a.weight, b.weight);
    }
  }
}

}  // namespace
}  // namespace pathmark
