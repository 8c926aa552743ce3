// Part 4: the modified Phong BRDF, its sampling and its mixture density.
#include "tests/support/direction_cells.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/oracle_phong.h"
#include "tests/support/quadrature.h"

#include <gtest/gtest.h>

#include <array>

namespace pathmark {
namespace {

using namespace testing;

constexpr std::array kExponents{0.0f, 0.5f, 1.0f, 7.3f, 100.0f, 1e4f, 1e6f};
constexpr std::array kCosines{1.0, 0.7, 0.2, 1e-3};

const Colour kKd(0.25f, 0.4f, 0.1f), kKs(0.6f, 0.3f, 0.2f);

// Kd and Ks enter the choice of the lobe by their means.
double diffuseShare(const Colour& kd, const Colour& ks) {
  const glm::dvec3 d(kd), s(ks);
  return (d.x + d.y + d.z) / (d.x + d.y + d.z + s.x + s.y + s.z);
}

glm::dvec3 mirrored(const Vector& wo, const Vector& n) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(n)), w(wo);
  return glm::normalize(2.0 * glm::dot(w, axis) * axis - w);
}

// A direction where the lobe of this exponent has something to say.
Vector nearMirror(const Vector& wo, const Vector& n, float exponent, Uniforms& random) {
  const DoubleFrame frame(mirrored(wo, n));
  const double v = random.nextDouble();
  const double cosine = std::pow(v, 1.0 / (double{exponent} + 1.0));
  return Vector(frame.direction(cosine, random.between(0.0, 2.0 * kPiD)));
}

TEST(PhongBrdf, EqualsTheFormulaInLongDouble) {
  Uniforms random(401);
  for (const float m : kExponents) {
    const phongBRDF brdf(kKd, kKs, m);
    for (int i = 0; i < 5000; ++i) {
      const Vector n = randomUnit(random), wo = atCosine(n, random.nextDouble(), 3.0);
      const Vector wi = i % 2 == 0 ? nearMirror(wo, n, m, random) : randomUnit(random);
      const PhongOracle oracle(wo, wi, n, m);
      if (std::abs(dot(wi, n)) < 1e-6f || std::abs(dot(wo, n)) < 1e-6f) continue;
      if (std::abs(oracle.cosAlpha()) < 1e-6L) continue;
      const double relative = 16.0 * kRoundoff * (1.0 + oracle.condition());
      const Colour f = brdf.brdf(wo, wi, n);
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(isClose(f[c], oracle.brdf(kKd[c], kKs[c]), relative, 1e-30))
            << "exponent " << m << ", alpha " << std::acos(double(oracle.cosAlpha()));
    }
  }
}

TEST(PhongBrdf, IsExactAtTheMirrorDirection) {
  Uniforms random(402);
  for (const float m : kExponents) {
    const phongBRDF brdf(kKd, kKs, m);
    for (int i = 0; i < 1000; ++i) {
      const Vector n = randomUnit(random), wo = atCosine(n, random.between(0.01, 1.0), 3.0);
      const Colour f = brdf.brdf(wo, Vector(mirrored(wo, n)), n);
      for (int c = 0; c < 3; ++c) {
        const double peak = kKd[c] / kPiD + kKs[c] * (double{m} + 2.0) / (2.0 * kPiD);
        EXPECT_TRUE(isClose(f[c], peak, 1e-5)) << "exponent " << m;
      }
    }
  }
}

TEST(PhongBrdf, IsZeroUnlessBothDirectionsAreAbove) {
  const Vector n(0, 0, 1), up = unit(0.3, -0.2, 0.5), down = unit(0.3, 0.2, -0.5), level(1, 0, 0);
  for (const float m : kExponents) {
    const phongBRDF brdf(kKd, kKs, m);
    for (const Vector& wo : {up, down, level}) {
      for (const Vector& wi : {up, down, level}) {
        const bool bothAbove = wo == up && wi == up;
        EXPECT_EQ(brdf.brdf(wo, wi, n) != Colour(0.0f), bothAbove);
      }
    }
  }
}

TEST(PhongBrdf, IsReciprocal) {
  Uniforms random(403);
  for (const float m : kExponents) {
    const phongBRDF brdf(kKd, kKs, m);
    for (int i = 0; i < 2000; ++i) {
      const Vector n = randomUnit(random), wo = atCosine(n, random.between(0.01, 1.0), 3.0);
      const Vector wi = nearMirror(wo, n, m, random);
      const double relative = 32.0 * kRoundoff * (1.0 + PhongOracle(wo, wi, n, m).condition());
      const Colour there = brdf.brdf(wo, wi, n), back = brdf.brdf(wi, wo, n);
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(isClose(there[c], back[c], relative, 1e-30));
    }
  }
}

// In the coordinate v = cos^(m+1)(alpha) the specular lobe has a constant density.
template <typename Function>
double integrateLobe(Function&& f, const glm::dvec3& axis, double m) {
  const DoubleFrame frame(axis);
  return integrate(
      [&](double v) {
        const double cosine = std::pow(v, 1.0 / (m + 1.0));
        const double jacobian = 1.0 / ((m + 1.0) * std::pow(cosine, m));
        return integrate(
            [&](double azimuth) { return jacobian * f(frame.direction(cosine, azimuth)); }, 0.0,
            2.0 * kPiD, 8);
      },
      1e-12, 1.0, 8);
}

// The albedo of a surface that reflects everything, seen from wo.
TEST(PhongBrdf, ReflectsNoMoreThanItReceives) {
  for (const float m : kExponents) {
    const phongBRDF brdf(Colour(0.0f), Colour(1.0f), m);
    for (const Vector& n : {Vector(0, 0, 1), unit(1, -2, 3)}) {
      for (const double cosine : kCosines) {
        const Vector wo = atCosine(n, cosine, 0.5);
        const double albedo = integrateLobe(
            [&](const glm::dvec3& wi) {
              return brdf.brdf(wo, Vector(wi), n).x * glm::dot(glm::dvec3(n), wi);
            },
            mirrored(wo, n), m);
        EXPECT_LE(albedo, 1.0 + 1e-4) << "exponent " << m << ", cosine " << cosine;
        const double atLeast = cosine == 1.0 ? 1.0 - 1e-4 : 0.0;
        EXPECT_GE(albedo, atLeast) << "exponent " << m;
      }
    }
  }
}

TEST(PhongPdf, IsTheMixtureInLongDouble) {
  Uniforms random(404);
  const double share = diffuseShare(kKd, kKs);
  for (const float m : kExponents) {
    const phongBRDF brdf(kKd, kKs, m);
    for (int i = 0; i < 5000; ++i) {
      const Vector n = randomUnit(random), wo = atCosine(n, random.nextDouble(), 3.0);
      const Vector wi = i % 2 == 0 ? nearMirror(wo, n, m, random) : randomUnit(random);
      const PhongOracle oracle(wo, wi, n, m);
      if (std::abs(oracle.cosAlpha()) < 1e-6L) continue;
      const double relative = 16.0 * kRoundoff * (1.0 + oracle.condition());
      EXPECT_TRUE(isClose(brdf.pdf(wo, wi, n), oracle.pdf(share), relative, 4 * kRoundoff))
          << "exponent " << m;
    }
  }
}

TEST(PhongPdf, IntegratesToOneOverTheSphere) {
  for (const float m : kExponents) {
    for (const Vector& n : awkwardNormals()) {
      for (const double cosine : {1.0, 0.3, 1e-3}) {
        const Vector wo = atCosine(n, cosine, 0.5);
        const phongBRDF specular(Colour(0.0f), kKs, m), diffuse(kKd, Colour(0.0f), m);
        const auto lobe = [&](const glm::dvec3& wi) {
          return double{specular.pdf(wo, Vector(wi), n)};
        };
        const auto rest = [&](const glm::dvec3& wi) {
          return double{diffuse.pdf(wo, Vector(wi), n)};
        };
        EXPECT_NEAR(integrateLobe(lobe, mirrored(wo, n), m), 1.0, 1e-4) << "exponent " << m;
        EXPECT_NEAR(integrateDirections(rest, glm::dvec3(n), 0.0, 1.0, 2), 1.0, 1e-5);
        // Behind its own horizon the lobe is empty, for the exponent 0 too.
        EXPECT_NEAR(integrateDirections(lobe, -mirrored(wo, n), 1e-6, 1.0, 1), 0.0, 1e-5);
      }
    }
  }
}

TEST(PhongReflection, ReturnsUnitDirectionsAndTheirDensityForAllInputs) {
  const std::array<std::array<Colour, 2>, 4> reflectances{
      {{kKd, kKs}, {kKd, Colour(0.0f)}, {Colour(0.0f), kKs}, {Colour(0.0f), Colour(0.0f)}}};
  for (const auto& [kd, ks] : reflectances) {
    for (const float m : kExponents) {
      const phongBRDF brdf(kd, ks, m);
      for (const Vector& n : awkwardNormals()) {
        for (const double cosine : {1.0, 0.4, 1e-6, 0.0, -0.3}) {
          const Vector wo = cosine == 1.0 ? n : atCosine(n, cosine, 2.0);
          forEdgeTriples([&](float s, float t, float u) {
            SCOPED_TRACE(::testing::Message()
                         << "exponent " << m << ", s " << s << ", t " << t << ", u " << u);
            const DirectionSample sample = brdf.reflection(wo, n, s, t, u);
            ASSERT_TRUE(isUnit(sample.wi));
            ASSERT_TRUE(std::isfinite(sample.pdf));
            ASSERT_GE(sample.pdf, 0.0f);
            ASSERT_EQ(sample.pdf, brdf.pdf(wo, sample.wi, n));
            const DirectionSample again = brdf.reflection(wo, n, s, t, u);
            ASSERT_EQ(again.wi, sample.wi);
            ASSERT_EQ(again.pdf, sample.pdf);
          });
        }
      }
    }
  }
}

TEST(PhongReflection, OfABlackSurfaceIsNoSample) {
  const phongBRDF black(Colour(0.0f), Colour(0.0f), 7.3f);
  const Vector n(0, 0, 1), wo = unit(1, 0, 1);
  forEdgeTriples(
      [&](float s, float t, float u) { EXPECT_EQ(black.reflection(wo, n, s, t, u).pdf, 0.0f); });
  EXPECT_EQ(black.pdf(wo, n, n), 0.0f);
  EXPECT_EQ(black.brdf(wo, n, n), Colour(0.0f));
}

// At grazing angles half the lobe lies below the surface.
TEST(PhongReflection, KeepsTheDensityOfDirectionsBelowTheSurface) {
  Uniforms random(405);
  const Vector n(0, 0, 1), wo = atCosine(n, 0.05, 1.0);
  const phongBRDF brdf(Colour(0.0f), kKs, 7.3f);
  int below = 0;
  for (int i = 0; i < 1000; ++i) {
    const DirectionSample sample =
        brdf.reflection(wo, n, random.next(), random.next(), random.next());
    if (dot(sample.wi, n) >= 0.0f) continue;
    ++below;
    EXPECT_GT(sample.pdf, 0.0f);
    EXPECT_EQ(brdf.brdf(wo, sample.wi, n), Colour(0.0f));
  }
  EXPECT_GT(below, 300);
}

// Weighted (see WeightedCells), against the mixture that the contract names: closed forms of the
// first two moments of a cosine lobe and of a Phong lobe.
void expectMixture(const Colour& kd, const Colour& ks, float m, const Vector& n, double cosine,
                   Uniforms& random) {
  SCOPED_TRACE(::testing::Message() << "exponent " << m << ", cosine " << cosine << ", Kd " << kd.x
                                    << ", normal " << n.x << " " << n.y << " " << n.z);
  constexpr int kSamples = 30000;
  constexpr std::size_t kZones = 6, kSectors = 8;
  const phongBRDF brdf(kd, ks, m);
  const Vector wo = atCosine(n, cosine, 2.0);
  const double share = diffuseShare(kd, ks), exponent = m;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(n)), mirror = mirrored(wo, n);

  std::vector<double> cosines;
  for (std::size_t i = 0; i <= kZones; ++i)
    cosines.push_back(std::pow(static_cast<double>(i) / kZones, 1.0 / (exponent + 1.0)));
  const DirectionCells partition(mirror, cosines, kSectors);
  std::vector<double> probabilities = partition.probabilities(
      [&](const glm::dvec3& wi) { return share * std::max(glm::dot(normal, wi), 0.0) / kPiD; }, 4);
  for (std::size_t i = 0; i < kZones * kSectors; ++i)
    probabilities[i] += (1.0 - share) / (kZones * kSectors);
  probabilities.back() -= 1.0 - share;
  if (probabilities.back() < 1e-5) probabilities.back() = 0.0;

  stats::WeightedCells cells(partition.count());
  stats::RunningMoments mass, second, mean[3];
  for (int i = 0; i < kSamples; ++i) {
    const DirectionSample sample =
        brdf.reflection(wo, n, random.next(), random.next(), random.next());
    const glm::dvec3 wi(sample.wi);
    const PhongOracle oracle(wo, sample.wi, n, m);
    const double w =
        sample.pdf > 0.0f ? static_cast<double>(oracle.pdf(share)) / double{sample.pdf} : 0.0;
    mass.add(w);
    for (int axis = 0; axis < 3; ++axis) mean[axis].add(w * wi[axis]);
    const double c = glm::dot(wi, mirror);
    second.add(w * c * c);
    if (w > 0.0)
      cells.add(partition.cellOf(wi), w);
    else
      cells.addNone();
  }
  const stats::MeanTest settings{.alpha = kAlpha, .tolerance = 2e-5};
  EXPECT_TRUE(meanIs(mass, 1.0, settings));
  const glm::dvec3 expectedMean =
      share * (2.0 / 3.0) * normal + (1.0 - share) * (exponent + 1.0) / (exponent + 2.0) * mirror;
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_TRUE(meanIs(mean[axis], expectedMean[axis], settings)) << "axis " << axis;
  const double along = glm::dot(mirror, normal) * glm::dot(mirror, normal);
  const double expectedSecond = share * (0.5 * along + 0.25 * (1.0 - along)) +
                                (1.0 - share) * (exponent + 1.0) / (exponent + 3.0);
  EXPECT_TRUE(meanIs(second, expectedSecond, settings));
  EXPECT_TRUE(cellsAre(cells, probabilities, kAlpha));
}

TEST(PhongReflection, IsDistributedByTheMixture) {
  Uniforms random(406);
  for (const float m : kExponents)
    for (const Vector& n : {Vector(0, 0, 1), unit(0, -1e-7, -1), unit(-2, 1, 0.5)})
      for (const double cosine : {0.95, 0.3, 0.02}) expectMixture(kKd, kKs, m, n, cosine, random);
}

TEST(PhongReflection, IsDistributedByTheOnlyLobe) {
  Uniforms random(407);
  for (const float m : kExponents) {
    expectMixture(Colour(0.0f), kKs, m, unit(1, 2, 3), 0.5, random);
    expectMixture(kKd, Colour(0.0f), m, unit(1, 2, 3), 0.5, random);
  }
}

// Where the cosine decides between 1 and 1 - 1e-7, the moments above see little of the lobe:
// (m + 2) (1 - cos(alpha)) has the mean 1 for every exponent.
TEST(PhongReflection, HasTheWidthOfTheLobe) {
  Uniforms random(408);
  for (const float m : kExponents) {
    const phongBRDF brdf(Colour(0.0f), kKs, m);
    const Vector n = unit(1, 2, -3), wo = atCosine(n, 0.6, 2.0);
    const glm::dvec3 mirror = mirrored(wo, n);
    stats::RunningMoments width;
    for (int i = 0; i < 50000; ++i) {
      const Vector wi = brdf.reflection(wo, n, random.next(), random.next(), random.next()).wi;
      const glm::dvec3 difference = glm::normalize(glm::dvec3(wi)) - mirror;
      width.add((double{m} + 2.0) * 0.5 * glm::dot(difference, difference));
    }
    EXPECT_TRUE(meanIs(width, 1.0, {.alpha = kAlpha, .tolerance = 1e-4})) << "exponent " << m;
  }
}

// f cos / pdf, the weight of a path, has the albedo as its mean.
TEST(PhongReflection, CarriesTheAlbedo) {
  Uniforms random(409);
  for (const float m : kExponents) {
    const phongBRDF brdf(kKd, kKs, m), specular(Colour(0.0f), Colour(1.0f), m);
    const Vector n = unit(1, 2, -3);
    for (const double cosine : {0.9, 0.2}) {
      const Vector wo = atCosine(n, cosine, 2.0);
      const double lobe = integrateLobe(
          [&](const glm::dvec3& wi) {
            return specular.brdf(wo, Vector(wi), n).x * glm::dot(glm::dvec3(n), wi);
          },
          mirrored(wo, n), m);
      stats::RunningMoments weight[3];
      for (int i = 0; i < 50000; ++i) {
        const DirectionSample sample =
            brdf.reflection(wo, n, random.next(), random.next(), random.next());
        Colour w(0.0f);
        if (sample.pdf > 0.0f) w = brdf.brdf(wo, sample.wi, n) * (dot(n, sample.wi) / sample.pdf);
        for (int c = 0; c < 3; ++c) weight[c].add(w[c]);
      }
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(meanIs(weight[c], kKd[c] + kKs[c] * lobe, {.alpha = kAlpha, .tolerance = 1e-4}))
            << "exponent " << m << ", cosine " << cosine << ", channel " << c;
    }
  }
}

}  // namespace
}  // namespace pathmark
