// What one path of 5.1 must be, whatever the mean.
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/hollow.h"
#include "checks/part5_checks.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "checks/scene_family.h"
#include "checks/scenes.h"
#include "checks/small_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks::path {

namespace {

std::string inWords(const Ray& ray) {
  return fmt::format("a ray from {} towards {}", text(ray.origin), text(ray.direction));
}

struct Traced {
  Colour radiance;
  bool valid;
};

// One path along each ray.
std::vector<Traced> traceOnce(CheckRun& run, const std::vector<PathRay>& rays,
                              std::uint32_t seed = 0) {
  CheckRun own{run.worker, run.seed + seed, run.budget, run.function};
  PathEstimates estimates(own, rays, 1);
  std::vector<double> values(3 * rays.size());
  estimates.measure(0, 1, values);
  std::vector<Traced> all;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const Colour c(values[3 * k], values[3 * k + 1], values[3 * k + 2]);
    all.push_back({c, !std::isnan(c.x)});
  }
  return all;
}

Finding lampAlone(CheckRun& run) {
  struct Case {
    const char* what;
    PathRay ray;
    bool meets;
    Colour expected;
  };
  const Colour emission(3, 2, 1);
  const Ray front{{0.3f, 0.2f, 2}, {0, 0, -1}}, back{{0.3f, 0.2f, -2}, {0, 0, 1}},
      past{{5, 0, 2}, {0, 0, -1}};
  const std::vector<Case> cases{
      {"the front of a light, maxBounces() = 0", {front, 0}, true, emission},
      {"the back of a light, maxBounces() = 0", {back, 0}, true, Colour(0.0f)},
      {"a ray that meets nothing, maxBounces() = 0", {past, 0}, false, Colour(0.0f)},
      {"the front of a light, maxBounces() = 8", {front, 8}, true, emission},
      {"the back of a light, maxBounces() = 8", {back, 8}, true, Colour(0.0f)},
      {"a ray that meets nothing, maxBounces() = 8", {past, 8}, false, Colour(0.0f)},
  };
  SceneBuilder builder;
  builder.parallelogram({.kd = Colour(0.5f), .emission = emission}, {-1, -1, 0}, {2, 0, 0},
                        {0, 2, 0});
  run.worker.loadScene(builder.flat());
  Exact exact{"what the first hit emits is lost", "emission is counted twice",
              "emission is multiplied by the reflectance",
              "direct light is assigned (=) where it must be added (+=)", "the back emits too"};
  std::vector<PathRay> rays;
  for (const Case& c : cases) rays.push_back(c.ray);
  const std::vector<Traced> traced = traceOnce(run, rays);
  exact.count(rays.size());
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Case& c = cases[k];
    const auto where = [&] {
      return fmt::format("{}; the light emits {} and is alone", c.what, text(emission));
    };
    if (!exact.holds(
            traced[k].valid, fmt::format("the radiance {}", text(c.expected)),
            [] { return "a value that is not finite, or negative"; }, where))
      continue;
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = double{c.expected[channel]};
      exact.value(inChannel("radiance", channel), traced[k].radiance[channel], expected,
                  0x1p-22 * expected, where,
                  {0.0, 2.0 * expected, 0.5 * expected, c.ray.bounces == 0 ? expected : 0.0,
                   c.meets ? double{emission[channel]} : 0.0});
    }
  }
  return exact.finding();
}

// Right under a lamp, where most directions and all points of the lamp find light. Each path draws
// other ones.
Finding litSurfaceWithoutBounces(CheckRun& run) {
  SceneBuilder builder;
  builder.parallelogram({.kd = Colour(0.5f)}, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0})
      .parallelogram({.emission = Colour(3, 2, 1)}, {-4, 1, -4}, {8, 0, 0}, {0, 0, 8});
  run.worker.loadScene(builder.flat());
  const Ray ray{{0.1f, 0.5f, 0.2f}, {0, -1, 0}};
  const std::vector<Traced> traced = traceOnce(run, std::vector<PathRay>(32, {ray, 0}));
  Exact exact;
  exact.count(traced.size());
  for (const Traced& path : traced)
    exact.holds(
        path.valid && path.radiance == Colour(0.0f), "the radiance 0, which the surface emits",
        [&] {
          return path.valid ? "the radiance " + text(path.radiance)
                            : std::string("a value that is not finite, or negative");
        },
        [] { return "a matt surface right under a lamp, maxBounces() = 0"; });
  Finding finding = exact.finding();
  if (finding.status == Status::kFail)
    finding.cause =
        "with maxBounces() = 0 nothing is scattered: the path ends at hit 1, before its direct "
        "light";
  return finding;
}

// A plate of either material, seen from behind in a room full of light.
Finding backsAreBlack(CheckRun& run) {
  Random random(run.seed);
  const Colour kd(0.5f, 0.0f, 0.75f);
  Exact exact;
  bool reflects = false;
  for (const Surface& plate : {lopsidedWall(kd, Colour(0.0f)), Surface{.kd = kd}}) {
    const Hollow hollow(random);
    const Vector n = random.direction(), v1 = atCosine(n, 0.0, random.between(0.0, 6.0));
    const float side = 0.5f * hollow.radius;
    const Vector v2 = side * cross(n, v1);
    SceneBuilder builder;
    builder.sphere({.kd = kd, .emission = Colour(1.0f)}, hollow.centre, hollow.radius, true)
        .parallelogram(plate, hollow.centre - 0.5f * (side * v1 + v2), side * v1, v2);
    run.worker.loadScene(builder.flat());
    std::vector<PathRay> rays;
    for (const int bounces : {2, 8})
      for (int k = 0; k < 64; ++k) {
        const Vector wo = atCosine(n, random.between(-1.0, -0.3), random.between(0.0, 6.0));
        rays.push_back({{hollow.centre + 0.5f * hollow.radius * wo, -wo}, bounces});
      }
    const std::vector<Traced> traced = traceOnce(run, rays);
    exact.count(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k) {
      reflects = reflects || (traced[k].valid && traced[k].radiance != Colour(0.0f));
      exact.holds(
          traced[k].valid && traced[k].radiance == Colour(0.0f), "the radiance 0",
          [&] {
            return traced[k].valid ? "the radiance " + text(traced[k].radiance)
                                   : std::string("a value that is not finite, or negative");
          },
          [&] {
            return fmt::format(
                "the back of a plate that does not emit, in a sphere that does; "
                "maxBounces() = {}",
                rays[k].bounces);
          });
    }
  }
  Finding finding = exact.finding();
  if (reflects)
    finding.cause =
        "a surface is seen from behind, and reflects: is the normal turned towards wo? Backs are "
        "black, and hit.n is always that of the front";
  return finding;
}

}  // namespace

Finding emissionIsSeen(CheckRun& run) {
  Finding finding;
  std::uint64_t calls = 0;
  for (const auto judge : {lampAlone, litSurfaceWithoutBounces, backsAreBlack}) {
    finding = judge(run);
    calls += finding.calls;
    if (!finding.passed()) break;
  }
  finding.calls = calls;
  return finding;
}

// Furnaces with all that can happen to a path: no samples, grazing directions, many bounces.
Finding radianceIsValid(CheckRun& run) {
  Random random(run.seed);
  Exact exact;
  for (const int bounces : {1, 2, 3, 8, 64}) {
    const Hollow hollow(random);
    run.worker.loadScene(furnaceIn(hollow, Colour(0.5f), Colour(1.0f)));
    std::vector<PathRay> rays;
    for (int k = 0; k < 200; ++k)
      rays.push_back({hollow.rayAt(random.between(0.02, 1.0), random), bounces});
    const std::vector<Traced> traced = traceOnce(run, rays);
    exact.count(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k)
      exact.holds(
          traced[k].valid, "a radiance: finite, and at least 0",
          [] { return "NaN, infinity or a negative number"; },
          [&] {
            return fmt::format(
                "maxBounces() = {}, and reflection says \"no sample\" (density 0) for an eighth of "
                "its samples; {}",
                bounces, inWords(rays[k].ray));
          });
  }
  Finding finding = exact.finding();
  if (finding.status == Status::kFail)
    finding.cause =
        "a division by the density 0: there is no direction then, and the path has to end";
  return finding;
}

namespace {

// What is kept between calls shows at once where several threads trace.
Finding threadsChangeNothing(CheckRun& run) {
  SmallRender render(
      run, randomRoom(run.seed), "a room made for this check", 4,
      run.function == CourseworkFunction::kTracePathMis ? Estimator::kMis : Estimator::kPath);
  const RenderedFilm one = render.render(0, 1), three = render.render(0, 3);
  const auto sameSums = [](const FilmPixel& a, const FilmPixel& b) {
    return std::ranges::equal(a.sum, b.sum);
  };
  Exact exact;
  exact.count(render.rays());
  exact.holds(
      std::ranges::equal(one.pixels, three.pixels, sameSums),
      "the same picture by three threads as by one", [] { return "another picture"; },
      [] { return "a picture of a room made for this check"; });
  Finding finding = exact.finding();
  if (!finding.passed())
    finding.cause = "threads share a static or global variable: each path needs its own variables";
  return finding;
}

Finding pathsAreRepeatable(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random);
  run.worker.loadScene(furnaceIn(hollow, Colour(0.5f), Colour(1.0f)));
  std::vector<PathRay> rays;
  for (int k = 0; k < 64; ++k) rays.push_back({hollow.rayAt(random.between(0.1, 1.0), random), 8});
  const std::vector<Traced> first = traceOnce(run, rays, 1), other = traceOnce(run, rays, 2),
                            again = traceOnce(run, rays, 1);
  Exact exact;
  exact.count(3 * rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k)
    exact.holds(
        first[k].radiance == again[k].radiance || !first[k].valid,
        "the same radiance from the same random numbers",
        [&] {
          return fmt::format("{}, and later {}", text(first[k].radiance), text(again[k].radiance));
        },
        [&] {
          return fmt::format(
              "{}, twice, with other paths in between: {} may draw its numbers from the sampler "
              "only, must keep nothing from one call to the next, and each variable needs a first "
              "value",
              inWords(rays[k].ray), contractOf(run.function).name);
        });
  (void)other;
  return exact.finding();
}

}  // namespace

Finding sameNumbersSameRadiance(CheckRun& run) {
  Finding finding = pathsAreRepeatable(run);
  if (!finding.passed()) return finding;
  Finding threads = threadsChangeNothing(run);
  threads.calls += finding.calls;
  return threads;
}

Finding twiceTheEmission(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random);
  const Colour emission(0.5f, 1.0f, 40.0f);
  std::vector<PathRay> rays;
  for (int k = 0; k < 400; ++k) rays.push_back({hollow.rayAt(random.between(0.1, 1.0), random), 6});
  std::vector<Traced> traced[2];
  for (const int times : {1, 2}) {
    run.worker.loadScene(
        furnaceIn(hollow, Colour(0.75f, 0.5f, 0.25f), static_cast<float>(times) * emission));
    traced[times - 1] = traceOnce(run, rays);
  }
  Exact exact;
  exact.count(2 * rays.size());
  bool darker = true;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const Colour once = traced[0][k].radiance, twice = traced[1][k].radiance;
    for (int c = 0; c < 3; ++c) darker = darker && twice[c] <= 2.0f * once[c];
    exact.holds(
        twice == 2.0f * once || !traced[0][k].valid,
        fmt::format("radiance = {}, twice that before", text(2.0f * once)),
        [&] { return fmt::format("radiance = {}", text(twice)); },
        [&] {
          return fmt::format(
              "{}, once and again with the same random numbers, but twice the emission",
              inWords(rays[k].ray));
        });
  }
  Finding finding = exact.finding();
  if (finding.status == Status::kFail && darker)
    finding.cause = "radiance is clamped, or something is added that does not come from a light";
  return finding;
}

}  // namespace pathmark::checks::path
