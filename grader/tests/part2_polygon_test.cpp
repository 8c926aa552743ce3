// Part 2: points on triangles, rectangles and polygons.
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_polygon.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

namespace pathmark {
namespace {

using namespace testing;

using Sampling = LightSample (Polygon::*)(float, float) const;

struct Case {
  const char* name;
  Sampling sampling;
  TestPolygon polygon;
};

using Cases = std::vector<std::unique_ptr<Case>>;

void addTriangle(Cases& cases, const char* name, const Point& a, const Point& b, const Point& c) {
  cases.emplace_back(
      new Case{name, &Polygon::TriangularSampling, TestPolygon({a, b, c}, {{0, 1, 2}})});
}

void addParallelogram(Cases& cases, const char* name, const Point& a, const Vector& v1,
                      const Vector& v2) {
  cases.emplace_back(
      new Case{name, &Polygon::RectangularSampling,
               TestPolygon({a, a + v1, a + v1 + v2, a + v2}, {{0, 1, 2}, {0, 2, 3}})});
}

Cases allCases() {
  Cases cases;
  addTriangle(cases, "triangle", {1, 2, 3}, {4, 2, 1}, {0, 5, 2});
  addTriangle(cases, "sliver", {0, 0, 0}, {1, 0, 0}, {0.3f, 1e-4f, 0});
  addTriangle(cases, "tiny triangle", {0, 0, 0}, {0, 1e-6f, 0}, {0, 0, 1e-6f});
  addTriangle(cases, "huge triangle", {-1e6f, 0, 0}, {1e6f, 1e5f, 0}, {0, 1e6f, 1e6f});
  addTriangle(cases, "far triangle", {1000, 2000, 3000}, {1001, 2000, 3000}, {1000, 2001, 3001});
  addParallelogram(cases, "square", {-0.5f, 2, -0.5f}, {1, 0, 0}, {0, 0, 1});
  addParallelogram(cases, "rectangle of area 6", {1, 1, 1}, {0, 2, 0}, {3, 0, 0});
  addParallelogram(cases, "parallelogram", {0.1f, 0.2f, 0.3f}, {1, 0.5f, 0.25f}, {0.5f, 1, -0.5f});
  addParallelogram(cases, "strip", {0, 0, 0}, {1e4f, 0, 0}, {0, 1, 0});
  addParallelogram(cases, "tiny rectangle", {0, 0, 0}, {1e-6f, 0, 0}, {0, 0, 2e-6f});

  const auto polygon = [&](const char* name, std::vector<Point> vertices,
                           std::vector<Polygon::TriangleIndices> triangles) {
    cases.emplace_back(new Case{name, &Polygon::PolygonSampling,
                                TestPolygon(std::move(vertices), std::move(triangles))});
  };
  polygon("one triangle", {{0, 0, 1}, {2, 0, 1}, {0, 1, 1}}, {{0, 1, 2}});
  polygon("trapezium", {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  // In the plane z = 2: the corner (1,1) points inwards, and the triangles have unequal areas.
  polygon("concave L", {{0, 0, 2}, {5, 0, 2}, {5, 1, 2}, {1, 1, 2}, {1, 3, 2}, {0, 3, 2}},
          {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {0, 4, 5}});
  // The same, where triangles from the first vertex to each edge would stick out.
  polygon("concave L from an arm",
          {{5, 1, 2}, {1, 1, 2}, {1, 3, 2}, {0, 3, 2}, {0, 0, 2}, {5, 0, 2}},
          {{4, 5, 1}, {5, 0, 1}, {4, 1, 2}, {4, 2, 3}});
  polygon("concave arrow", {{0, 0, 0}, {2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}});
  polygon("one triangle nearly all", {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {999.5f, 1000, 0}},
          {{0, 1, 2}, {0, 2, 3}});
  return cases;
}

void forAllCases(const std::function<void(const Case&)>& check) {
  for (const auto& c : allCases()) {
    SCOPED_TRACE(c->name);
    check(*c);
  }
}

LightSample sampleOf(const Case& c, float s, float t) { return ((*c.polygon).*c.sampling)(s, t); }

TEST(PolygonSamples, HaveTheInverseAreaAsDensity) {
  forAllCases([](const Case& c) {
    Uniforms random(201);
    for (int i = 0; i < 100; ++i) {
      const LightSample sample = sampleOf(c, random.next(), random.next());
      EXPECT_TRUE(isClose(sample.pdf, 1.0L / c.polygon.area(), 16 * kRoundoff));
    }
  });
}

TEST(PolygonSamples, LieOnThePolygonForAllInputs) {
  forAllCases([](const Case& c) {
    const auto check = [&](float s, float t) {
      SCOPED_TRACE(::testing::Message() << "s " << s << ", t " << t);
      const LightSample sample = sampleOf(c, s, t);
      ASSERT_TRUE(isFinite(sample.p));
      // Three products and two sums per coordinate.
      EXPECT_LE(c.polygon.offPlane(sample.p), 8 * kRoundoff);
      EXPECT_EQ(sample.n, c.polygon->normal());
      EXPECT_TRUE(std::isfinite(sample.pdf) && sample.pdf > 0.0f);
      const LightSample again = sampleOf(c, s, t);
      EXPECT_EQ(again.p, sample.p);
      EXPECT_EQ(again.pdf, sample.pdf);
    };
    forEdgePairs(check);
    Uniforms random(202);
    for (int i = 0; i < 1000; ++i) check(random.next(), random.next());
  });
}

// In barycentric coordinates, whose own rounding is that of the coordinates over the height.
TEST(PolygonSamples, StayInsideTheOutline) {
  forAllCases([](const Case& c) {
    double magnitude = 0.0, longest = 0.0;
    for (int i = 0; i < c.polygon->vertexCount(); ++i) {
      magnitude = std::max(magnitude, glm::length(glm::dvec3(c.polygon->p(i))));
      longest =
          std::max(longest, glm::length(glm::dvec3(c.polygon->p(i)) - glm::dvec3(c.polygon->p(0))));
    }
    double smallest = 1e300;
    for (const double p : c.polygon.cellProbabilities())
      smallest =
          std::min(smallest, p * c.polygon.area() * TestPolygon::kSplit * TestPolygon::kSplit);
    const double allowed = 8 * kRoundoff * magnitude * longest / smallest;
    Uniforms random(203);
    const auto check = [&](float s, float t) {
      EXPECT_LE(c.polygon.outside(sampleOf(c, s, t).p), allowed) << "s " << s << ", t " << t;
    };
    forEdgePairs(check);
    for (int i = 0; i < 10000; ++i) check(random.next(), random.next());
  });
}

void expectUniform(const Case& c, std::uint64_t seed, bool swapped) {
  SCOPED_TRACE(swapped ? "inputs swapped" : "");
  constexpr int kSamples = 40000;
  Uniforms random(seed);
  stats::WeightedCells cells(c.polygon.cellCount());
  stats::RunningMoments mean[3];
  const glm::dvec3 centroid = c.polygon.centroid();
  const double size = std::sqrt(c.polygon.area());
  for (int i = 0; i < kSamples; ++i) {
    const float s = random.next(), t = random.next();
    const LightSample sample = swapped ? sampleOf(c, t, s) : sampleOf(c, s, t);
    const double weight = 1.0 / (c.polygon.area() * double{sample.pdf});
    cells.add(c.polygon.cellOf(sample.p), weight);
    for (int axis = 0; axis < 3; ++axis)
      mean[axis].add(weight * (double{sample.p[axis]} - centroid[axis]) / size);
  }
  EXPECT_TRUE(cellsAre(cells, c.polygon.cellProbabilities(), kAlpha));
  // Coordinates of the far triangle are rounded to 1e-4 of its size.
  for (const stats::RunningMoments& m : mean)
    EXPECT_TRUE(meanIs(m, 0.0, {.alpha = kAlpha, .tolerance = 1e-4}));
}

TEST(PolygonSamples, AreUniformByArea) {
  forAllCases([](const Case& c) { expectUniform(c, 204, false); });
}

TEST(PolygonSamples, AreUniformForSwappedInputs) {
  forAllCases([](const Case& c) { expectUniform(c, 205, true); });
}

// With strata of s and t, the samples of a rectangle are strata of it too: one in each cell.
TEST(RectangularSampling, KeepsStrata) {
  const TestPolygon rectangle({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}, {{0, 1, 2}, {0, 2, 3}});
  constexpr int kSide = 16;
  Uniforms random(206);
  std::vector<int> hits(kSide * kSide, 0);
  for (int i = 0; i < kSide * kSide; ++i) {
    const double s = (i % kSide + random.between(0.01, 0.99)) / kSide;
    const double t = (i / kSide + random.between(0.01, 0.99)) / kSide;
    const Point p = rectangle->RectangularSampling(float(s), float(t)).p;
    ++hits[std::size_t(int(p.x / 2 * kSide) + kSide * int(p.y / 3 * kSide))];
  }
  for (const int h : hits) EXPECT_EQ(h, 1);
}

// Rounding must not run past the last triangle, whatever the areas are.
TEST(PolygonSampling, SurvivesTrianglesOfAnyArea) {
  Uniforms random(207);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Point> vertices{{0, 0, 0}};
    std::vector<Polygon::TriangleIndices> triangles;
    float x = 0.0f;
    vertices.emplace_back(x, 1, 0);
    for (unsigned k = 0; k < 12; ++k) {
      x += float(std::exp(random.between(-16.0, 0.0)));
      vertices.emplace_back(-x, 1, 0);
      triangles.push_back({0, k + 1, k + 2});
    }
    const TestPolygon fan(vertices, triangles);
    forEdgePairs([&](float s, float t) {
      const LightSample sample = fan->PolygonSampling(s, t);
      ASSERT_TRUE(isFinite(sample.p));
      ASSERT_TRUE(isClose(sample.pdf, 1.0L / fan.area(), 32 * kRoundoff));
      ASSERT_LE(fan.outside(sample.p), 0.5) << "s " << s << ", t " << t;
    });
  }
}

}  // namespace
}  // namespace pathmark
