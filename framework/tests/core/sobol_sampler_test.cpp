// Sobol points: nets, exactly, whatever the scrambling; and nearly random orders.
#include "sampling/sobol_sampler.h"
#include "stats/moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace pathmark::test {
namespace {

constexpr int kPairs = 20;  // after the one on the film

using Points = std::vector<vec2>;

struct PointsOfRays {
  std::vector<Points> pairs{kPairs + 1};
  std::vector<Points> singles{kPairs};  // the k-th and a later one, whose pair they need not be
};

// Of the rays [first, first + count) of a pixel, in passes.
PointsOfRays pointsOfRays(SobolSampler& sampler, int pixel, std::uint64_t first,
                          std::uint64_t count, std::uint32_t raysPerPass) {
  PointsOfRays points;
  for (std::uint64_t ray = first; ray < first + count; ++ray) {
    if (ray == first || ray % raysPerPass == 0)
      sampler.startPixel(pixel, 3, ray / raysPerPass * raysPerPass);
    sampler.startRay(static_cast<int>(ray % raysPerPass));
    for (Points& pair : points.pairs) pair.push_back(sampler.next2D());
    for (Points& single : points.singles) single.push_back({sampler.next1D(), 0.0f});
  }
  return points;
}

// Whether every rectangle of the shape 2^-a by 2^-(k-a) has one of the 2^k points, for all a.
bool isNet(const Points& points) {
  const auto k = static_cast<int>(std::lround(std::log2(points.size())));
  for (int a = 0; a <= k; ++a) {
    std::vector<bool> hit(points.size(), false);
    for (const vec2& p : points) {
      const auto column = static_cast<std::size_t>(std::ldexp(p.x, a));
      const auto row = static_cast<std::size_t>(std::ldexp(p.y, k - a));
      hit[(column << (k - a)) + row] = true;
    }
    if (std::find(hit.begin(), hit.end(), false) != hit.end()) return false;
  }
  return true;
}

bool isNetOfSingles(const Points& points) {
  std::vector<bool> hit(points.size(), false);
  for (const vec2& p : points)
    hit[static_cast<std::size_t>(p.x * static_cast<float>(points.size()))] = true;
  return std::find(hit.begin(), hit.end(), false) == hit.end();
}

void expectNets(const PointsOfRays& points, const std::string& what) {
  for (std::size_t k = 1; k <= kPairs; ++k)
    EXPECT_TRUE(isNet(points.pairs[k])) << "pair " << k << ", " << what;
  for (std::size_t k = 0; k < kPairs; ++k)
    EXPECT_TRUE(isNetOfSingles(points.singles[k])) << "single " << k << ", " << what;
}

TEST(SobolSampler, EveryPairIsANetForEveryPowerOfTwoOfRays) {
  for (std::uint64_t rays = 1; rays <= 4096; rays *= 2) {
    const auto raysPerPass = static_cast<std::uint32_t>(std::min<std::uint64_t>(rays, 64));
    SobolSampler sampler(rays, raysPerPass);
    for (int pixel = 0; pixel < (rays <= 256 ? 10 : 2); ++pixel)
      expectNets(pointsOfRays(sampler, pixel, 0, rays, raysPerPass),
                 std::to_string(rays) + " rays");
  }
}

TEST(SobolSampler, EightRaysFromAMultipleOfEightOnAreANet) {
  for (const std::uint32_t raysPerPass : {64u, 50u, 32u, 100u}) {
    SobolSampler sampler(9, raysPerPass);
    for (const std::uint64_t first : {0u, 8u, 40u, 64u, 96u, 1000u})
      expectNets(pointsOfRays(sampler, 1, first, 8, raysPerPass),
                 std::to_string(raysPerPass) + " a pass, ray " + std::to_string(first));
  }
}

TEST(SobolSampler, LaterPassesMakeNetsOfTheirOwn) {
  SobolSampler sampler(4, 64);
  for (const std::uint64_t first : {64u, 128u, 1024u})
    expectNets(pointsOfRays(sampler, 2, first, 64, 64), "ray " + std::to_string(first));
  expectNets(pointsOfRays(sampler, 2, 1024, 1024, 64), "ray 1024");
}

// Ray m of a pass goes into the same stratum of the film in every pass.
TEST(SobolSampler, PlacesWithinAStratumOfTheFilmAreANetOverThePasses) {
  constexpr std::uint32_t kRays = 64;
  SobolSampler sampler(5, kRays);
  for (std::uint64_t passes = 1; passes <= 256; passes *= 4) {
    std::vector<Points> strata(kRays);
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
      sampler.startPixel(7, 8, pass * kRays);
      for (std::uint32_t m = 0; m < kRays; ++m) {
        sampler.startRay(static_cast<int>(m));
        strata[m].push_back(sampler.next2D());
      }
    }
    for (std::uint32_t m = 0; m < kRays; ++m)
      EXPECT_TRUE(isNet(strata[m])) << "stratum " << m << ", " << passes << " passes";
  }
}

TEST(SobolSampler, StrataOfTheFilmHavePlacesOfTheirOwn) {
  SobolSampler sampler(5, 64);
  for (int pixel = 0; pixel < 100; ++pixel) {
    sampler.startPixel(pixel, 8, 64);
    std::set<std::pair<float, float>> places;
    for (int m = 0; m < 64; ++m) {
      sampler.startRay(m);
      const vec2 place = sampler.next2D();
      places.insert({place.x, place.y});
    }
    EXPECT_EQ(places.size(), 64u);
  }
}

TEST(SobolSampler, RaysBeyondTwoToThe32HaveNumbersOfTheirOwn) {
  SobolSampler sampler(5, 64);
  const std::uint64_t far = std::uint64_t{1} << 32;
  expectNets(pointsOfRays(sampler, 2, far, 64, 64), "2^32");
  expectNets(pointsOfRays(sampler, 2, far - 64, 64, 64), "before 2^32");
  const PointsOfRays beginning = pointsOfRays(sampler, 2, 0, 64, 64),
                     after = pointsOfRays(sampler, 2, far, 64, 64);
  for (std::size_t k = 0; k <= kPairs; ++k) EXPECT_NE(beginning.pairs[k], after.pairs[k]);
}

// 64 rays: the mean square error of the product of two centred coordinates of different pairs, over
// that of independent numbers. About 8/7 for orders that keep eight rays together, and 11/7 for
// nested shuffles, in which rays 2k and 2k + 1 are in opposite halves of every dimension.
TEST(SobolSampler, DimensionsOfDifferentPairsHardlyShareAnOrder) {
  constexpr int kRays = 64, kPixels = 20000;
  SobolSampler sampler(6, kRays);
  stats::RunningMoments pairs, singles;
  for (int pixel = 0; pixel < kPixels; ++pixel) {
    sampler.startPixel(pixel % 200, pixel / 200, 0);
    double productOfPairs = 0.0, productOfSingles = 0.0;
    for (int ray = 0; ray < kRays; ++ray) {
      sampler.startRay(ray);
      sampler.next2D();
      const vec2 a = sampler.next2D() - 0.5f, b = sampler.next2D() - 0.5f;
      const float s = sampler.next1D() - 0.5f, t = sampler.next1D() - 0.5f;
      productOfPairs += static_cast<double>(a.x * b.y);
      productOfSingles += static_cast<double>(s * t);
    }
    // The variance of a product of two centred uniform numbers is 1/144.
    pairs.add(productOfPairs * productOfPairs * 144.0 / kRays);
    singles.add(productOfSingles * productOfSingles * 144.0 / kRays);
  }
  // Five standard errors of a mean that is 8/7 stay below.
  for (const stats::RunningMoments& m : {pairs, singles}) {
    EXPECT_LT(m.mean(), 1.2) << m.standardError();
    EXPECT_GT(m.mean(), 0.95) << m.standardError();
  }
}

}  // namespace
}  // namespace pathmark::test
