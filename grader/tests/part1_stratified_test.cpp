// Part 1: the ray through a stratum of a pixel. What renderPixel does with such rays is tested
// in part1_probe_test.cpp.
#include "checks/film_point.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_scene.h"

#include <gtest/gtest.h>

namespace pathmark {
namespace {

using namespace testing;
using checks::filmPoint;
using checks::filmTolerance;

std::vector<SimpleCamera> cameras() {
  std::vector<SimpleCamera> result;
  const auto add = [&](const Point& eye, const Point& target, double fov, int width, int height) {
    SceneBuilder builder;
    builder.camera(eye, target, fov, width, height);
    result.push_back(TestScene(builder).core().camera());
  };
  add({0, 0, 0}, {0, 0, -1}, 0.7, 64, 48);
  add({100, -20, 3}, {7, 8, 9}, 0.3, 1920, 1080);
  add({1e4f, 0, 1e4f}, {0, 1, 0}, 2.0, 31, 77);
  // A film that is neither centred nor square to the view, with pixels that are not square.
  result.push_back(
      {{1, 2, 3}, {-0.3f, 0.9f, -1.2f}, {0.02f, 0.001f, 0.004f}, {0.003f, -0.03f, 0}, 40, 30});
  return result;
}

TEST(StratifiedRandomRay, GoesThroughItsFilmPoint) {
  Uniforms random(101);
  for (const SimpleCamera& camera : cameras()) {
    for (const int n : {1, 2, 3, 7, 16, 32}) {
      const auto check = [&](float s, float t) {
        const int i = int(random.bits() % unsigned(camera.width()));
        const int j = int(random.bits() % unsigned(camera.height()));
        const int k = int(random.bits() % unsigned(n)), l = int(random.bits() % unsigned(n));
        const Ray ray = camera.StratifiedRandomRay(i, j, k, l, n, s, t);
        ASSERT_EQ(ray.origin, camera.eye());
        ASSERT_TRUE(isUnit(ray.direction));
        const glm::dvec2 film = filmPoint(camera, ray.direction);
        const double x = i + (k + double{s}) / n, y = j + (l + double{t}) / n;
        const double tolerance = filmTolerance(camera, x, y);
        ASSERT_NEAR(film.x, x, tolerance) << "n " << n << ", s " << s;
        ASSERT_NEAR(film.y, y, tolerance) << "n " << n << ", t " << t;
        // Towards the film, not away from it.
        const glm::dvec3 there = glm::dvec3(camera.topLeft()) +
                                 x * glm::dvec3(camera.pixelRight()) +
                                 y * glm::dvec3(camera.pixelDown());
        ASSERT_GT(glm::dot(there, glm::dvec3(ray.direction)), 0.0);
      };
      forEdgePairs(check);
      for (int trial = 0; trial < 500; ++trial) {
        const float s = random.next();
        check(s, random.next());
      }
    }
  }
}

TEST(StratifiedRandomRay, AnswersTheSameTwice) {
  for (const SimpleCamera& camera : cameras()) {
    forEdgePairs([&](float s, float t) {
      EXPECT_EQ(camera.StratifiedRandomRay(3, 4, 1, 2, 3, s, t).direction,
                camera.StratifiedRandomRay(3, 4, 1, 2, 3, s, t).direction);
    });
  }
}

}  // namespace
}  // namespace pathmark
