// Part 0: random numbers, uniform directions, and the path through a mesh.
#include "checks/irradiance.h"
#include "checks/pcg2d.h"
#include "tests/support/direction_cells.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/reference_tracer.h"
#include "tests/support/test_scene.h"

#include <gtest/gtest.h>

namespace pathmark {
namespace {

using namespace testing;
using checks::polygonIrradiance;
using checks::seedOf;

TEST(RandomNumbers, FollowThePublishedHash) {
  uvec2 seed(0, 0);
  const vec2 u = get_random_numbers(seed);
  EXPECT_EQ(seed, uvec2(0x18e431a7u, 0x055df4d1u));
  EXPECT_NEAR(u.x, 0x18e431a7p-32, 2 * kRoundoff);
  EXPECT_NEAR(u.y, 0x055df4d1p-32, 2 * kRoundoff);
}

TEST(RandomNumbers, StayBelowOneForTheLargestHashes) {
  for (const std::uint32_t x : {0u, 1u, 0x7fffffffu, 0xffffff7fu, 0xffffff80u, 0xffffffffu}) {
    for (const std::uint32_t y : {0u, 0xffffff7fu, 0xffffff80u, 0xffffffffu}) {
      uvec2 seed = seedOf({x, y});
      const vec2 u = get_random_numbers(seed);
      ASSERT_EQ(seed, uvec2(x, y)) << "the seed for this hash was found wrongly";
      EXPECT_TRUE(u.x >= 0.0f && u.x < 1.0f) << u.x;
      EXPECT_TRUE(u.y >= 0.0f && u.y < 1.0f) << u.y;
    }
  }
}

TEST(RandomNumbers, AreUniformAndIndependent) {
  constexpr std::size_t kSide = 16;
  stats::WeightedCells cells(kSide * kSide);
  stats::RunningMoments x, product;
  uvec2 seed(17, 4);
  float previous = 0.5f;
  for (int i = 0; i < 200000; ++i) {
    const vec2 u = get_random_numbers(seed);
    ASSERT_TRUE(u.x >= 0.0f && u.x < 1.0f && u.y >= 0.0f && u.y < 1.0f);
    cells.add(std::size_t(u.x * kSide) * kSide + std::size_t(u.y * kSide));
    x.add(u.x);
    product.add((double{u.x} - 0.5) * (double{previous} - 0.5));
    previous = u.x;
  }
  const std::vector<double> equal(kSide * kSide, 1.0 / (kSide * kSide));
  EXPECT_TRUE(cellsAre(cells, equal, kAlpha));
  EXPECT_TRUE(meanIs(x, 0.5, {.alpha = kAlpha}));
  EXPECT_TRUE(meanIs(product, 0.0, {.alpha = kAlpha}));
}

TEST(SampleSphere, IsTheMappingInDouble) {
  const auto check = [](float u0, float u1) {
    const Vector w = sample_sphere({u0, u1});
    const double z = 2.0 * double{u1} - 1.0, radius = std::sqrt(1.0 - z * z);
    const double azimuth = 2.0 * kPiD * double{u0};
    EXPECT_NEAR(w.z, z, kRoundoff);
    // The azimuth itself is rounded to a few units of 2 pi 2^-24.
    EXPECT_NEAR(w.x, radius * std::cos(azimuth), 10 * kRoundoff) << u0 << " " << u1;
    EXPECT_NEAR(w.y, radius * std::sin(azimuth), 10 * kRoundoff) << u0 << " " << u1;
    EXPECT_TRUE(isUnit(w));
    EXPECT_EQ(sample_sphere({u0, u1}), w);
  };
  forEdgePairs(check);
  Uniforms random(21);
  for (int i = 0; i < 10000; ++i) {
    const float u0 = random.next();
    check(u0, random.next());
  }
}

TEST(SampleSphere, IsUniform) {
  Uniforms random(22);
  const glm::dvec3 pole = glm::normalize(glm::dvec3(1, 2, -3));
  const DirectionCells partition(pole, {-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1}, 8);
  stats::WeightedCells cells(partition.count());
  stats::RunningMoments mean[3], square[3], mixed[3];
  for (int i = 0; i < 200000; ++i) {
    const float u0 = random.next();
    const glm::dvec3 w(sample_sphere({u0, random.next()}));
    cells.add(partition.cellOf(w));
    for (int axis = 0; axis < 3; ++axis) {
      mean[axis].add(w[axis]);
      square[axis].add(w[axis] * w[axis]);
      mixed[axis].add(w[axis] * w[(axis + 1) % 3]);
    }
  }
  const auto density = [](const glm::dvec3&) { return 1.0 / (4.0 * kPiD); };
  EXPECT_TRUE(cellsAre(cells, partition.probabilities(density, 1), kAlpha));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(meanIs(mean[axis], 0.0, {.alpha = kAlpha}));
    EXPECT_TRUE(meanIs(square[axis], 1.0 / 3.0, {.alpha = kAlpha}));
    EXPECT_TRUE(meanIs(mixed[axis], 0.0, {.alpha = kAlpha}));
  }
}

TEST(SampleHemisphere, StaysAboveForAllInputs) {
  for (const Vector& n : awkwardNormals()) {
    const auto check = [&](float u0, float u1) {
      const Vector w = sample_hemisphere({u0, u1}, n);
      EXPECT_TRUE(isUnit(w, 8.0));
      EXPECT_GE(dot(glm::dvec3(w), glm::dvec3(n)), -4 * kRoundoff) << u0 << " " << u1;
      EXPECT_EQ(sample_hemisphere({u0, u1}, n), w);
    };
    forEdgePairs(check);
    Uniforms random(23);
    for (int i = 0; i < 1000; ++i) {
      const float u0 = random.next();
      check(u0, random.next());
    }
  }
}

TEST(SampleHemisphere, IsUniform) {
  Uniforms random(24);
  for (const Vector& n : awkwardNormals()) {
    const glm::dvec3 axis(n);
    const DirectionCells partition(axis, {0, 0.2, 0.4, 0.6, 0.8, 1}, 8);
    const DoubleFrame frame(axis);
    stats::WeightedCells cells(partition.count());
    stats::RunningMoments height, squared, alongU, alongV;
    for (int i = 0; i < 20000; ++i) {
      const float u0 = random.next();
      glm::dvec3 w(sample_hemisphere({u0, random.next()}, n));
      const double c = glm::dot(w, axis);
      if (c < 0.0 && c > -4 * kRoundoff) w -= c * axis;  // rounded to below the horizon
      cells.add(partition.cellOf(w + 1e-12 * axis));
      height.add(c);
      squared.add(c * c);
      alongU.add(glm::dot(w, frame.u));
      alongV.add(glm::dot(w, frame.v));
    }
    const auto density = [](const glm::dvec3&) { return 1.0 / (2.0 * kPiD); };
    EXPECT_TRUE(cellsAre(cells, partition.probabilities(density, 1), kAlpha));
    EXPECT_TRUE(meanIs(height, 0.5, {.alpha = kAlpha, .tolerance = 1e-6}));
    EXPECT_TRUE(meanIs(squared, 1.0 / 3.0, {.alpha = kAlpha, .tolerance = 1e-6}));
    EXPECT_TRUE(meanIs(alongU, 0.0, {.alpha = kAlpha, .tolerance = 1e-6}));
    EXPECT_TRUE(meanIs(alongV, 0.0, {.alpha = kAlpha, .tolerance = 1e-6}));
  }
}

// A room of size 2 x 3 x 1.5 whose walls look inwards.
SceneBuilder room(const Surface& floor, const Surface& ceiling, const Surface& walls) {
  const Vector x(2, 0, 0), y(0, 1.5f, 0), z(0, 0, 3);
  SceneBuilder builder;
  builder.parallelogram(floor, Point(0), z, x).parallelogram(ceiling, y, x, z);
  builder.parallelogram(walls, Point(0), y, z).parallelogram(walls, x, z, y);
  builder.parallelogram(walls, Point(0), x, y).parallelogram(walls, z, y, x);
  return builder;
}

// In a closed room of one material everything shines alike: each scattering event adds the
// factor a, exactly.
const Surface kGlowing{.kd = Colour(0.3f, 0.5f, 0.8f), .emission = Colour(1.0f, 0.5f, 2.0f)};

TEST(DirectIllumination, InAnEvenlyGlowingRoomAddsOneReflection) {
  const TestScene scene(room(kGlowing, kGlowing, kGlowing));
  const std::vector<Triangle> triangles = scene.core().warmUpTriangles();
  uvec2 seed(31, 7);
  for (const Triangle& triangle : triangles) {
    const Point point =
        0.5f * triangle.positions[0] + 0.3f * triangle.positions[1] + 0.2f * triangle.positions[2];
    stats::RunningMoments mean[3];
    for (int i = 0; i < 20000; ++i) {
      const Colour l = compute_direct_illumination(point, triangle, {triangles}, seed);
      for (int c = 0; c < 3; ++c) mean[c].add(l[c]);
    }
    for (int c = 0; c < 3; ++c)
      EXPECT_TRUE(meanIs(mean[c], kGlowing.emission[c] * (1.0 + double{kGlowing.kd[c]}),
                         {.alpha = kAlpha, .tolerance = 1e-5}));
  }
}

// Lambert's formula, with the light's front towards the receiver and away from it: emission is
// two-sided in this part.
TEST(DirectIllumination, FromARectangleIsLambertsFormula) {
  uvec2 seed(32, 7);
  const Triangle receiver{
      {{-1, 0, -1}, {0, 0, 1}, {1, 0, -1}}, {0, 1, 0}, {0.2f, 0.5f, 0.9f}, {0.1f, 0.0f, 0.3f}};
  const Point point(0.1f, 0.0f, -0.2f), corner(-1, 1.25f, -0.5f);
  const Vector v1(2.5f, 0, 0), v2(0, 0.5f, 1.5f);
  const Colour emission(3, 2, 1);
  std::vector<glm::dvec3> outline{corner, corner + v1, corner + v1 + v2, corner + v2};
  const double irradiance = polygonIrradiance(outline, glm::dvec3(point), {0, 1, 0});
  ASSERT_GT(irradiance, 0.5);
  const Vector normal = normalize(cross(v1, v2));
  for (const float side : {1.0f, -1.0f}) {
    const Triangle lights[] = {
        {{corner, corner + v1, corner + v1 + v2}, side * normal, Colour(0), emission},
        {{corner, corner + v1 + v2, corner + v2}, side * normal, Colour(0), emission}};
    stats::RunningMoments mean[3];
    for (int i = 0; i < 200000; ++i) {
      const Colour l = compute_direct_illumination(point, receiver, {lights}, seed);
      for (int c = 0; c < 3; ++c) mean[c].add(l[c]);
    }
    for (int c = 0; c < 3; ++c) {
      const double expected = double{receiver.emission[c]} +
                              double{receiver.colour[c]} / kPiD * double{emission[c]} * irradiance;
      EXPECT_TRUE(meanIs(mean[c], expected, {.alpha = kAlpha, .tolerance = 1e-6}));
    }
  }
}

TEST(RayRadiance, InAnEvenlyGlowingRoomIsAGeometricSeries) {
  const TestScene scene(room(kGlowing, kGlowing, kGlowing));
  const std::vector<Triangle> triangles = scene.core().warmUpTriangles();
  uvec2 seed(33, 7);
  Uniforms random(25);
  stats::RunningMoments mean[3];
  for (int i = 0; i < 200000; ++i) {
    const Colour l = get_ray_radiance({0.7f, 0.8f, 1.1f}, randomUnit(random), {triangles}, seed);
    for (int c = 0; c < 3; ++c) mean[c].add(l[c]);
  }
  for (int c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (int k = 0; k < MAX_PATH_LENGTH; ++k)
      sum += double{kGlowing.emission[c]} * std::pow(double{kGlowing.kd[c]}, k);
    EXPECT_TRUE(meanIs(mean[c], sum, {.alpha = kAlpha, .tolerance = 1e-4})) << "channel " << c;
  }
}

TEST(RayRadiance, AgreesWithAnotherEstimatorInAnUnevenRoom) {
  const TestScene scene(room({.kd = Colour(0.9f, 0.2f, 0.5f)},
                             {.kd = Colour(0.1f), .emission = Colour(2, 3, 4)},
                             {.kd = Colour(0.4f, 0.6f, 0.3f)}));
  const std::vector<Triangle> triangles = scene.core().warmUpTriangles();
  const ReferenceTracer reference(scene.flat());
  const Point origin(0.7f, 0.8f, 1.1f);
  uvec2 seed(34, 7);
  Uniforms random(26);
  for (const Vector& direction : {unit(0.1, -1, 0.2), unit(1, 0.1, 0.3)}) {
    stats::RunningMoments mean[3], expected[3];
    for (int i = 0; i < 100000; ++i) {
      const Colour l = get_ray_radiance(origin, direction, {triangles}, seed);
      const glm::dvec3 e = reference.gather(glm::dvec3(origin), glm::dvec3(direction),
                                            MAX_PATH_LENGTH - 1, 1, random);
      for (int c = 0; c < 3; ++c) {
        mean[c].add(l[c]);
        expected[c].add(e[c]);
      }
    }
    for (int c = 0; c < 3; ++c)
      EXPECT_TRUE(meansAgree(mean[c], expected[c], {.alpha = kAlpha})) << "channel " << c;
  }
}

TEST(RayRadiance, IsBlackWhereThereIsNothing) {
  uvec2 seed(35, 7);
  EXPECT_EQ(get_ray_radiance({0, 0, 0}, {0, 0, 1}, {}, seed), Colour(0.0f));
}

}  // namespace
}  // namespace pathmark
