// The specular lobe: large exponents, the exponent 0, exponents between integers, and its back.
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/oracle_phong.h"
#include "tests/traps/trap.h"

#include <set>

namespace pathmark {
namespace {

using namespace testing;

const Colour kBlack(0.0f), kWhite(1.0f);

Vector mirrorOf(const Vector& wo, const Vector& n) { return 2.0f * dot(wo, n) * n - wo; }

// Sine of the angle between two directions.
long double sine(const Vector& a, const Vector& b) {
  const LongVector x = PhongOracle::normalise(a), y = PhongOracle::normalise(b);
  const LongVector c = glm::cross(x, y);
  return std::sqrt(glm::dot(c, c));
}

// Relative to the oracle's sine of alpha. A float direction is itself off by half a roundoff.
TEST(Trap, PhongLobeOfALargeExponentKeepsItsAngles) {
  constexpr int kSamples = 20000;
  for (const float m : {1e4f, 1e5f, 1e6f}) {
    const phongBRDF brdf(kBlack, kWhite, m);
    Uniforms random(1501);
    const Vector n(0, 0, 1);
    Errors<Rms> errors;
    std::set<float> naiveAngles;
    std::set<long double> shippedSines;
    for (int i = 0; i < kSamples; ++i) {
      const Vector wo = n;  // the mirror direction, exactly
      const float t = (static_cast<float>(i) + 0.5f) / kSamples;
      const float alpha = std::acos(std::pow(t, 1.0f / (m + 1.0f)));
      naiveAngles.insert(alpha);
      const long double expected = std::sqrt(-std::expm1(2.0L * std::log(1.0L * t) / (m + 1.0L)));
      const Vector wi = brdf.reflection(wo, n, random.next(), t, 0.5f).wi;
      const long double shipped = sine(wi, n);
      shippedSines.insert(shipped);
      errors.add(double(std::sin(1.0L * alpha) / expected - 1.0L),
                 double(shipped / expected - 1.0L));
    }
    expectTrap("share of repeated angles, exponent " + std::to_string(m),
               1.0 - double(naiveAngles.size()) / kSamples,
               1.0 - double(shippedSines.size()) / kSamples, 0.05);
    expectTrap("sine of alpha, rms, exponent " + std::to_string(m), errors, 2e-4);
  }
}

TEST(Trap, PhongLobeOfALargeExponentKeepsItsValue) {
  for (const float m : {1e4f, 1e5f, 1e6f}) {
    const phongBRDF brdf(kBlack, kWhite, m);
    Uniforms random(1502);
    Errors<Rms> errors;
    for (int i = 0; i < 20000; ++i) {
      const Vector n = randomUnit(random), wo = atCosine(n, random.between(0.5, 1.0), 3.0);
      const Vector wi = brdf.reflection(wo, n, random.next(), random.next(), 0.5f).wi;
      const PhongOracle oracle(wo, wi, n, m);
      if (!oracle.bothAbove()) continue;
      const float naive = (m + 2.0f) / (2.0f * kPi) * std::pow(dot(wi, mirrorOf(wo, n)), m);
      const long double exact = oracle.brdf(0.0L, 1.0L);
      // What a rounding of the directions alone changes.
      const double condition = 1.0 + oracle.condition();
      errors.add(relativeError(naive, exact) / condition / kRoundoff,
                 relativeError(brdf.brdf(wo, wi, n).x, exact) / condition / kRoundoff);
    }
    expectTrap("value over its condition, rms roundoffs, exponent " + std::to_string(m), errors,
               4.0);
  }
}

// The lobe's own density as the naive weight's denominator is 0 where cos(alpha) is, or where the
// power underflows.
TEST(Trap, PhongWeightIsFiniteWhereThePowerUnderflows) {
  int naiveBad = 0, shippedBad = 0;
  for (const float m : {0.0f, 100.0f, 1e4f, 1e6f}) {
    const phongBRDF brdf(kBlack, kWhite, m);
    for (const Vector& n : awkwardNormals()) {
      const Vector wo = atCosine(n, 0.7, 2.0);
      forEdgePairs([&](float s, float t) {
        const DirectionSample sample = brdf.reflection(wo, n, s, t, 0.5f);
        const float lobe = std::pow(t, m / (m + 1.0f)), cosTheta = dot(n, sample.wi);
        const float naive = (m + 2.0f) * lobe / ((m + 1.0f) * lobe) * cosTheta;
        naiveBad += std::isfinite(naive) ? 0 : 1;
        if (sample.pdf == 0.0f) return;
        const float shipped = brdf.brdf(wo, sample.wi, n).x * cosTheta / sample.pdf;
        shippedBad += std::isfinite(shipped) && shipped <= 2.001f ? 0 : 1;
      });
    }
  }
  expectTrap("weights that are no number", naiveBad, shippedBad, 0.0);
}

// Both directions above the surface, but more than 90 degrees from the mirror direction: there the
// lobe is 0 for every exponent.
TEST(Trap, PhongLobeEndsAtNinetyDegreesForEveryExponent) {
  const struct {
    float exponent;
    const char* naive;
  } cases[] = {{0.0f, "pow(x, 0) is 1"},
               {7.3f, "pow(-x, 7.3) is no number"},
               {2.0f, "pow(-x, 2) is positive"}};
  for (const auto& [m, naiveFault] : cases) {
    const phongBRDF brdf(kBlack, kWhite, m);
    Uniforms random(1503);
    Errors<Worst> errors;
    for (int i = 0; i < 20000; ++i) {
      const Vector n = randomUnit(random), wo = atCosine(n, random.between(0.05, 0.5), 1.0);
      const Vector wi = atCosine(n, random.between(0.05, 0.5), random.between(0.0, 6.0));
      const PhongOracle oracle(wo, wi, n, m);
      if (oracle.cosAlpha() > -1e-6L) continue;
      const float naive = (m + 2.0f) / (2.0f * kPi) * std::pow(dot(wi, mirrorOf(wo, n)), m);
      errors.add(double{naive}, double{brdf.brdf(wo, wi, n).x});
      EXPECT_EQ(brdf.pdf(wo, wi, n), 0.0f);
    }
    expectTrap(naiveFault, errors, 0.0);
  }
}

}  // namespace
}  // namespace pathmark
