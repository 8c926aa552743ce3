// Frames, points on triangles, and directions at the horizon.
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_polygon.h"
#include "tests/traps/trap.h"

#include <pathmark/brdf.h>
#include <pathmark/frame.h>

namespace pathmark {
namespace {

using namespace testing;

struct Axes {
  Vector u, v;
};

// "Take any other vector": right until a normal comes along that is parallel to it.
Axes naiveFrame(const Vector& n, const Vector& other) {
  const Vector u = normalize(cross(other, n));
  return {u, cross(n, u)};
}

// The largest of: lengths off 1, dot products off 0; in roundoffs.
double frameError(const Axes& axes, const Vector& n) {
  const glm::dvec3 u(axes.u), v(axes.v), w(n);
  Worst worst;
  for (const double error :
       {glm::length(u) - 1.0, glm::length(v) - 1.0, glm::dot(u, v), glm::dot(u, w), glm::dot(v, w)})
    worst.add(std::abs(error) / kRoundoff);
  return worst.value();
}

TEST(Trap, FrameStaysOrthonormalNextToEveryAxis) {
  const Vector up(0, 1, 0), askew = unit(0.3, 0.5, -0.8);
  Worst naiveUp, naiveAskew, shipped;
  const auto check = [&](const Vector& n) {
    const Frame frame(n);
    shipped.add(frameError({frame.toWorld({1, 0, 0}), frame.toWorld({0, 0, 1})}, n));
  };
  for (const Vector& n : awkwardNormals()) check(n);
  for (const Vector& n : {up, -up, unit(1e-30, 1, 1e-30)}) {
    check(n);
    naiveUp.add(frameError(naiveFrame(n, up), n));
  }
  Uniforms random(1401);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 off =
        std::pow(10.0, random.between(-5.0, -1.0)) * glm::dvec3(randomUnit(random));
    for (const Vector& axis : {Vector(1, 0, 0), up, Vector(0, 0, 1), -Vector(0, 0, 1), askew})
      check(Vector(glm::normalize(glm::dvec3(axis) + off)));
    const Vector n(glm::normalize(glm::dvec3(askew) + off));
    naiveAskew.add(frameError(naiveFrame(n, askew), n));
  }
  expectTrap("the axis (0, 1, 0), roundoffs", naiveUp.value(), shipped.value(), 8.0);
  expectTrap("an axis askew, roundoffs", naiveAskew.value(), shipped.value(), 8.0);
}

// Two weights, and the third as what is left to 1: rounding makes it negative.
Point naiveTriangle(const Point& p0, const Point& p1, const Point& p2, float s, float t) {
  const float b0 = 1.0f - std::sqrt(s), b1 = std::sqrt(s) * (1.0f - t);
  return b0 * p0 + b1 * p1 + (1.0f - b0 - b1) * p2;
}

TEST(Trap, TriangleSamplingStaysInsideAtBothEnds) {
  // The coordinates are the weights of two corners.
  const TestPolygon triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto outside = [](const Point& p) {
    const double x = p.x, y = p.y;
    return std::max({-x, -y, x + y - 1.0, 0.0}) / kRoundoff;
  };
  Errors<Worst> errors;
  const auto check = [&](float s, float t) {
    errors.add(outside(naiveTriangle(triangle->p(0), triangle->p(1), triangle->p(2), s, t)),
               outside(triangle->TriangularSampling(s, t).p));
  };
  forEdgePairs(check);
  for (int i = 0; i < 1024; ++i) {
    for (int j = 0; j < 1024; ++j) {
      const float s = float(i) * 0x1p-24f, t = float(j) * 0x1p-24f;
      check(s, t);
      check(1.0f - 0x1p-24f - s, t);
      check(s, 1.0f - 0x1p-24f - t);
      check(1.0f - 0x1p-24f - s, 1.0f - 0x1p-24f - t);
    }
  }
  expectTrap("outside the triangle, roundoffs", errors, 0.0);
}

// f cos(theta) / pdf of a surface that scatters by the cosine is Kd for every sample. On the
// horizon pdf is 0 or, by rounding, negative: then there is no sample.
TEST(Trap, GrazingDirectionsCarryTheAlbedoOrNothing) {
  const float kd = 0.75f;
  const lambertianBRDF lambertian{Colour(kd)};
  const phongBRDF phong(Colour(0.0f), Colour(kd), 7.3f);
  Errors<Worst> errors;
  for (const Vector& n : awkwardNormals()) {
    const Vector wo = atCosine(n, 0.4, 2.0);
    forEdgePairs([&](float s, float t) {
      const DirectionSample sample = lambertian.reflection(wo, n, s, t, 0.5f);
      // f is known to be Kd/pi, and pdf to be cos/pi.
      const float cosTheta = dot(n, sample.wi), pdf = cosTheta * kInvPi;
      const float naive = kd * kInvPi * cosTheta / pdf;
      errors.naive.add(std::abs(double{naive} / double{kd} - 1.0) / kRoundoff);
      if (sample.pdf == 0.0f) return;
      const float weight = lambertian.brdf(wo, sample.wi, n).x * cosTheta / sample.pdf;
      errors.shipped.add(std::abs(double{weight} / double{kd} - 1.0) / kRoundoff);
    });
    forEdgeTriples([&](float s, float t, float u) {
      const DirectionSample sample = phong.reflection(wo, n, s, t, u);
      if (sample.pdf == 0.0f) return;
      const float weight = phong.brdf(wo, sample.wi, n).x * dot(n, sample.wi) / sample.pdf;
      // (m + 2) / (m + 1) Ks cos(theta)
      EXPECT_LE(std::abs(weight), 1.2f * kd);
    });
  }
  expectTrap("weight of a cosine sample, roundoffs", errors, 8.0);
}

}  // namespace
}  // namespace pathmark
