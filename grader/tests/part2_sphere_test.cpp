// Part 2: points on a sphere that is a light.
#include "checks/sphere_oracle.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

namespace pathmark {
namespace {

using namespace testing;
using checks::SphereOracle;

// Radius over distance, from a sphere like a point to one that fills half of what is seen.
constexpr std::array kRatios{1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5, 0.9, 0.99, 1 - 1e-3, 1 - 1e-4};

struct View {
  Sphere sphere;
  Point from;
};

std::vector<View> viewsFromOutside() {
  std::vector<View> views;
  Uniforms random(211);
  for (const double ratio : kRatios) {
    for (const double radius : {1e-6, 1.0, 30.0, 1e6}) {
      const double distance = radius / ratio;
      if (distance > 1e6 * 1.01) continue;
      views.push_back(
          {Sphere(Point(0), float(radius)), Point(distance * glm::dvec3(randomUnit(random)))});
      views.push_back({Sphere(Point(0), float(radius)), Point(0, 0, -float(distance))});
      const glm::dvec3 centre(3 * radius, -2 * radius, 5 * radius);
      views.push_back({Sphere(Point(centre), float(radius)),
                       Point(centre + distance * glm::dvec3(randomUnit(random)))});
    }
  }
  return views;
}

std::vector<View> viewsFromInside() {
  std::vector<View> views;
  for (const float radius : {1e-6f, 1.0f, 30.0f, 1e6f}) {
    for (const Point& centre : {Point(0), Point(radius, -2 * radius, radius)}) {
      const Sphere sphere(centre, radius);
      for (const float share : {0.0f, 0.5f, 0.99f}) {
        views.push_back({sphere, centre + share * radius * unit(1, 2, 3)});
        views.push_back({sphere, centre - Vector(0, share * radius, 0)});
      }
    }
  }
  return views;
}

// By rounding, on one side of the surface or on the other.
std::vector<View> viewsFromTheSurface() {
  std::vector<View> views;
  for (const float radius : {1e-6f, 1.0f, 30.0f, 1e6f})
    for (const Point& centre : {Point(0), Point(radius, -2 * radius, radius)})
      for (const Vector& n : awkwardNormals())
        views.push_back({Sphere(centre, radius), centre + radius * n});
  return views;
}

void forViews(const std::vector<View>& views, const std::function<void(const View&)>& check) {
  for (const View& v : views) {
    SCOPED_TRACE(::testing::Message() << "radius " << v.sphere.radius() << ", centre "
                                      << v.sphere.centre().x << ", radius over distance "
                                      << v.sphere.radius() / length(v.from - v.sphere.centre()));
    check(v);
  }
}

// The contract's tolerance.
double densityTolerance(const SphereOracle& oracle, const Vector& n) {
  return std::max(1e-4, 16.0 * kRoundoff * oracle.condition(n));
}

void expectValid(const View& v, float s, float t) {
  SCOPED_TRACE(::testing::Message() << "s " << s << ", t " << t);
  const LightSample sample = v.sphere.sample(v.from, s, t);
  const SphereOracle oracle(v.sphere, v.from);
  ASSERT_TRUE(isUnit(sample.n));
  ASSERT_TRUE(isFinite(sample.p));
  ASSERT_TRUE(std::isfinite(sample.pdf));
  ASSERT_GE(sample.pdf, 0.0f);
  const Point c = v.sphere.centre();
  const double magnitude = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
  const double radius = v.sphere.radius();
  const glm::dvec3 offset = glm::dvec3(sample.p) - glm::dvec3(c);
  ASSERT_NEAR(glm::length(offset), radius, 8 * kRoundoff * (magnitude + radius));
  ASSERT_LE(glm::length(offset - radius * glm::dvec3(sample.n)),
            8 * kRoundoff * (magnitude + radius));
  // From clearly outside, never on the far side by more than the rounding of the normal.
  const double distance = double(oracle.d);
  const double rounding = 8 * kRoundoff * (magnitude + distance);
  if (distance - radius > rounding && sample.pdf > 0.0f) {
    const SphereOracle::LongVector w = oracle.toViewer(sample.n);
    ASSERT_GE(double(glm::dot(SphereOracle::LongVector(sample.n), w)), -8 * kRoundoff * distance);
  }
  const LightSample again = v.sphere.sample(v.from, s, t);
  ASSERT_EQ(again.p, sample.p);
  ASSERT_EQ(again.n, sample.n);
  ASSERT_EQ(again.pdf, sample.pdf);
}

TEST(SphereSample, LiesOnTheVisibleSideForAllInputs) {
  for (const auto& views : {viewsFromOutside(), viewsFromInside(), viewsFromTheSurface()}) {
    forViews(views, [](const View& v) {
      forEdgePairs([&](float s, float t) { expectValid(v, s, t); });
      Uniforms random(212);
      for (int i = 0; i < 200; ++i) expectValid(v, random.next(), random.next());
    });
  }
}

TEST(SphereSample, ReturnsTheDensityOfItsPdf) {
  for (const auto& views : {viewsFromOutside(), viewsFromInside(), viewsFromTheSurface()}) {
    forViews(views, [](const View& v) {
      Uniforms random(213);
      const SphereOracle oracle(v.sphere, v.from);
      for (int i = 0; i < 200; ++i) {
        const LightSample sample = v.sphere.sample(v.from, random.next(), random.next());
        const double tolerance = oracle.outside() ? densityTolerance(oracle, sample.n) : 1e-6;
        ASSERT_TRUE(isClose(sample.pdf, v.sphere.pdf(v.from, sample.p, sample.n), tolerance));
      }
    });
  }
}

TEST(SpherePdf, EqualsTheFormulaInLongDouble) {
  forViews(viewsFromOutside(), [](const View& v) {
    Uniforms random(214);
    const SphereOracle oracle(v.sphere, v.from);
    for (int i = 0; i < 2000; ++i) {
      const LightSample sample = v.sphere.sample(v.from, random.next(), random.next());
      ASSERT_TRUE(isClose(sample.pdf, oracle.pdf(sample.n), densityTolerance(oracle, sample.n)))
          << "cosine at the point " << double(oracle.cosAtPoint(sample.n));
    }
  });
}

TEST(SpherePdf, IsTheInverseAreaFromInside) {
  forViews(viewsFromInside(), [](const View& v) {
    const double r = v.sphere.radius();
    for (const Vector& n : awkwardNormals()) {
      const Point p = v.sphere.centre() + v.sphere.radius() * n;
      EXPECT_TRUE(isClose(v.sphere.pdf(v.from, p, n), 1 / (4 * kPiD * r * r), 1e-6));
    }
  });
}

TEST(SpherePdf, IsZeroWhereTheViewerCannotSee) {
  forViews(viewsFromOutside(), [](const View& v) {
    Uniforms random(215);
    const SphereOracle oracle(v.sphere, v.from);
    for (int i = 0; i < 500; ++i) {
      const Vector n = randomUnit(random);
      if (oracle.cosAtPoint(n) > -1e-3L) continue;
      ASSERT_EQ(v.sphere.pdf(v.from, v.sphere.centre() + v.sphere.radius() * n, n), 0.0f);
    }
  });
}

// Over the cap that the viewer sees: in the angle alpha at the centre, substituted by its cube
// root, since from next to the surface the density is a narrow peak at alpha = 0.
TEST(SpherePdf, IntegratesToOneOverTheVisibleCap) {
  forViews(viewsFromOutside(), [](const View& v) {
    const double r = v.sphere.radius();
    const SphereOracle oracle(v.sphere, v.from);
    const glm::dvec3 axis(oracle.from - oracle.centre);
    const DoubleFrame frame(axis);
    const double edge = std::acos(double(oracle.sinMax));
    const double integral = integrate(
        [&](double x) {
          const double alpha = edge * x * x * x;
          return integrate(
              [&](double azimuth) {
                const Vector n(frame.direction(std::cos(alpha), azimuth));
                const Point p = v.sphere.centre() + v.sphere.radius() * n;
                return v.sphere.pdf(v.from, p, n) * std::sin(alpha) * 3 * edge * x * x;
              },
              0.0, 2.0 * kPiD);
        },
        0.0, 1.0, 12);
    const double tolerance =
        std::max(1e-4, 16 * kRoundoff * double(oracle.d / (oracle.d - oracle.r)));
    EXPECT_NEAR(integral * r * r, 1.0, tolerance);
  });
}

// Weighted (see WeightedCells), in the fraction of the cone and the azimuth around its axis.
TEST(SphereSample, IsUniformOverTheSolidAngle) {
  constexpr int kSamples = 20000;
  constexpr std::size_t kRings = 8, kSectors = 8;
  forViews(viewsFromOutside(), [&](const View& v) {
    Uniforms random(216);
    const SphereOracle oracle(v.sphere, v.from);
    const DoubleFrame frame(glm::dvec3(oracle.from - oracle.centre));
    stats::WeightedCells cells(kRings * kSectors);
    stats::RunningMoments mass, fraction, squared, alongU, alongV, twofold;
    for (int i = 0; i < kSamples; ++i) {
      const LightSample sample = v.sphere.sample(v.from, random.next(), random.next());
      if (sample.pdf <= 0.0f) {
        cells.addNone();
        mass.add(0.0);
        continue;
      }
      const double w = double(oracle.pdf(sample.n)) / double{sample.pdf};
      const double h = oracle.coneFraction(sample.n);
      const double azimuth = frame.azimuth(glm::dvec3(sample.n));
      const auto ring = std::min(std::size_t(h * kRings), kRings - 1);
      const auto sector = std::min(std::size_t(azimuth / (2 * kPiD) * kSectors), kSectors - 1);
      cells.add(ring * kSectors + sector, w);
      mass.add(w);
      fraction.add(w * h);
      squared.add(w * h * h);
      alongU.add(w * std::cos(azimuth));
      alongV.add(w * std::sin(azimuth));
      twofold.add(w * std::sin(2 * azimuth));
    }
    const stats::MeanTest settings{.alpha = kAlpha, .tolerance = 1e-4};
    EXPECT_TRUE(meanIs(mass, 1.0, settings));
    EXPECT_TRUE(meanIs(fraction, 0.5, settings));
    EXPECT_TRUE(meanIs(squared, 1.0 / 3.0, settings));
    EXPECT_TRUE(meanIs(alongU, 0.0, settings));
    EXPECT_TRUE(meanIs(alongV, 0.0, settings));
    EXPECT_TRUE(meanIs(twofold, 0.0, settings));
    const std::vector<double> equal(kRings * kSectors, 1.0 / (kRings * kSectors));
    EXPECT_TRUE(cellsAre(cells, equal, kAlpha));
  });
}

TEST(SphereSample, IsUniformByAreaFromInside) {
  constexpr int kSamples = 10000;
  forViews(viewsFromInside(), [&](const View& v) {
    Uniforms random(217);
    const double area = 4 * kPiD * double{v.sphere.radius()} * double{v.sphere.radius()};
    stats::RunningMoments mass, mean[3], second[3];
    for (int i = 0; i < kSamples; ++i) {
      const LightSample sample = v.sphere.sample(v.from, random.next(), random.next());
      const double w = 1.0 / (area * double{sample.pdf});
      mass.add(w);
      for (int axis = 0; axis < 3; ++axis) {
        const double x = sample.n[axis];
        mean[axis].add(w * x);
        second[axis].add(w * x * x);
      }
    }
    const stats::MeanTest settings{.alpha = kAlpha, .tolerance = 1e-5};
    EXPECT_TRUE(meanIs(mass, 1.0, settings));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(meanIs(mean[axis], 0.0, settings));
      EXPECT_TRUE(meanIs(second[axis], 1.0 / 3.0, settings));
    }
  });
}

// sqrt(1 - z^2) with z next to 1 has nine different values for sin(thetaMax) = 1e-3 and one for
// 1e-4. Here equal steps of the input must stay equal steps of the cone.
TEST(SphereSample, ResolvesSmallCones) {
  constexpr int kSteps = 1 << 16;
  for (const double sine : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const Sphere sphere(Point(0), 1.0f);
    const Point from(Point(glm::dvec3(unit(1, -2, 3)) / sine));
    const SphereOracle oracle(sphere, from);
    for (const bool swapped : {false, true}) {
      std::set<std::tuple<float, float, float>> points;
      std::vector<double> fractions;
      for (int i = 0; i < kSteps; ++i) {
        const float step = (float(i) + 0.5f) / kSteps;
        const LightSample sample =
            swapped ? sphere.sample(from, 0.3f, step) : sphere.sample(from, step, 0.3f);
        points.insert({sample.n.x, sample.n.y, sample.n.z});
        fractions.push_back(oracle.coneFraction(sample.n));
      }
      EXPECT_GT(points.size(), 0.99 * kSteps) << "sine " << sine;
      // One of the two inputs is the azimuth, for which all fractions are the same.
      std::sort(fractions.begin(), fractions.end());
      if (fractions.back() - fractions.front() < 0.1) continue;
      double worst = 0.0;
      for (int i = 0; i < kSteps; ++i)
        worst = std::max(worst, std::abs(fractions[std::size_t(i)] - (i + 0.5) / kSteps));
      EXPECT_LT(worst, 1e-6) << "sine " << sine;
    }
  }
}

// Next to the limb, cos(theta') from r^2 - d^2 sin^2(theta) is left with no digits.
TEST(SphereSample, ResolvesTheLimb) {
  for (const double ratio : {1e-4, 0.1, 0.5, 0.9}) {
    const Sphere sphere(Point(0), 1.0f);
    const Point from(glm::dvec3(unit(1, -2, 3)) / ratio);
    const SphereOracle oracle(sphere, from);
    for (int k = 16; k <= 4096; k *= 2) {
      // Whichever input the cone's fraction comes from, at whichever end of it.
      const float small = float(k) * 0x1p-24f, large = 1.0f - small;
      Vector n(0.0f);
      double fraction = -1.0;
      for (const vec2& st :
           {vec2(large, 0.3f), vec2(small, 0.3f), vec2(0.3f, large), vec2(0.3f, small)}) {
        const Vector candidate = sphere.sample(from, st.x, st.y).n;
        if (oracle.coneFraction(candidate) <= fraction) continue;
        fraction = oracle.coneFraction(candidate);
        n = candidate;
      }
      const long double h = (1.0L - k * 0x1p-24L) * oracle.oneMinusCosMax;
      const long double cos2 = 1.0L - h * (2.0L - h) / (oracle.sinMax * oracle.sinMax);
      EXPECT_TRUE(isClose(double(oracle.cosAtPoint(n)), std::sqrt(cos2), 0.005))
          << "radius over distance " << ratio << ", " << k << " steps from the limb";
    }
  }
}

}  // namespace
}  // namespace pathmark
