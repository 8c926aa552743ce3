// Random numbers in float: 32 bits times 2^-32 can round to 1.
#include "checks/pcg2d.h"
#include "sampling/pixel_sampler.h"
#include "tests/traps/trap.h"

#include <pathmark/warmup.h>

#include <algorithm>
#include <memory>

namespace pathmark {
namespace {

using namespace testing;
using checks::seedOf;

constexpr float kLargest = 1.0f - 0x1p-24f;

float naiveNumber(std::uint32_t bits) { return static_cast<float>(bits) * 0x1p-32f; }

TEST(Trap, RandomNumbersOfTheWarmUpStayBelowOne) {
  int naiveOnes = 0, shippedOnes = 0;
  float largest = 0.0f;
  for (std::uint32_t k = 0; k < 1024; ++k) {
    const std::uint32_t bits = 0xffffffffu - k;
    uvec2 seed = seedOf({bits, bits});
    const vec2 u = get_random_numbers(seed);
    ASSERT_EQ(seed, uvec2(bits));
    largest = std::max({largest, u.x, u.y});
    naiveOnes += naiveNumber(bits) >= 1.0f ? 1 : 0;
    shippedOnes += u.x >= 1.0f || u.y >= 1.0f ? 1 : 0;
  }
  EXPECT_EQ(naiveOnes, 128);
  EXPECT_EQ(shippedOnes, 0);
  EXPECT_EQ(largest, kLargest);
}

// Until the largest of all numbers turns up: among 2^28 independent numbers it is missing with the
// probability exp(-16) = 1e-7, and no more likely among evenly spread ones.
TEST(Trap, RandomNumbersOfSamplersStayBelowOne) {
  constexpr int kSide = 256, kRays = 64, kNumbers = 64;
  for (const SamplerKind kind :
       {SamplerKind::kSobol, SamplerKind::kStratified, SamplerKind::kPcg}) {
    SCOPED_TRACE(nameOf(kind));
    const std::unique_ptr<PixelSampler> sampler = makePixelSampler(kind, 1, kRays);
    float smallest = 1.0f, largest = 0.0f;
    bool naiveIsOne = false, onGrid = true;
    for (int pixel = 0; pixel < kSide * kSide && !naiveIsOne; ++pixel) {
      sampler->startPixel(pixel % kSide, pixel / kSide, 0);
      for (int ray = 0; ray < kRays; ++ray) {
        sampler->startRay(ray);
        for (int k = 0; k < kNumbers; ++k) {
          const float number = sampler->next1D();
          smallest = std::min(smallest, number);
          largest = std::max(largest, number);
          const auto upper = static_cast<std::uint32_t>(number * 0x1p24f);
          onGrid = onGrid && static_cast<float>(upper) * 0x1p-24f == number;
          // Of the 256 words that begin with these 24 bits, the largest.
          naiveIsOne = naiveIsOne || naiveNumber(upper << 8 | 0xffu) >= 1.0f;
        }
      }
    }
    EXPECT_TRUE(naiveIsOne);
    EXPECT_TRUE(onGrid);
    EXPECT_EQ(largest, kLargest);
    EXPECT_GE(smallest, 0.0f);
  }
}

}  // namespace
}  // namespace pathmark
