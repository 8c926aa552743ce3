// Part 3: the Lambertian BRDF, its sampling and its density.
#include "tests/support/direction_cells.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"

#include <pathmark/brdf.h>

#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace pathmark {
namespace {

using namespace testing;

const Colour kKd(0.25f, 0.5f, 0.9f);

TEST(LambertianBrdf, IsKdOverPiAboveTheSurface) {
  const lambertianBRDF brdf(kKd);
  for (const Vector& n : awkwardNormals()) {
    for (const double cosine : {1.0, 0.3, 1e-3}) {
      const Colour f = brdf.brdf(atCosine(n, cosine, 1.0), atCosine(n, 0.7, 4.0), n);
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(isClose(f[c], kKd[c] / std::numbers::pi_v<long double>, 2 * 0x1p-24));
    }
  }
}

TEST(LambertianBrdf, IsZeroUnlessBothDirectionsAreAbove) {
  const lambertianBRDF brdf(kKd);
  const Vector n(0, 0, 1), up = unit(0.3, -0.2, 0.5), down = unit(0.3, 0.2, -0.5), level(1, 0, 0);
  for (const Vector& wo : {up, down, level}) {
    for (const Vector& wi : {up, down, level}) {
      const bool bothAbove = wo == up && wi == up;
      EXPECT_EQ(brdf.brdf(wo, wi, n) != Colour(0.0f), bothAbove);
    }
  }
}

TEST(LambertianBrdf, IsReciprocal) {
  const lambertianBRDF brdf(kKd);
  Uniforms random(301);
  for (int i = 0; i < 1000; ++i) {
    const Vector n = randomUnit(random), wo = randomUnit(random), wi = randomUnit(random);
    EXPECT_EQ(brdf.brdf(wo, wi, n), brdf.brdf(wi, wo, n));
  }
}

TEST(LambertianPdf, IsTheCosineOverPi) {
  const lambertianBRDF brdf(kKd);
  Uniforms random(302);
  for (int i = 0; i < 10000; ++i) {
    const Vector n = randomUnit(random), wo = randomUnit(random), wi = randomUnit(random);
    const double cosine = glm::dot(glm::dvec3(n), glm::dvec3(wi));
    const double expected = std::max(cosine, 0.0) / kPiD;
    EXPECT_TRUE(isClose(brdf.pdf(wo, wi, n), expected, 1e-6, 4 * 0x1p-24));
  }
}

TEST(LambertianPdf, IntegratesToOneOverTheSphere) {
  const lambertianBRDF brdf(kKd);
  for (const Vector& n : awkwardNormals()) {
    const Vector wo = atCosine(n, 0.4, 2.0);
    const auto pdf = [&](const glm::dvec3& wi) { return double{brdf.pdf(wo, Vector(wi), n)}; };
    EXPECT_NEAR(integrateDirections(pdf, glm::dvec3(n), 0.0, 1.0, 2), 1.0, 1e-6);
    EXPECT_NEAR(integrateDirections(pdf, glm::dvec3(n), -1.0, 0.0, 2), 0.0, 1e-6);
  }
}

TEST(LambertianReflection, ReturnsUnitDirectionsAboveTheSurfaceForAllInputs) {
  const lambertianBRDF brdf(kKd);
  for (const Vector& n : awkwardNormals()) {
    const Vector wo = atCosine(n, 0.4, 2.0);
    forEdgeTriples([&](float s, float t, float u) {
      SCOPED_TRACE(::testing::Message() << "s " << s << ", t " << t << ", u " << u);
      const DirectionSample sample = brdf.reflection(wo, n, s, t, u);
      ASSERT_TRUE(isUnit(sample.wi));
      ASSERT_TRUE(std::isfinite(sample.pdf));
      ASSERT_GE(sample.pdf, 0.0f);
      // On the horizon a direction may be rounded to below it; it is then no sample.
      ASSERT_GE(dot(glm::dvec3(sample.wi), glm::dvec3(n)), -4 * 0x1p-24);
      ASSERT_TRUE(dot(sample.wi, n) > 0.0f || sample.pdf == 0.0f);
      const DirectionSample again = brdf.reflection(wo, n, s, t, u);
      ASSERT_EQ(again.wi, sample.wi);
      ASSERT_EQ(again.pdf, sample.pdf);
    });
  }
}

TEST(LambertianReflection, ReturnsTheDensityOfItsPdf) {
  const lambertianBRDF brdf(kKd);
  Uniforms random(303);
  for (int i = 0; i < 10000; ++i) {
    const Vector n = randomUnit(random), wo = atCosine(n, random.nextDouble(), 1.0);
    const DirectionSample sample =
        brdf.reflection(wo, n, random.next(), random.next(), random.next());
    EXPECT_TRUE(isClose(sample.pdf, brdf.pdf(wo, sample.wi, n), 1e-6));
  }
}

// In the weighted form (see WeightedCells): any sampler with a true density passes.
TEST(LambertianReflection, IsDistributedByTheCosine) {
  const lambertianBRDF brdf(kKd);
  Uniforms random(304);
  constexpr int kSamples = 20000;
  for (const Vector& n : awkwardNormals()) {
    SCOPED_TRACE(::testing::Message() << n.x << " " << n.y << " " << n.z);
    const glm::dvec3 axis(n);
    const Vector wo = atCosine(n, 0.4, 2.0);
    const auto density = [&](const glm::dvec3& wi) {
      return std::max(glm::dot(axis, wi), 0.0) / kPiD;
    };
    const DoubleFrame frame(axis);
    const DirectionCells partition(axis, {0.0, 0.3, 0.6, 0.8, 0.9, 0.97, 1.0}, 8);
    stats::WeightedCells cells(partition.count());
    stats::RunningMoments mass, cosine, cosineSquared, alongU, alongV, twofold;
    for (int i = 0; i < kSamples; ++i) {
      const DirectionSample sample =
          brdf.reflection(wo, n, random.next(), random.next(), random.next());
      const glm::dvec3 wi(sample.wi);
      const double w = sample.pdf > 0.0f ? density(wi) / double{sample.pdf} : 0.0;
      const double c = glm::dot(wi, axis), u = glm::dot(wi, frame.u), v = glm::dot(wi, frame.v);
      mass.add(w);
      cosine.add(w * c);
      cosineSquared.add(w * c * c);
      alongU.add(w * u);
      alongV.add(w * v);
      twofold.add(w * u * v);
      if (sample.pdf > 0.0f)
        cells.add(partition.cellOf(wi), w);
      else
        cells.addNone();
    }
    const stats::MeanTest settings{.alpha = kAlpha, .tolerance = 1e-6};
    EXPECT_TRUE(meanIs(mass, 1.0, settings));
    EXPECT_TRUE(meanIs(cosine, 2.0 / 3.0, settings));
    EXPECT_TRUE(meanIs(cosineSquared, 0.5, settings));
    EXPECT_TRUE(meanIs(alongU, 0.0, settings));
    EXPECT_TRUE(meanIs(alongV, 0.0, settings));
    EXPECT_TRUE(meanIs(twofold, 0.0, settings));
    EXPECT_TRUE(cellsAre(cells, partition.probabilities(density, 1), kAlpha));
  }
}

// f cos / pdf is Kd for every sample of the cosine density.
TEST(LambertianReflection, CarriesTheAlbedoWithoutNoise) {
  const lambertianBRDF brdf(kKd);
  Uniforms random(305);
  for (int i = 0; i < 10000; ++i) {
    const Vector n = randomUnit(random), wo = atCosine(n, 0.2, 1.0);
    const DirectionSample sample =
        brdf.reflection(wo, n, random.next(), random.next(), random.next());
    if (sample.pdf == 0.0f) continue;
    const Colour weight = brdf.brdf(wo, sample.wi, n) * (dot(n, sample.wi) / sample.pdf);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(isClose(weight[c], kKd[c], 8 * 0x1p-24));
  }
}

}  // namespace
}  // namespace pathmark
