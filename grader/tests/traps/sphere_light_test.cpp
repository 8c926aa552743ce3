// A sphere as a light: small, far, at its limb, and from its inside.
#include "checks/sphere_oracle.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/traps/trap.h"

#include <pathmark/lit_scene.h>

#include <set>

namespace pathmark {
namespace {

using namespace testing;
using checks::SphereOracle;

// Shirley, Wang & Zimmerman's formulas, typed in as they are printed.
struct NaiveCone {
  float d, r, cosMax;

  NaiveCone(const Sphere& sphere, const Point& from)
      : d(length(from - sphere.centre())),
        r(sphere.radius()),
        cosMax(std::sqrt(1.0f - (r / d) * (r / d))) {}

  float cosTheta(float s) const { return 1.0f - s * (1.0f - cosMax); }
  float sinTheta(float s) const { return std::sqrt(1.0f - cosTheta(s) * cosTheta(s)); }
  float cosAtPoint(float s) const {
    return std::sqrt(r * r - d * d * sinTheta(s) * sinTheta(s)) / r;
  }
  float pdf(float cosAtPoint, float distance2) const {
    return cosAtPoint / (2.0f * kPi * distance2 * (1.0f - cosMax));
  }
};

// (1 - cos(theta)) / (1 - cos(thetaMax)) of a direction with this sine.
double coneFraction(float sine, const SphereOracle& oracle) {
  const long double sin2 = static_cast<long double>(sine) * sine;
  return static_cast<double>(sin2 / (1.0L + std::sqrt(1.0L - sin2)) / oracle.oneMinusCosMax);
}

TEST(Trap, SphereLightFarAwayKeepsItsManyRadii) {
  constexpr int kSamples = 200000;
  const struct {
    double sinMax;
    std::size_t naiveRadii;
  } cases[] = {{1e-3, 10}, {1e-4, 1}, {1e-6, 1}};
  for (const auto& [sinMax, naiveRadii] : cases) {
    const Sphere sphere(Point(0), 1.0f);
    const Point from(glm::dvec3(unit(1, -2, 3)) / sinMax);
    const SphereOracle oracle(sphere, from);
    const NaiveCone naive(sphere, from);
    std::set<float> naiveSines;
    std::set<double> shippedFractions;
    Errors<Rms> errors;
    for (int i = 0; i < kSamples; ++i) {
      const float s = (static_cast<float>(i) + 0.5f) / kSamples;
      const float sine = naive.sinTheta(s);
      const double shipped = oracle.coneFraction(sphere.sample(from, s, 0.3f).n);
      naiveSines.insert(sine);
      shippedFractions.insert(shipped);
      errors.add(coneFraction(sine, oracle) - double{s}, shipped - double{s});
    }
    EXPECT_LE(naiveSines.size(), naiveRadii) << "sine " << sinMax;
    EXPECT_GT(shippedFractions.size(), std::size_t{kSamples} * 99 / 100) << "sine " << sinMax;
    expectTrap("share of the cone, rms, sine " + std::to_string(sinMax), errors, 1e-6);
  }
}

TEST(Trap, SphereLightFarAwayKeepsItsDensity) {
  for (const double sinMax : {1e-2, 1e-3, 1e-4, 1e-6}) {
    const Sphere sphere(Point(0), 1.0f);
    Uniforms random(1201);
    Errors<Worst> errors;
    for (int i = 0; i < 1000; ++i) {
      const Vector n = randomUnit(random);
      const Point from(glm::dvec3(n) / sinMax);
      const SphereOracle oracle(sphere, from);
      const Vector toFrom = from - n;
      const float naive = NaiveCone(sphere, from).pdf(1.0f, dot(toFrom, toFrom));
      const long double exact = oracle.pdf(n);
      errors.add(relativeError(naive, exact), relativeError(sphere.pdf(from, n, n), exact));
    }
    expectTrap("density, sine " + std::to_string(sinMax), errors, 1e-6);
  }
}

TEST(Trap, SphereLightAtItsLimbKeepsItsCosine) {
  for (const double ratio : {1e-2, 0.1, 0.5, 0.9}) {
    const Sphere sphere(Point(0), 1.0f);
    const Point from(glm::dvec3(unit(1, -2, 3)) / ratio);
    const SphereOracle oracle(sphere, from);
    const NaiveCone naive(sphere, from);
    Errors<Worst> errors;
    for (int k = 1; k < 1 << 16; ++k) {
      const float s = 1.0f - static_cast<float>(k) * 0x1p-24f;
      const long double h = s * oracle.oneMinusCosMax;
      const auto exact = static_cast<double>(
          std::sqrt((1.0L - s) * oracle.oneMinusCosMax * (2.0L - h - oracle.oneMinusCosMax)) /
          oracle.sinMax);
      const auto shipped = oracle.cosAtPoint(sphere.sample(from, s, 0.3f).n);
      errors.add(std::abs(double{naive.cosAtPoint(s)} - exact),
                 std::abs(static_cast<double>(shipped) - exact));
    }
    expectTrap("cosine at the limb, r/d " + std::to_string(ratio), errors, 6e-7);
  }
}

// Receivers in the sphere, and on it, where rounding puts them on either side.
TEST(Trap, SphereLightFromInsideHasTheInverseAreaAsDensity) {
  const Sphere sphere({3, -2, 5}, 1.7f);
  const double expected = 1.0 / (4.0 * kPiD * 1.7 * 1.7);
  Uniforms random(1202);
  Errors<Worst> errors;
  int onEitherSide[2] = {0, 0};
  for (int i = 0; i < 10000; ++i) {
    const float share = i % 2 == 0 ? 1.0f : random.next();
    const Point from = sphere.centre() + share * sphere.radius() * randomUnit(random);
    const bool outside = length(from - sphere.centre()) > sphere.radius();
    ++onEitherSide[outside ? 1 : 0];
    if (outside) continue;
    const LightSample sample = sphere.sample(from, random.next(), random.next());
    ASSERT_TRUE(isUnit(sample.n));
    const Vector toFrom = from - sample.p;
    const float distance2 = dot(toFrom, toFrom);
    const float naive =
        NaiveCone(sphere, from).pdf(dot(sample.n, toFrom) / std::sqrt(distance2), distance2);
    errors.add(relativeError(naive, expected), relativeError(sample.pdf, expected));
  }
  EXPECT_GT(onEitherSide[0], 100);
  EXPECT_GT(onEitherSide[1], 100);
  expectTrap("density from inside", errors, 1e-6);
}

// On the inside of a glowing sphere every sample by area brings pi times the radiance: the two
// cosines over r^2 are 1/(4 r^2). A receiver on the sphere that is rounded to its outside would
// see but the spot that it stands on.
TEST(Trap, SphereLightFromItsSurfaceIsSeenFromTheSideThatShines) {
  const Sphere sphere({3, -2, 5}, 1.7f);
  const Light light(sphere, true, false, Colour(1.0f));
  Uniforms random(1203);
  Errors<Rms> errors;
  for (int i = 0; i < 20000; ++i) {
    const Vector n = -randomUnit(random);  // of the receiver, inwards
    const Point from = sphere.centre() - sphere.radius() * n;
    const float s = random.next(), t = random.next();
    const auto irradiance = [&](const LightSample& y, const Vector& front) {
      const Vector to = y.p - from;
      const float distance2 = dot(to, to), cosX = dot(n, to), cosY = -dot(front, to);
      return double{cosX * cosY / (distance2 * distance2 * y.pdf)};
    };
    const LightSample naive = sphere.sample(from, s, t), shipped = light.sample(from, s, t);
    if (length(shipped.p - from) < 0.1f) continue;  // closer, both are made of rounding
    errors.add(irradiance(naive, -naive.n) / kPiD - 1.0,
               irradiance(shipped, shipped.n) / kPiD - 1.0);
  }
  expectTrap("irradiance on the inside, rms", errors, 1e-5);
}

}  // namespace
}  // namespace pathmark
