// How evenly the samplers' points lie, and how fast the errors of estimates fall.
#include "sampling/pixel_sampler.h"
#include "stats/moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pathmark::test {
namespace {

constexpr SamplerKind kKinds[] = {SamplerKind::kSobol, SamplerKind::kStratified, SamplerKind::kPcg};

// Pair number `pair` of the first rays of a pixel, in passes of at most 64.
std::vector<vec2> pairsOf(PixelSampler& sampler, int pixel, int rays, int pair) {
  constexpr int kPass = 64;
  std::vector<vec2> points;
  for (int ray = 0; ray < rays; ++ray) {
    if (ray % kPass == 0) sampler.startPixel(pixel % 100, pixel / 100, std::uint64_t(ray));
    sampler.startRay(ray % kPass);
    for (int k = 0; k < pair; ++k) sampler.next2D();
    points.push_back(sampler.next2D());
  }
  return points;
}

// The square of the L2 star discrepancy: the mean over all boxes [0,a) x [0,b) of the squared
// difference of the share of points in them and their area (Warnock 1972).
double discrepancy2(const std::vector<vec2>& points) {
  const auto n = static_cast<double>(points.size());
  double single = 0.0, both = 0.0;
  for (const vec2& p : points) {
    const double x = static_cast<double>(p.x), y = static_cast<double>(p.y);
    single += (1.0 - x * x) * (1.0 - y * y) / 4.0;
    for (const vec2& q : points)
      both += (1.0 - std::max(x, static_cast<double>(q.x))) *
              (1.0 - std::max(y, static_cast<double>(q.y)));
  }
  return 1.0 / 9.0 - 2.0 / n * single + both / (n * n);
}

// Six standard errors apart: a wrong order of equal samplers has probability below 1e-8, and the
// difference to be seen is many times larger.
void expectLess(const stats::RunningMoments& a, const stats::RunningMoments& b, const char* what) {
  EXPECT_LT(a.mean() + 6.0 * std::hypot(a.standardError(), b.standardError()), b.mean()) << what;
}

TEST(PointQuality, SobolPairsHaveLessDiscrepancyThanStratifiedOnesAndThoseLessThanRandomOnes) {
  for (const int rays : {16, 64, 256})
    for (const int pair : {1, 2, 12}) {
      std::vector<stats::RunningMoments> discrepancy(3);
      for (std::size_t kind = 0; kind < 3; ++kind) {
        const auto sampler =
            makePixelSampler(kKinds[kind], 1, static_cast<std::uint32_t>(std::min(rays, 64)));
        for (int pixel = 0; pixel < (rays == 256 ? 100 : 400); ++pixel)
          discrepancy[kind].add(discrepancy2(pairsOf(*sampler, pixel, rays, pair)));
      }
      expectLess(discrepancy[0], discrepancy[1], "sobol and stratified");
      expectLess(discrepancy[1], discrepancy[2], "stratified and pcg");
      // (1/4 - 1/9) / N for independent points.
      EXPECT_NEAR(discrepancy[2].mean(), (1.0 / 4.0 - 1.0 / 9.0) / rays,
                  6.0 * discrepancy[2].standardError());
    }
}

// The root mean square error, over pixels, of the mean of exp(x y) over the rays.
double rmsError(SamplerKind kind, int rays) {
  // The sum of 1 / (k! (k + 1)^2).
  constexpr double kIntegral = 1.3179021514544038;
  const auto sampler = makePixelSampler(kind, 2, static_cast<std::uint32_t>(std::min(rays, 64)));
  const int pixels = 400;
  double squares = 0.0;
  for (int pixel = 0; pixel < pixels; ++pixel) {
    double sum = 0.0;
    for (const vec2& p : pairsOf(*sampler, pixel, rays, 1))
      sum += std::exp(static_cast<double>(p.x) * static_cast<double>(p.y));
    const double error = sum / rays - kIntegral;
    squares += error * error;
  }
  return std::sqrt(squares / pixels);
}

// Of log error over log rays, from 16 to 4096 rays. Each end is known within 1 / sqrt(2 * 400),
// 3.5%, so that the slope's standard error is 0.035 sqrt(2) / log(256) = 0.009.
double slope(SamplerKind kind) {
  return std::log(rmsError(kind, 4096) / rmsError(kind, 16)) / std::log(4096.0 / 16.0);
}

TEST(PointQuality, ErrorsOfSmoothIntegrandsFallAsTheTheorySays) {
  // Owen 1997: N^-3/2 (log N)^1/2 in two dimensions.
  EXPECT_LT(slope(SamplerKind::kSobol), -1.35);
  EXPECT_NEAR(slope(SamplerKind::kPcg), -0.5, 0.06);
  // Passes are independent of one another.
  const double stratified =
      std::log(rmsError(SamplerKind::kStratified, 4096) / rmsError(SamplerKind::kStratified, 64)) /
      std::log(4096.0 / 64.0);
  EXPECT_NEAR(stratified, -0.5, 0.08);
}

}  // namespace
}  // namespace pathmark::test
