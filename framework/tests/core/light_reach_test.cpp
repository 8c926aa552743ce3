// Points of a lamp are moved off it by its own rounding error, however large other lights are.
#include "render/light_reach.h"

#include <gtest/gtest.h>

#include <vector>

namespace pathmark::test {
namespace {

struct Lamp {
  std::vector<Point> vertices{{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}};
  std::vector<Polygon::TriangleIndices> triangles{{0, 1, 2}};
  Light::Face face{Polygon(vertices, triangles, Vector(0, -1, 0)), 1.0f, false};

  Point at(float s, float t) const {
    return vertices[0] + s * (vertices[1] - vertices[0]) + t * (vertices[2] - vertices[1]);
  }
};

TEST(LightReach, OfALampUnderALargeSkyIsItsOwn) {
  const Lamp lamp;
  const Sphere sky(Point(0), 1000.0f);
  LightReach reach;
  reach.add(std::span(&lamp.face, 1));
  reach.add(sky);
  for (const float s : {0.0f, 0.5f, 1.0f})
    for (const float t : {0.0f, 0.5f * s, s}) {
      EXPECT_GE(reach.magnitudeAt(lamp.at(s, t)), 2.0f);
      EXPECT_LT(reach.magnitudeAt(lamp.at(s, t)), 8.0f);
    }
  for (int k = 0; k < 1000; ++k) {
    const auto a = static_cast<float>(k);
    const Vector n = normalize(Vector(std::sin(a), std::cos(1.7f * a), std::sin(2.3f * a + 1)));
    EXPECT_GE(reach.magnitudeAt(sky.centre() + sky.radius() * n), 1000.0f);
  }
}

TEST(LightReach, OfLightsOfMuchTheSameSizeIsTheLargest) {
  const Lamp lamp;
  LightReach reach;
  reach.add(std::span(&lamp.face, 1));
  reach.add(Sphere(Point(0, 5, 0), 1.0f));
  EXPECT_EQ(reach.magnitudeAt(lamp.at(0.5f, 0.25f)), 6.0f);
}

TEST(LightReach, WithoutLightsIsNothing) { EXPECT_EQ(LightReach().magnitudeAt(Point(1)), 0.0f); }

}  // namespace
}  // namespace pathmark::test
