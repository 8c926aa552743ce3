// The warm-up: intersections, random numbers, directions. Its estimators are in probe_warmup.cpp.
#include "checks/calls.h"
#include "checks/meeting.h"
#include "checks/pcg2d.h"
#include "checks/points.h"
#include "diagnosis/direction_moments.h"
#include "diagnosis/warmup_probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

// How a ray passes a triangle, as far as it matters.
std::string situation(const Meeting& m) {
  const bool parallelogram = m.b1 >= 0.0 && m.b1 <= 1.0 && m.b2 >= 0.0 && m.b2 <= 1.0;
  return fmt::format("its plane is met {}, {}, from its {}",
                     m.inside()      ? "inside of the triangle"
                     : parallelogram ? "in the parallelogram, outside of the triangle"
                                     : "outside",
                     m.t > 0.0 ? "ahead" : "behind the origin",
                     m.determinant > 0.0 ? "front" : "back");
}

Signature triangle(const ProbeRun& run) {
  Random random(1);
  Signature signature;
  for (const double size : {1.0, 1e-2, 1e-4, 1e-5, 1e3})
    for (int k = 0; k < 40; ++k) {
      const RayAndTriangle in = randomMeeting(random, size, 0.5, 1.0);
      const Meeting m = meet(in.ray, in.corners);
      if (!m.clear()) continue;
      Calls calls(run.function);
      calls.add(in.ray, in.corners[0], in.corners[1], in.corners[2]);
      const Results results = calls.run(run.worker);
      const bool hit = results.word(0, 0) != 0;
      const std::string where =
          fmt::format("of ray {} at a triangle of size {} ({})", k + 1, size, situation(m));
      signature.addAnswer("whether there is a hit " + where, hit);
      signature.add("t over what it must be (-1: no hit) " + where,
                    hit ? results.number(0, 1) / m.t : -1.0);
    }
  // A threshold for the determinant misses the one, a threshold for t the other.
  for (const auto& [size, distance] : {std::pair{1e-4f, 1.0f}, std::pair{1.0f, 5e-5f}}) {
    Calls calls(run.function);
    calls.add(Ray{{0.25f * size, 0.25f * size, distance}, {0, 0, -1}}, Point(0.0f),
              Point(size, 0, 0), Point(0, size, 0));
    signature.addAnswer(
        fmt::format("whether a triangle of size {} is hit from a distance of {}", size, distance),
        calls.run(run.worker).word(0, 0) != 0);
  }
  return signature;
}

// Triangles that are known by the red of their colour.
Signature mesh(const ProbeRun& run) {
  Random random(2);
  Signature signature;
  for (int trial = 0; trial < 12; ++trial) {
    Words words;
    constexpr int kTriangles = 8;
    std::vector<Corners> all;
    for (int k = 0; k < kTriangles; ++k) {
      all.push_back(randomMeeting(random, 1.0, random.number(), 1.0).corners);
      const auto& [a, b, c] = all.back();
      words.add(a, b, c,
                (random.below(2) == 0 ? 1.0f : -1.0f) * glm::normalize(glm::cross(b - a, c - a)),
                vec3(float(k), 0.5f, 0.25f), vec3(0.0f));
    }
    for (int k = 0; k < 6; ++k) {
      const Point origin = 4.0f * random.direction();
      const Ray ray{origin, glm::normalize(0.5f * random.direction() - origin)};
      bool clear = true;
      double nearest = 1e30;
      for (const Corners& corners : all) {
        const Meeting m = meet(ray, corners);
        clear = clear && m.clear();
        if (m.hit()) nearest = std::min(nearest, m.t);
      }
      if (!clear) continue;
      Calls calls(run.function, words);
      calls.add(ray);
      const Results results = calls.run(run.worker);
      const bool hit = results.word(0, 0) != 0;
      const std::string where =
          fmt::format("of ray {} at mesh {} of {} triangles", k + 1, trial + 1, kTriangles);
      signature.addAnswer("whether there is a hit " + where, hit);
      signature.add("number of the triangle, counted from 0 (-1: no hit), " + where,
                    hit ? double{results.number(0, 2 + 12)} : -1.0);
      signature.add("t over what it must be (-1: no hit) " + where,
                    hit && nearest < 1e30 ? results.number(0, 1) / nearest : -1.0);
    }
  }
  return signature;
}

Signature numbers(const ProbeRun& run) {
  std::vector<uvec2> seeds{{0, 0},
                           {1, 0},
                           {0, 1},
                           seedOf({0xffffffffu, 0u}),
                           seedOf({0x80000000u, 0xffffffc0u}),
                           seedOf({0x12345678u, 0xffffffffu})};
  Random random(3);
  for (int k = 0; k < 10; ++k) {
    const std::uint32_t x = random.bits();
    seeds.emplace_back(x, random.bits());
  }
  Calls calls(run.function);
  for (const uvec2& seed : seeds) calls.add(seed);
  const Results results = calls.run(run.worker);
  Signature signature;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c) {
      const std::string number = fmt::format("the {} number of the seed ({}, {})",
                                             c == 0 ? "first" : "second", seeds[i].x, seeds[i].y),
                        next = fmt::format("{} of the seed that follows ({}, {})",
                                           c == 0 ? "x" : "y", seeds[i].x, seeds[i].y);
      signature.add(number, results.number(i, c));
      signature.addAnswer(fmt::format("whether {} is 1 or more", number),
                          results.number(i, c) >= 1.0f);
      signature.add(next + " over 2^32", results.word(i, 2 + c) * 0x1p-32);
      signature.add("the last three digits of " + next, results.word(i, 2 + c) % 1000u);
    }
  return signature;
}

Signature directions(const ProbeRun& run) {
  constexpr std::uint32_t kReplicates = 64, kPoints = 256;
  Random random(4);
  Signature signature;
  const bool hemisphere = run.function == F::kSampleHemisphere;
  for (const Vector& n : {Vector(0, 0, 1), Vector(0, 1, 0), random.direction()}) {
    // The poles of the sphere may lie anywhere, but the contract names z.
    if (!hemisphere && n != Vector(0, 0, 1)) continue;
    Points points(run.seed, kPoints);
    Calls calls(run.function);
    for (std::uint32_t r = 0; r < kReplicates; ++r) {
      points.start(r);
      for (std::uint32_t m = 0; m < kPoints; ++m) {
        points.point(m);
        if (hemisphere)
          calls.add(points.pair(), n);
        else
          calls.add(points.pair());
      }
    }
    const Results results = calls.run(run.worker), again = calls.run(run.worker);
    DirectionMoments moments(n, kReplicates);
    double repeated = 0.0;
    for (std::size_t i = 0; i < results.count(); ++i) {
      moments.add(static_cast<std::uint32_t>(i / kPoints), results.vector(i, 0));
      repeated += results.vector(i, 0) == again.vector(i, 0) ? 1.0 : 0.0;
    }
    const std::string where =
        hemisphere ? fmt::format(", n = ({:.3g}, {:.3g}, {:.3g})", n.x, n.y, n.z) : "";
    moments.addTo(signature, where, kPoints, DirectionMoments::Densities::kNone);
    signature.add("share of answers that are the same again" + where,
                  repeated / static_cast<double>(results.count()));
  }
  return signature;
}

}  // namespace

Signature probePart0(const ProbeRun& run) {
  switch (run.function) {
    case F::kRayTriangleIntersection:
      return triangle(run);
    case F::kRayMeshIntersection:
      return mesh(run);
    case F::kGetRandomNumbers:
      return numbers(run);
    case F::kComputeDirectIllumination:
      return probeBounce(run);
    case F::kGetRayRadiance:
      return probeWarmUpPath(run);
    default:
      return directions(run);
  }
}

}  // namespace pathmark::diagnosis
