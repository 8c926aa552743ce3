// What is asked of part 0: rays against triangles and meshes.
#include "checks/calls.h"
#include "checks/exact.h"
#include "checks/meeting.h"
#include "checks/part0_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Plain ones first; then of all sizes, places and shapes. All lengths are within the contract's
// 1e-6 to 1e6.
std::vector<RayAndTriangle> raysAndTriangles(std::uint64_t seed) {
  const Corners plain{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  const Vector down(0, 0, -1), up(0, 0, 1);
  std::vector<RayAndTriangle> result{
      {{{0.25f, 0.25f, 1.0f}, down}, plain},  {{{0.25f, 0.25f, -1.0f}, up}, plain},
      {{{0.25f, 0.25f, 1.0f}, up}, plain},    {{{0.75f, 0.75f, 1.0f}, down}, plain},
      {{{-0.25f, 0.5f, 1.0f}, down}, plain},  {{{0.5f, -0.25f, 1.0f}, down}, plain},
      {{{0.5f, 0.375f, 2.0f}, down}, plain},  {{{0.125f, 0.75f, -3.0f}, up}, plain},
      {{{0.25f, 0.25f, -1.0f}, down}, plain},
  };
  Random random(seed);
  for (const double size : {1.0, 1e-3, 1e3, 3e-6, 1e4})
    for (const double shift : {0.0, 3.0, 100.0})
      for (const double shape : {1.0, 0.02})
        for (int k = 0; k < 100; ++k) result.push_back(randomMeeting(random, size, shift, shape));
  return result;
}

// A quantity of which only hits with large values are found.
class Threshold {
 public:
  void found(double x) { smallestFound_ = std::min(smallestFound_, x); }
  void missed(double x) { largestMissed_ = std::max(largestMissed_, x); }
  bool explains() const { return 0.0 < largestMissed_ && largestMissed_ < smallestFound_; }
  double value() const { return largestMissed_; }

 private:
  double smallestFound_ = kInfinity, largestMissed_ = 0.0;
};

// The answers are the same when everything is asked again, in the opposite order.
void askRepeatable(Exact& exact, const Results& results, std::size_t count,
                   const std::function<std::string(std::size_t)>& where) {
  for (std::size_t i = 0; i < count; ++i)
    exact.holds(
        results.same(i, 2 * count - 1 - i), "the same answer to the same question",
        [] { return "another answer; does the function keep something between calls?"; },
        [&] { return where(i); });
}

Finding hitsAreFound(CheckRun& run) {
  const std::vector<RayAndTriangle> inputs = raysAndTriangles(run.seed);
  Calls calls(F::kRayTriangleIntersection);
  const auto add = [&](const RayAndTriangle& in) {
    calls.add(in.ray, in.corners[0], in.corners[1], in.corners[2]);
  };
  std::for_each(inputs.begin(), inputs.end(), add);
  std::for_each(inputs.rbegin(), inputs.rend(), add);
  const Results results = calls.run(run.worker);
  Exact exact{"hits behind the origin of the ray count: t > 0 is not asked for",
              "b1 + b2 <= 1 is not tested: the triangle is hit as if it were a parallelogram",
              "b1 <= 1 is tested instead of b1 + b2 <= 1",
              "b2 <= 1 is tested instead of b1 + b2 <= 1",
              "the triangle is hit only from the side from which its corners run counter-clockwise",
              "the triangle is hit only from the side from which its corners run clockwise"};
  exact.count(results.count());
  const auto where = [&](std::size_t i) {
    return fmt::format("{}, {}", text(inputs[i].ray), text(inputs[i].corners));
  };
  Threshold determinants, distances;
  bool falseHits = false;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Meeting m = meet(inputs[i].ray, inputs[i].corners);
    if (!m.clear()) continue;
    const bool hit = results.word(i, 0) != 0, expected = m.hit();
    const double t = results.number(i, 1);
    const bool ahead = m.b1 >= 0.0 && m.b2 >= 0.0 && m.t > 0.0;
    const bool parallelogram = ahead && m.b1 <= 1.0 && m.b2 <= 1.0;
    exact.answer(
        hit, expected,
        expected     ? fmt::format("a hit at t = {:.6g}", m.t)
        : m.inside() ? "no hit: the triangle lies behind the origin"
                     : fmt::format("no hit: b1 = {:.3g}, b2 = {:.3g}", m.b1, m.b2),
        [&] { return hit ? fmt::format("a hit at t = {:.6g}", t) : "no hit"; },
        [&] { return where(i); },
        {m.inside(), parallelogram, ahead && m.b1 <= 1.0, ahead && m.b2 <= 1.0,
         expected && m.determinant > 0.0, expected && m.determinant < 0.0});
    falseHits |= hit && !expected;
    if (!expected) continue;
    for (Threshold* threshold : {&determinants, &distances}) {
      const double x = threshold == &distances ? m.t : std::abs(m.determinant);
      hit ? threshold->found(x) : threshold->missed(x);
    }
    if (hit)
      exact.value("t", t, m.t, m.tError, [&] { return where(i); }, {m.t, m.t, m.t, m.t, m.t, m.t});
  }
  askRepeatable(exact, results, inputs.size(), where);
  Finding finding = exact.finding();
  if (finding.passed() || !finding.cause.empty() || falseHits) return finding;
  if (determinants.explains() && !distances.explains())
    finding.cause = fmt::format(
        "a fixed threshold for the determinant: all hits are missed where it is below {:.2g}, "
        "which is an area and small for a small triangle",
        determinants.value());
  else if (distances.explains() && !determinants.explains())
    finding.cause =
        fmt::format("hits are missed where t is below {:.2g}, but t > 0 is enough for a hit",
                    distances.value());
  return finding;
}

// With whole numbers, so that the determinant is 0 without any rounding.
Finding parallelsMiss(CheckRun& run) {
  struct Input {
    RayAndTriangle at;
    const char* why;
  };
  const Corners plain{Point(0, 0, 0), Point(2, 0, 0), Point(0, 2, 0)};
  const char* const kParallel = "no hit: the ray is parallel to the triangle";
  const char* const kNoArea = "no hit: the triangle has no area";
  std::vector<Input> inputs;
  for (const float height : {1.0f, -2.0f, 0.0f}) {
    inputs.push_back({{{{-1.0f, 0.5f, height}, {1, 0, 0}}, plain}, kParallel});
    inputs.push_back({{{{0.5f, 4.0f, height}, {0, -1, 0}}, plain}, kParallel});
  }
  const Vector down(0, 0, -1);
  for (const Corners& degenerate : {Corners{Point(0, 0, 0), Point(1, 0, 0), Point(1, 0, 0)},
                                    Corners{Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)},
                                    Corners{Point(0, 0, 0), Point(0, 0, 0), Point(0, 2, 0)},
                                    Corners{Point(1, 2, 3), Point(1, 2, 3), Point(1, 2, 3)}}) {
    const Point middle = degenerate[1] == degenerate[2] ? degenerate[0] : degenerate[1];
    inputs.push_back({{{middle + vec3(0, 0, 5), down}, degenerate}, kNoArea});
    inputs.push_back({{{middle + vec3(0, 1, 5), down}, degenerate}, kNoArea});
  }
  Calls calls(F::kRayTriangleIntersection);
  for (const Input& in : inputs)
    calls.add(in.at.ray, in.at.corners[0], in.at.corners[1], in.at.corners[2]);
  const Results results = calls.run(run.worker);
  Exact exact;
  exact.count(results.count());
  bool allDivided = true;  // of those that are wrong
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const float t = results.number(i, 1);
    const bool right = exact.holds(
        results.word(i, 0) == 0, inputs[i].why,
        [&] { return fmt::format("a hit at t = {:.6g}", t); },
        [&] { return fmt::format("{}, {}", text(inputs[i].at.ray), text(inputs[i].at.corners)); });
    if (!right && std::isfinite(t)) allDivided = false;
  }
  Finding finding = exact.finding();
  if (!finding.passed() && allDivided)
    finding.cause =
        "division by a determinant of 0 gives infinity or NaN, and every comparison with NaN is "
        "false";
  return finding;
}

// Triangles all over the place, each known by its colour.
struct Soup {
  std::vector<Corners> corners;
  std::vector<Words> words;  // of each triangle

  // The normal is the triangle's own, on either side.
  void add(const Corners& c, bool turned) {
    const glm::dvec3 a(c[0]);
    const glm::dvec3 n = glm::normalize(glm::cross(glm::dvec3(c[1]) - a, glm::dvec3(c[2]) - a));
    const Vector normal(turned ? -n : n);
    const auto k = static_cast<float>(corners.size());
    corners.push_back(c);
    words.push_back(Words().add(c[0], c[1], c[2], normal, vec3(1.0f / (2.0f + k), 0.5f, 0.25f),
                                vec3(k, 0.0f, 1.0f)));
  }
};

constexpr int kNone = -1, kUnknown = -2;

// What a ray meets, in the order in which the triangles stand in the mesh.
struct Encounters {
  int nearest = kNone, first = kNone, last = kNone, farthest = kNone;
  std::vector<Meeting> meetings;
  bool clear = true;

  Encounters(const Ray& ray, const std::vector<Corners>& mesh) {
    for (const Corners& corners : mesh) {
      const Meeting& m = meetings.emplace_back(meet(ray, corners));
      const int k = static_cast<int>(meetings.size()) - 1;
      clear = clear && m.clear();
      if (!m.hit()) continue;
      if (first == kNone) first = k;
      last = k;
      if (nearest == kNone || m.t < t(nearest)) nearest = k;
      if (farthest == kNone || m.t > t(farthest)) farthest = k;
    }
    for (int k = 0; k < static_cast<int>(meetings.size()); ++k)
      if (k != nearest && meetings[static_cast<std::size_t>(k)].hit())
        clear = clear && t(k) > 1.01 * t(nearest);
  }

  double t(int k) const { return k == kNone ? kInfinity : meetings[static_cast<std::size_t>(k)].t; }
};

int indexOf(const Results& results, std::size_t call, const std::vector<Words>& triangles) {
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const std::vector<std::uint32_t>& words = triangles[k].words();
    bool same = true;
    for (std::size_t w = 0; w < words.size(); ++w)
      same = same && results.word(call, 2 + w) == words[w];
    if (same) return static_cast<int>(k);
  }
  return kUnknown;
}

struct MeshQuestion {
  std::string what;
  const std::vector<Corners>& corners;
  const std::vector<Words>& words;
  const std::vector<Ray>& rays;
};

// `words` may be in any order of the triangles, and `corners` in the same.
void askMesh(CheckRun& run, const MeshQuestion& question, Exact& exact) {
  Words mesh;
  for (const Words& triangle : question.words)
    for (const std::uint32_t word : triangle.words()) mesh.add(word);
  Calls calls(F::kRayMeshIntersection, mesh);
  std::for_each(question.rays.begin(), question.rays.end(), [&](const Ray& r) { calls.add(r); });
  std::for_each(question.rays.rbegin(), question.rays.rend(), [&](const Ray& r) { calls.add(r); });
  const Results results = calls.run(run.worker);
  exact.count(results.count());
  for (std::size_t i = 0; i < question.rays.size(); ++i) {
    const Encounters e(question.rays[i], question.corners);
    if (!e.clear) continue;
    const auto where = [&] { return text(question.rays[i]) + "; " + question.what; };
    const bool hit = results.word(i, 0) != 0, expected = e.nearest != kNone;
    const double t = results.number(i, 1);
    const int got = hit ? indexOf(results, i, question.words) : kNone;
    const auto describe = [](int k, double distance) {
      return k == kUnknown
                 ? fmt::format("t = {:.6g}, with a triangle that is not in the mesh", distance)
                 : fmt::format("triangle {} (counted from 0) at t = {:.6g}", k, distance);
    };
    exact.answer(got, e.nearest, expected ? describe(e.nearest, e.t(e.nearest)) : "no hit",
                 [&] { return hit ? describe(got, t) : "no hit"; }, where,
                 {e.last, e.first, e.first, e.farthest, kNone});
    if (hit && expected)
      exact.value("t", t, e.t(e.nearest), e.meetings[static_cast<std::size_t>(e.nearest)].tError,
                  where,
                  {e.t(e.last), e.t(e.first), e.t(e.nearest), e.t(e.farthest), e.t(e.nearest)});
  }
  askRepeatable(exact, results, question.rays.size(),
                [&](std::size_t i) { return text(question.rays[i]) + "; " + question.what; });
}

Finding nearestIsFound(CheckRun& run) {
  Random random(run.seed);
  Exact exact{"the last triangle that is hit is kept, not the nearest",
              "the first triangle that is hit is kept, not the nearest",
              "t is that of the nearest hit, but the triangle is not replaced with it",
              "the farthest hit is kept",
              "the search starts from what `t` holds when the function is called: a caller may "
              "have put 0 into it"};
  Soup layers;
  for (const float z : {-1.0f, 0.0f, -2.0f})
    layers.add({Point(0, 0, z), Point(1, 0, z), Point(0, 1, z)}, false);
  const std::vector<Ray> plain{{{0.25f, 0.25f, 1.0f}, {0, 0, -1}},
                               {{0.25f, 0.25f, -5.0f}, {0, 0, 1}},
                               {{0.25f, 0.25f, 1.0f}, {0, 0, 1}},
                               {{2.0f, 0.25f, 1.0f}, {0, 0, -1}}};
  askMesh(run,
          {"triangles (0, 0, z), (1, 0, z), (0, 1, z) with z = -1, 0 and -2 in this order",
           layers.corners, layers.words, plain},
          exact);
  for (const double size : {1.0, 1e-3, 1e4}) {
    Soup soup;
    for (int k = 0; k < 12; ++k)
      soup.add(randomMeeting(random, size, random.number(), 1.0).corners, random.below(2) == 0);
    std::vector<Ray> rays;
    for (int k = 0; k < 200; ++k) {
      const RayAndTriangle aimed = randomMeeting(random, size, 1.0, 1.0);
      const glm::dvec3 o(aimed.ray.origin),
          to = size * random.number() * glm::dvec3(random.direction());
      rays.push_back({aimed.ray.origin, Vector(glm::normalize(to - o))});
    }
    const std::string what = fmt::format("a mesh of 12 triangles of size {:.2g}", size);
    askMesh(run, {what, soup.corners, soup.words, rays}, exact);
    std::reverse(soup.corners.begin(), soup.corners.end());
    std::reverse(soup.words.begin(), soup.words.end());
    askMesh(run, {what, soup.corners, soup.words, rays}, exact);
    soup.corners.resize(1);
    soup.words.resize(1);
    askMesh(run, {"a mesh of a single triangle", soup.corners, soup.words, rays}, exact);
    askMesh(run, {"a mesh without triangles", {}, {}, {rays.front()}}, exact);
  }
  return exact.finding();
}

}  // namespace

std::vector<Check> part0IntersectionChecks() {
  return {
      {"hit", F::kRayTriangleIntersection,
       "a ray hits a triangle of any size, from either side, where t > 0, and t is the distance to "
       "the hit",
       0.0, hitsAreFound},
      {"parallel", F::kRayTriangleIntersection,
       "a ray parallel to the triangle misses it, and a triangle without area is never hit", 0.0,
       parallelsMiss},
      {"nearest",
       F::kRayMeshIntersection,
       "of all triangles that a ray hits the nearest is found, in whatever order they stand",
       0.0,
       nearestIsFound,
       {F::kRayTriangleIntersection}},
  };
}

}  // namespace pathmark::checks
