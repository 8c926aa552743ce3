// Whatever the sizes of the steps, every pixel gets every ray once and in order.
#include "host/render_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace pathmark::test {
namespace {

struct Pass {
  std::uint64_t seed, firstRay, rays;
  bool operator==(const Pass&) const = default;
};

// The passes of each row, as a worker makes them. Steps take `size()` passes of pixels.
template <class Size>
std::vector<std::vector<Pass>> passesOfRows(const RenderSettings& settings, Size size) {
  RenderState state;
  state.film.resize(settings.pixels());
  std::vector<std::vector<Pass>> rows(static_cast<std::size_t>(settings.height));
  while (!finished(settings, state)) {
    const RenderJob job = nextJob(settings, state, size());
    EXPECT_EQ(job.region.left, 0);
    EXPECT_EQ(job.region.width, settings.width);
    for (int row = job.region.top; row < job.region.top + job.region.height; ++row)
      for (std::uint64_t done = 0; done < job.rays; done += job.raysPerPass)
        rows.at(static_cast<std::size_t>(row))
            .push_back({job.seed, job.firstRay + done,
                        std::min<std::uint64_t>(job.raysPerPass, job.rays - done)});
    const std::uint64_t before = raysMade(settings, state);
    advance(settings, job, state);
    EXPECT_EQ(raysMade(settings, state) - before,
              job.rays * static_cast<std::uint64_t>(job.region.width * job.region.height));
  }
  EXPECT_EQ(raysMade(settings, state), settings.raysPerPixel * settings.pixels());
  return rows;
}

TEST(RenderState, StepsOfAnySizeMakeTheSamePassesInTheSameOrder) {
  std::mt19937 random(1);
  for (const std::uint32_t replicates : {1u, 2u, 5u})
    for (const std::uint64_t each : {1u, 63u, 64u, 65u, 300u})
      for (const int height : {1, 16, 47}) {
        RenderSettings settings;
        settings.width = 13;
        settings.height = height;
        settings.replicates = replicates;
        settings.raysPerPixel = each * replicates;
        const auto atOnce = passesOfRows(settings, [] { return 1e18; });
        std::set<std::uint64_t> seeds;
        for (const Pass& pass : atOnce[0]) seeds.insert(pass.seed);
        EXPECT_EQ(seeds.size(), replicates);
        for (const auto& row : atOnce) ASSERT_EQ(row, atOnce[0]);
        std::uniform_real_distribution<double> exponent(0.0, 4.0);
        const auto inSteps =
            passesOfRows(settings, [&] { return std::pow(10.0, exponent(random)); });
        ASSERT_EQ(inSteps, atOnce) << replicates << " " << each << " " << height;
      }
}

TEST(RenderState, TheFirstReplicateHasTheSeedOfTheImage) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    EXPECT_EQ(replicateSeed(seed, 0), seed);
    for (std::uint64_t replicate = 0; replicate < 1024; ++replicate)
      seeds.insert(replicateSeed(seed, replicate));
  }
  EXPECT_EQ(seeds.size(), 102400u) << "no two are the same";
}

}  // namespace
}  // namespace pathmark::test
