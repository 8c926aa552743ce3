// What is expected of samples is one density, whichever way it is asked for: the density itself,
// integrated numerically, the cells of chi-square, and the histograms' coordinates.
#include "preview/samples/sample_domain.h"
#include "preview/sampler_cases.h"
#include "preview/samples/cosine_lobe.h"
#include "preview/samples/direction_frame.h"
#include "preview/samples/flat_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pathmark::preview::test {
namespace {

using F = CourseworkFunction;

constexpr double kPi = std::numbers::pi;

// Places with the part of the domain's measure that they stand for.
struct Node {
  glm::dvec3 place;
  double measure;
};

// Jittered in their strata, so that borders between them make no systematic error.
std::vector<Node> nodesOfSphere(const glm::dvec3& centre, double radius, const glm::dvec3& axis) {
  constexpr int kRings = 1500, kTurns = 500;
  const DirectionFrame frame(axis);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> jitter;
  std::vector<Node> nodes;
  // Closer together next to the axis, where densities may be sharp: cos(theta) = 1 - 2 w^2.
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kTurns; ++j) {
      const double w = (i + jitter(random)) / kRings;
      const double azimuth = 2.0 * kPi * (j + jitter(random)) / kTurns;
      nodes.push_back({centre + radius * frame.direction(1.0 - 2.0 * w * w, azimuth),
                       radius * radius * 4.0 * w / kRings * 2.0 * kPi / kTurns});
    }
  return nodes;
}

std::vector<Node> nodesOfSquare() {
  constexpr int kSide = 600;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> jitter;
  std::vector<Node> nodes;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double x = (i + jitter(random)) / kSide, y = (j + jitter(random)) / kSide;
      nodes.push_back({{x, y, 0.0}, 1.0 / (kSide * kSide)});
    }
  return nodes;
}

// Of the triangles in a polygon's words.
std::vector<Node> nodesOfPolygon(const std::vector<std::uint32_t>& words) {
  constexpr int kSide = 300;
  const auto vertex = [&](std::size_t k) { return vectorAt(words, 5 + 3 * k); };
  std::vector<Node> nodes;
  for (std::size_t t = 0; t < words[1]; ++t) {
    const std::size_t at = 5 + 3 * (words[0] + t);
    const glm::dvec3 a = vertex(words[at]), b = vertex(words[at + 1]), c = vertex(words[at + 2]);
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < 2 * (kSide - i) - 1; ++j) {
        const double third = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;  // centroids of small triangles
        nodes.push_back({a + (i + third) / kSide * (b - a) + (j / 2 + third) / kSide * (c - a),
                         area / (kSide * kSide)});
      }
  }
  return nodes;
}

std::vector<Node> nodesOf(const SampleSettings& s, const SampleDomain& domain) {
  switch (s.function) {
    case F::kGetRandomNumbers:
    case F::kStratifiedRandomRay:
      return nodesOfSquare();
    case F::kTriangularSampling:
    case F::kRectangularSampling:
    case F::kPolygonSampling:
      return nodesOfPolygon(domain.object().words());
    case F::kSphereSample: {
      CallWords call;
      domain.addCall(call, 0, {});
      const glm::dvec3 centre = vectorAt(call.words(), 0);
      return nodesOfSphere(centre, numberAt(call.words(), 3),
                           glm::length(centre) > 0.0 ? -centre : glm::dvec3(0, 1, 0));
    }
    case F::kPhongReflection: {
      CallWords call;
      domain.addCall(call, 0, {});
      const glm::dvec3 wo = vectorAt(call.words(), 0), n = vectorAt(call.words(), 3);
      return nodesOfSphere({}, 1.0, 2.0 * glm::dot(wo, n) * n - wo);
    }
    default: {
      CallWords call;
      domain.addCall(call, 0, {});
      const bool cosine = s.function == F::kLambertianReflection;
      const bool sphere = s.function == F::kSampleSphere;
      return nodesOfSphere({}, 1.0,
                           sphere ? glm::dvec3(0, 0, 1) : vectorAt(call.words(), cosine ? 3 : 2));
    }
  }
}

// Of the numerical integrals. Borders of cells and bars cut through what nodes stand for: of bars
// of a polygon, which are not jittered, through a strip of a triangle 1/300 wide.
constexpr double kQuadrature = 1e-3;

TEST(SampleDomain, DensitiesIntegrateToOneAndToTheirCells) {
  for (const SamplerCase& c : samplerCases()) {
    SCOPED_TRACE(c.name);
    const auto domain = makeSampleDomain(c.settings);
    const SampleDomain::Cells cells = domain->cells(64);
    std::vector<double> sums(cells.masses.size(), 0.0);
    double whole = 0.0;
    for (const Node& node : nodesOf(c.settings, *domain)) {
      const double density = domain->density(node.place);
      if (!(density > 0.0)) continue;
      whole += density * node.measure;
      sums.at(cells.cellOf(node.place)) += density * node.measure;
    }
    EXPECT_NEAR(whole, 1.0, kQuadrature);
    double expected = 0.0;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      EXPECT_NEAR(sums[k], cells.masses[k], kQuadrature) << "cell " << k;
      expected += cells.masses[k];
    }
    EXPECT_NEAR(expected, 1.0, 1e-6);
  }
}

TEST(SampleDomain, DensitiesIntegrateToTheBarsOfTheirHistograms) {
  constexpr std::size_t kBars = 12;
  for (const SamplerCase& c : samplerCases()) {
    const auto domain = makeSampleDomain(c.settings);
    const std::vector<Node> nodes = nodesOf(c.settings, *domain);
    for (const Marginal& marginal : domain->marginals()) {
      SCOPED_TRACE(c.name + ", " + marginal.name);
      std::vector<double> sums(kBars, 0.0);
      double outside = 0.0;
      for (const Node& node : nodes) {
        const double mass = domain->density(node.place) * node.measure;
        if (!(mass > 0.0)) continue;
        const double at =
            (marginal.coordinate(node.place) - marginal.low) / (marginal.high - marginal.low);
        if (at >= -1e-6 && at < 1.0 + 1e-6)
          sums[static_cast<std::size_t>(std::clamp(at * kBars, 0.0, kBars - 0.5))] += mass;
        else
          outside += mass;
      }
      const double step = (marginal.high - marginal.low) / kBars;
      double expected = 0.0;
      for (std::size_t k = 0; k < kBars; ++k) {
        const double from = marginal.low + step * static_cast<double>(k);
        EXPECT_NEAR(sums[k], marginal.mass(from, from + step), kQuadrature) << "bar " << k;
        expected += marginal.mass(from, from + step);
      }
      EXPECT_NEAR(expected + outside, 1.0, kQuadrature);
    }
  }
}

TEST(SampleDomain, OnlyTheAxisAroundASharpLobeLeavesAnythingOut) {
  for (const SamplerCase& c : samplerCases()) {
    const auto domain = makeSampleDomain(c.settings);
    for (const Marginal& marginal : domain->marginals()) {
      SCOPED_TRACE(c.name + ", " + marginal.name);
      if (marginal.name.starts_with("angle to the mirror"))
        EXPECT_NEAR(marginal.mass(0.0, 180.0), 1.0, 1e-6);
      else
        EXPECT_NEAR(marginal.mass(marginal.low, marginal.high), 1.0, 1e-3);
    }
  }
}

TEST(SampleDomain, NothingIsExpectedOffTheDomain) {
  const auto density = [](F function, const glm::dvec3& place) {
    SampleSettings settings;
    settings.function = function;
    return makeSampleDomain(settings)->density(place);
  };
  EXPECT_EQ(density(F::kSampleSphere, {0.0, 0.0, 1.1}), 0.0);
  EXPECT_EQ(density(F::kSampleHemisphere, {0.0, 0.0, -1.0}), 0.0);
  EXPECT_EQ(density(F::kLambertianReflection, {0.0, -1.0, 0.0}), 0.0);
  EXPECT_EQ(density(F::kGetRandomNumbers, {1.0, 0.5, 0.0}), 0.0);
  EXPECT_EQ(density(F::kPolygonSampling, {0.1, 0.2, 0.3}), 0.0);
  EXPECT_EQ(density(F::kSphereSample, {0.0, 0.0, 0.0}), 0.0);
}

// The far side of the sphere is on it, but is not seen.
TEST(SampleDomain, AReceiverDoesNotSeeTheFarSideOfASphere) {
  SampleSettings settings;
  settings.function = F::kSphereSample;
  const auto domain = makeSampleDomain(settings);
  CallWords call;
  domain->addCall(call, 0, {});
  const glm::dvec3 centre = vectorAt(call.words(), 0), axis = glm::normalize(centre);
  EXPECT_GT(domain->density(centre - settings.radius * axis), 0.0);
  EXPECT_EQ(domain->density(centre + settings.radius * axis), 0.0);
}

TEST(FlatPolygon, PartsOfATriangleAreAllFoundAndEquallyLarge) {
  constexpr std::size_t kSide = 5;
  constexpr int kSteps = 600;
  std::vector<int> found(kSide * kSide, 0);
  int all = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; i + j < kSteps; ++j) {
      const double b1 = (i + 0.31) / kSteps, b2 = (j + 0.37) / kSteps;
      if (b1 + b2 >= 1.0) continue;
      ++found.at(partOf({1.0 - b1 - b2, b1, b2}, kSide));
      ++all;
    }
  for (const int count : found)
    EXPECT_NEAR(static_cast<double>(count) / all, 1.0 / (kSide * kSide), 1e-3);
}

TEST(CosineLobe, MassesAndAnglesAreInverseToOneAnother) {
  for (const double m : {0.0, 1.0, 20.0, 12345.6})
    for (const double mass : {0.001, 0.3, 0.999})
      EXPECT_NEAR(CosineLobe{m}.massWithin(CosineLobe{m}.angleWith(mass)), mass, 1e-9);
}

}  // namespace
}  // namespace pathmark::preview::test
