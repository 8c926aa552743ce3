// Throughputs of long paths: denormal numbers, and infinity times zero.
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_rooms.h"
#include "tests/traps/trap.h"

#include <limits>

namespace pathmark {
namespace {

using namespace testing;

bool isDenormal(float x) { return std::fpclassify(x) == FP_SUBNORMAL; }

// Counts the numbers that a path takes.
class CountingSampler final : public Sampler {
 public:
  int numbers = 0;
  void startRay(int m) override {
    random_ = Uniforms(static_cast<std::uint64_t>(m));
    forgetNumbers();
  }

 private:
  void refillSingles() override {
    ++numbers;
    nextSingle_ = kBlock - 1;
    singles_[nextSingle_] = random_.next();
  }

  void refillPairs() override {
    numbers += 2;
    nextPair_ = kBlock - 1;
    pairsX_[nextPair_] = random_.next();
    pairsY_[nextPair_] = random_.next();
  }

  Uniforms random_{0};
};

// Every surface reflects one half, and at most 1000 scattering events are asked for. Paths of 126
// of them would carry a denormal number; by chance one of these goes on for so long once in 2^100
// runs.
TEST(Trap, ThroughputEndsBeforeItIsDenormal) {
  constexpr int kBounces = 1000, kPaths = 100000;
  int naiveDenormals = 0;
  float throughput = 1.0f;
  for (int bounce = 0; bounce < kBounces; ++bounce) {
    throughput *= 0.5f;
    naiveDenormals += isDenormal(throughput) ? 1 : 0;
  }
  EXPECT_GT(naiveDenormals, 20);

  const TestScene scene(furnace());
  const LitScene lit = scene.lit(kBounces);
  CountingSampler sampler;
  int longest = 0;
  for (int m = 0; m < kPaths; ++m) {
    sampler.startRay(m);
    sampler.numbers = 0;
    lit.tracePath({{-1, -1, 0.5f}, unit(1, 0.3, 0.2)}, sampler);
    longest = std::max(longest, sampler.numbers);
  }
  // Two for each of two lights, two for the direction, one for the lobe and one for the roulette.
  constexpr int kNumbersPerVertex = 8;
  expectTrap("scattering events of the longest path", kBounces, double(longest) / kNumbersPerVertex,
             100.0);
}

// Survival in proportion to the throughput: the inverse of a denormal number is infinite, and zero
// times that is no number.
TEST(Trap, RouletteOfDenormalThroughputKeepsItFinite) {
  const TestScene empty{SceneBuilder()};
  const LitScene scene = empty.lit(1000);
  Errors<Worst> errors;
  for (const bool flush : {false, true}) {
    const FlushDenormals mode(flush);
    for (const float carried : {0.0f, std::numeric_limits<float>::denorm_min(), 1e-40f, 1e-39f}) {
      const volatile float q = std::min(carried, 1.0f);
      const float naive = carried * (1.0f / q);
      const Roulette roulette = scene.RussianRoulette(Colour(carried, 0.0f, 0.0f), 10, 0.0f);
      const float shipped = roulette.survives ? carried * roulette.weight : 0.0f;
      errors.add(double{naive}, double{shipped});
    }
  }
  expectTrap("throughput that goes on", errors, 1e-30);
}

}  // namespace
}  // namespace pathmark
