#include "scene/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pathmark {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;

double doubleArea(const Outline& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

// By the number of edges that a ray to the right crosses.
bool isInPolygon(const Outline& outline, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

bool isInTriangle(const Outline& outline, const TriangleIndices& t, const glm::dvec2& p) {
  return orientation(outline[t[0]], outline[t[1]], p) > 0.0 &&
         orientation(outline[t[1]], outline[t[2]], p) > 0.0 &&
         orientation(outline[t[2]], outline[t[0]], p) > 0.0;
}

void expectCoveredExactlyOnce(const Outline& outline, std::mt19937& random) {
  ASSERT_FALSE(findCrossing(outline));
  const auto triangles = triangulate(outline);
  ASSERT_TRUE(triangles);
  ASSERT_EQ(triangles->size(), outline.size() - 2);

  double area = 0.0;
  for (const TriangleIndices& t : *triangles) {
    const double part = orientation(outline[t[0]], outline[t[1]], outline[t[2]]);
    EXPECT_GT(part, 0.0) << "a triangle does not keep the polygon's orientation";
    area += part;
  }
  EXPECT_NEAR(area, doubleArea(outline), 1e-12 * area);

  glm::dvec2 low = outline[0], high = outline[0];
  for (const glm::dvec2& p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::uniform_real_distribution<double> x(low.x, high.x), y(low.y, high.y);
  for (int k = 0; k < 300; ++k) {
    const glm::dvec2 p{x(random), y(random)};
    const auto covering =
        std::count_if(triangles->begin(), triangles->end(),
                      [&](const TriangleIndices& t) { return isInTriangle(outline, t, p); });
    EXPECT_EQ(covering, isInPolygon(outline, p) ? 1 : 0) << "at " << p.x << ", " << p.y;
  }
}

Outline randomStar(std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.1, 1.0), jitter(0.1, 0.9);
  Outline outline;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        kTwoPi * (static_cast<double>(i) + jitter(random)) / static_cast<double>(n);
    outline.push_back(radius(random) * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

// A band that winds around the centre, out along one side and back along the other.
Outline spiral(int turns, int perTurn) {
  const int n = turns * perTurn;
  const auto at = [&](int i, double offset) {
    const double angle = kTwoPi * i / perTurn;
    const double radius = 1.0 + static_cast<double>(i) / perTurn + offset;
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
  };
  Outline outline;
  for (int i = 0; i <= n; ++i) outline.push_back(at(i, 0.2));
  for (int i = n; i >= 0; --i) outline.push_back(at(i, -0.2));
  return outline;
}

TEST(Triangulate, CoversRandomStarsExactlyOnce) {
  std::mt19937 random(1);
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    expectCoveredExactlyOnce(randomStar(3 + static_cast<std::size_t>(k) % 40, random), random);
  }
}

TEST(Triangulate, CoversSpiralsExactlyOnce) {
  std::mt19937 random(2);
  for (const int turns : {1, 2, 5}) {
    for (const int perTurn : {7, 12, 40}) {
      SCOPED_TRACE(turns);
      expectCoveredExactlyOnce(spiral(turns, perTurn), random);
    }
  }
}

TEST(Triangulate, CoversCombsExactlyOnce) {
  std::mt19937 random(3);
  Outline comb;
  for (int i = 0; i < 20; ++i) {
    comb.emplace_back(-i, 5.0);
    comb.emplace_back(-i - 0.5, 0.1);
  }
  comb.emplace_back(-20.0, 5.0);
  comb.emplace_back(-20.0, 0.0);
  comb.emplace_back(0.0, 0.0);
  expectCoveredExactlyOnce(comb, random);
}

TEST(Triangulate, MakesVerticesOnStraightSidesCornersOfTriangles) {
  std::mt19937 random(4);
  Outline square;
  const auto side = [&](const glm::dvec2& from, const glm::dvec2& to) {
    for (int i = 0; i < 4; ++i) square.push_back(from + (to - from) * (i / 4.0));
  };
  side({0, 0}, {1, 0});
  side({1, 0}, {1, 1});
  side({1, 1}, {0, 1});
  side({0, 1}, {0, 0});
  expectCoveredExactlyOnce(square, random);
}

TEST(Triangulate, CoversPolygonsOfAllPlanesAndBothOrientations) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 50; ++k) {
    const Outline star = randomStar(12, random);
    const auto direction = [&] {
      return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    };
    const glm::dvec3 n = direction(), u = glm::normalize(glm::cross(n, direction()));
    const glm::dvec3 v = glm::cross(n, u);
    std::vector<glm::dvec3> vertices;
    for (const glm::dvec2& p : star) vertices.push_back(p.x * u + p.y * v);
    const glm::dvec3 found = newellVector(vertices);
    EXPECT_NEAR(glm::length(found - doubleArea(star) * n), 0.0, 1e-12);
    expectCoveredExactlyOnce(project(vertices, found), random);

    std::reverse(vertices.begin(), vertices.end());
    EXPECT_NEAR(glm::length(newellVector(vertices) + doubleArea(star) * n), 0.0, 1e-12);
    expectCoveredExactlyOnce(project(vertices, newellVector(vertices)), random);
  }
}

TEST(Triangulate, GivesNothingForAPolygonThatCrossesItself) {
  const Outline bowTie{{0, 0}, {2, 2}, {2, 0}, {0, 1.9}};
  EXPECT_TRUE(findCrossing(bowTie));
  EXPECT_FALSE(triangulate(bowTie));
}

TEST(FindCrossing, NamesTheTwoEdges) {
  const auto crossing = findCrossing({{0, 0}, {2, 2}, {2, 0}, {0, 1.9}});
  ASSERT_TRUE(crossing);
  EXPECT_EQ(*crossing, (std::array<std::size_t, 2>{0, 2}));
}

TEST(FindCrossing, FindsTouchesDuplicatesAndFolds) {
  EXPECT_TRUE(findCrossing({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));          // touches a side
  EXPECT_TRUE(findCrossing({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}));          // twice the same
  EXPECT_TRUE(findCrossing({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {0, 1}}));          // folds back
  EXPECT_TRUE(findCrossing({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}));  // touches itself
  EXPECT_FALSE(findCrossing({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}));         // straight angle
}

}  // namespace
}  // namespace pathmark
