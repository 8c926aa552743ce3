// Lights that are small, far, near, slender or around the receiver, against closed forms: first the
// sampling functions by themselves, on a grid of s and t, then direct light in scenes, through the
// reader of scenes and with shadow rays.
//
// What is asked of samples is what they stand for, so that any way of sampling that is right
// passes: sums of f / pdf, which are integrals over the light.
#include "bench/stress/irradiance_oracle.h"
#include "bench/stress/stress.h"
#include "bench/stress/words.h"
#include "bench/stress/worse.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace pathmark::bench {

namespace {

using oracle::lengthOf;
using oracle::Real;
using oracle::unit;
using oracle::Vector3;

constexpr Real kPiReal = std::numbers::pi_v<Real>;

struct Grid {
  int side;

  void forEach(const std::function<void(float, float)>& visit) const {
    for (int k = 0; k < side; ++k)
      for (int l = 0; l < side; ++l)
        visit((static_cast<float>(k) + 0.5f) / static_cast<float>(side),
              (static_cast<float>(l) + 0.5f) / static_cast<float>(side));
  }
};

// Irradiance at x by the midpoint rule over s and t.
Real irradianceBy(const std::vector<LightSample>& samples, const Vector3& x, const Vector3& n,
                  bool inward = false) {
  Real sum = 0;
  for (const LightSample& y : samples) {
    if (y.pdf == 0.0f) continue;
    const Vector3 toLight = Vector3(y.p) - x;
    const Real d = lengthOf(toLight);
    const Vector3 normal = inward ? -Vector3(y.n) : Vector3(y.n);
    const Real cosX = glm::dot(unit(n), toLight) / d, cosY = -glm::dot(normal, toLight) / d;
    // A sample with values that are none is no dark one.
    if (cosX <= 0 || cosY <= 0) continue;
    sum += cosX * cosY / (d * d * Real{y.pdf});
  }
  return sum / static_cast<Real>(samples.size());
}

double relativeError(Real value, Real expected) {
  return static_cast<double>(std::abs(value - expected) / expected);
}

struct SphereCase {
  Point centre;
  float radius;
  Point from;
};

std::vector<LightSample> samplesOf(StressWorker& worker, const SphereCase& c, int side) {
  CallWords inputs;
  Grid{side}.forEach([&](float s, float t) { inputs.add(c.centre, c.radius, c.from, s, t); });
  const auto words = worker.call(CourseworkFunction::kSphereSample, {}, inputs);
  AnswerWords answer(words);
  std::vector<LightSample> samples;
  while (!answer.atEnd()) samples.push_back(answer.lightSample());
  return samples;
}

// How far Sphere::pdf is from the density that Sphere::sample has returned with its points, over
// how much a rounding of the normal changes it.
double twinError(StressWorker& worker, const SphereCase& c,
                 const std::vector<LightSample>& samples) {
  CallWords inputs;
  for (const LightSample& y : samples) inputs.add(c.centre, c.radius, c.from, y.p, y.n);
  const auto words = worker.call(CourseworkFunction::kSpherePdf, {}, inputs);
  AnswerWords answer(words);
  double worst = 0.0;
  for (const LightSample& y : samples) {
    const Real pdf = answer.number();
    if (y.pdf == 0.0f) continue;
    const Vector3 w = Vector3(c.from) - Vector3(c.centre) - Real{c.radius} * Vector3(y.n);
    const Real cosine = std::abs(glm::dot(Vector3(y.n), w)) / lengthOf(w);
    worst = worse(worst, static_cast<double>(std::abs(pdf / Real{y.pdf} - 1) *
                                             std::min<Real>(cosine * cosine, 1)));
  }
  return worst;
}

// Directions towards the sphere are uniform over its cone: the share of the cone that lies nearer
// to the axis is uniform in [0,1], with moments 1/2 and 1/3. Samples count by the solid angle that
// they stand for. Returns the larger relative error.
double coneError(const SphereCase& c, const std::vector<LightSample>& samples) {
  const Vector3 axis = Vector3(c.from) - Vector3(c.centre);
  const Real r = c.radius, d = lengthOf(axis), sinMax = r / d;
  const Real whole = sinMax * sinMax / (1 + std::sqrt((d - r) * (d + r)) / d);
  Real weights = 0, first = 0, second = 0;
  for (const LightSample& y : samples) {
    const Vector3 n(y.n), w = axis - r * n;
    const Real cosine = glm::dot(n, w) / lengthOf(w);
    if (cosine <= 0 || y.pdf == 0.0f) continue;
    const Real sin2 = sinMax * sinMax * (1 - cosine) * (1 + cosine);
    const Real share = sin2 / (1 + std::sqrt(std::max<Real>(1 - sin2, 0))) / whole;
    const Real weight = cosine / (glm::dot(w, w) * Real{y.pdf});
    weights += weight;
    first += weight * share;
    second += weight * share * share;
  }
  return worse(relativeError(first / weights, Real{1} / 2),
               relativeError(second / weights, Real{1} / 3));
}

void stressSpheres(Stress& stress, StressWorker& worker) {
  stress.begin({.key = "sphereLights",
                .title = "Sphere lights by Sphere::sample, on a grid: relative errors",
                .columns = {{"angle", "seen under, rad"},
                            {"gap", "gap, radii"},
                            {"irradiance", "irradiance"},
                            {"cone", "directions"},
                            {"twin", "pdf's twin"}},
                .rows = {}});
  const int side = stress.quick ? 64 : 256;
  double irradiance = 0.0, cone = 0.0, twin = 0.0, close = 0.0;
  for (const double angle : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0, 2.0, 3.0, 3.1, 3.14}) {
    const auto distance = static_cast<float>(0.5 / std::sin(0.5 * angle));
    std::array<double, 3> worst{};
    for (const vec3& direction : {vec3(0, 1, 0), normalize(vec3(1, 2, -3)), vec3(-1, 0, 0)}) {
      const SphereCase c{vec3(0.0f), 0.5f, distance * direction};
      const auto samples = samplesOf(worker, c, side);
      const Vector3 n = Vector3(c.centre) - Vector3(c.from);
      worst[0] =
          worse(worst[0],
                relativeError(irradianceBy(samples, Vector3(c.from), n),
                              oracle::ofSphere(Vector3(c.centre), c.radius, Vector3(c.from), n)));
      worst[1] = worse(worst[1], coneError(c, samples));
      worst[2] = worse(worst[2], twinError(worker, c, samples));
    }
    const double gap = 1.0 / std::sin(0.5 * angle) - 1.0;
    stress.row({fmt::format("{:g}", angle), fmt::format("{:.1e}", gap),
                fmt::format("{:.1e}", worst[0]), fmt::format("{:.1e}", worst[1]),
                fmt::format("{:.1e}", worst[2])});
    // Nearer than this, the rounding of the returned point is what can be seen of the error: it is
    // that share of the gap.
    constexpr double kNear = 1e-3;
    if (gap < kNear) {
      close = worse(close, worse(worst[0], worst[1]) * gap / 0x1p-24);
    } else {
      irradiance = worse(irradiance, worst[0]);
      cone = worse(cone, worst[1]);
    }
    twin = worse(twin, worst[2]);
  }
  stress.addError("sphereIrradiance", "spheres under 1e-6 to 3 rad: irradiance", irradiance, 1e-3,
                  1e-4);
  stress.addError("sphereDirections", "spheres: directions over the cone", cone, 2e-3, 2e-4);
  stress.addError("sphereNear",
                  "spheres nearer than that: error, in 2^-24 of the gap's distance in radii", close,
                  4.0, 2.0);
  stress.addError("spherePdf", "spheres: Sphere::pdf against the samples' densities", twin, 1e-3,
                  1e-5);
}

// From inside, the whole sphere is sampled by area: everything that the receiver sees is light, and
// the irradiance is pi.
void stressEnclosing(Stress& stress, StressWorker& worker) {
  const int side = stress.quick ? 256 : 512;
  double enclosing = 0.0, faults = 0.0;
  for (const float offset : {0.0f, 0.1f, 0.5f, 0.8f})
    for (const float radius : {1e-6f, 1.0f, 1e6f}) {
      const SphereCase c{vec3(0.0f), radius, radius * offset * normalize(vec3(2, -1, 1))};
      enclosing =
          worse(enclosing, relativeError(irradianceBy(samplesOf(worker, c, side), Vector3(c.from),
                                                      Vector3(1, 2, -1), true),
                                         kPiReal));
    }
  // On the surface rounding decides on which side the receiver is: that samples are such is all
  // that can be asked.
  for (const float radius : {1e-6f, 1.0f, 1e6f})
    for (const vec3& n : {vec3(0, 0, 1), normalize(vec3(1, 2, -3)), normalize(vec3(-3, 1, 1))})
      for (const LightSample& y :
           samplesOf(worker, {vec3(1.0f), radius, vec3(1.0f) + radius * n}, side / 4))
        if (!std::isfinite(y.pdf) || y.pdf < 0.0f ||
            (y.pdf > 0.0f && !(std::abs(length(y.n) - 1.0f) < 1e-5f)))
          ++faults;
  stress.addError("enclosingSphere", "spheres around the receiver: irradiance", enclosing, 1e-3,
                  1e-3);
  stress.addFaults("touchingSphere", "spheres that touch it: samples that are none", faults);
}

struct PolygonCase {
  CourseworkFunction function;
  std::vector<Point> vertices;
  Point x;  // a receiver, below the front

  Vector3 normal() const {
    return unit(glm::cross(Vector3(vertices[1]) - Vector3(vertices[0]),
                           Vector3(vertices[2]) - Vector3(vertices[0])));
  }
  std::vector<Vector3> exact() const { return {vertices.begin(), vertices.end()}; }
};

std::vector<LightSample> samplesOf(StressWorker& worker, const PolygonCase& c, int side) {
  CallWords object, inputs;
  const auto n = static_cast<int>(c.vertices.size());
  object.add(n, n - 2, vec3(c.normal()));
  for (const Point& v : c.vertices) object.add(v);
  for (int k = 2; k < n; ++k) object.add(0, k - 1, k);
  Grid{side}.forEach([&](float s, float t) { inputs.add(s, t); });
  const auto words = worker.call(c.function, object, inputs);
  AnswerWords answer(words);
  std::vector<LightSample> samples;
  while (!answer.atEnd()) samples.push_back(answer.lightSample());
  return samples;
}

// The samples' mean is the centre of mass, up to the rounding of their coordinates; here in units
// of the polygon's size, with the rounding taken off.
double centreError(const PolygonCase& c, const std::vector<LightSample>& samples) {
  Vector3 mean(0), centre(0);
  for (const LightSample& y : samples) mean += Vector3(y.p) - Vector3(c.vertices[0]);
  mean /= static_cast<Real>(samples.size());
  Real size = 0, magnitude = 0;
  for (const Point& v : c.vertices) {
    const Vector3 fromFirst = Vector3(v) - Vector3(c.vertices[0]);
    centre += fromFirst / static_cast<Real>(c.vertices.size());
    size = std::max(size, lengthOf(fromFirst));
    magnitude = std::max(magnitude, lengthOf(Vector3(v)));
  }
  const Real off = lengthOf(mean - centre) - magnitude * Real{0x1p-23};
  return static_cast<double>(std::max<Real>(off, 0) / size);
}

void stressPolygons(Stress& stress, StressWorker& worker) {
  stress.begin({.key = "polygonLights",
                .title = "Polygon lights, on a grid: relative errors",
                .columns = {{"light", "light"},
                            {"irradiance", "irradiance"},
                            {"density", "density"},
                            {"centre", "centre of mass"}},
                .rows = {}});
  const int side = stress.quick ? 128 : 256;
  double irradiance = 0.0, density = 0.0, centre = 0.0;
  const auto look = [&](const std::string& name, const PolygonCase& c, Real area) {
    const auto samples = samplesOf(worker, c, side);
    const std::vector<Vector3> exact = c.exact();
    const Vector3 n = -c.normal();
    const double e = relativeError(irradianceBy(samples, Vector3(c.x), n),
                                   oracle::ofPolygon(exact, Vector3(c.x), n));
    double d = 0.0;
    for (const LightSample& y : samples) d = worse(d, relativeError(Real{y.pdf} * area, 1));
    const double m = centreError(c, samples);
    stress.row(
        {name, fmt::format("{:.1e}", e), fmt::format("{:.1e}", d), fmt::format("{:.1e}", m)});
    irradiance = worse(irradiance, e);
    density = worse(density, d);
    centre = worse(centre, m);
  };
  using F = CourseworkFunction;
  for (const float aspect : {1.0f, 1e2f, 1e4f})
    for (const float longSide : {1e-2f, 1.0f, 1e4f}) {
      const Vector u = longSide * normalize(vec3(1, 0, 2)),
                   v = longSide / aspect * normalize(vec3(2, 0, -1));
      const Point p(0.5f * longSide, longSide, 0.25f * longSide);
      const PolygonCase c{F::kRectangularSampling, {p, p + v, p + v + u, p + u}, vec3(0.0f)};
      const Vector3 a = Vector3(c.vertices[1]) - Vector3(p),
                    b = Vector3(c.vertices[3]) - Vector3(p);
      look(fmt::format("{:g} : 1, {:g} long", aspect, longSide), c, lengthOf(glm::cross(a, b)));
    }
  for (const float size : {1.0f, 1e-2f, 1e-4f, 1e-6f}) {
    const Point p(0.3f, 0.4f, 0.5f);
    const PolygonCase c{F::kTriangularSampling,
                        {p, p + size * vec3(1, 0, 0.1f), p + size * vec3(0.2f, 0, 1)},
                        vec3(0.0f)};
    const Vector3 a = Vector3(c.vertices[1]) - Vector3(p), b = Vector3(c.vertices[2]) - Vector3(p);
    look(fmt::format("triangle, {:g}", size), c, lengthOf(glm::cross(a, b)) / 2);
  }
  stress.addError("polygonIrradiance", "rectangles to 1e4 : 1, triangles to 1e-6: irradiance",
                  irradiance, 2e-3, 5e-4);
  stress.addError("polygonDensity", "their densities", density, 1e-5, 1e-6);
  stress.addError("polygonCentre", "their centres of mass, in sizes", centre, 2e-3, 5e-4);
}

// A floor of one unit with a light over it; the shape is the light's JSON without emission.
LoadedScene litFloor(const std::string& light) {
  return sceneOf("light", fmt::format(R"({{
    "camera": {{"eye": [0, 1, 2], "target": [0, 0, 0], "fieldOfView": 40}}, "size": [8, 8],
    "maxBounces": 1, "materials": {{"white": {{"type": "lambertian", "Kd": [1, 1, 1]}}}},
    "shapes": [
      {{"type": "rectangle", "material": "white",
       "vertices": [[-0.5, 0, 0.5], [0.5, 0, 0.5], [0.5, 0, -0.5], [-0.5, 0, -0.5]]}},
      {{{}, "material": "white", "emission": [1, 1, 1]}}]}})",
                                      light));
}

// What the light causes on the floor's centre, by the light as it is after reading.
Real exactIrradiance(const FlatScene& scene) {
  const Vector3 x(0), up(0, 1, 0);
  const auto exact = [](const Float3& v) { return Vector3(v[0], v[1], v[2]); };
  if (scene.lights[0].sphere != FlatLight::kNoSphere) {
    const FlatSphere& s = scene.spheres[scene.lights[0].sphere];
    return oracle::ofSphere(exact(s.centre), s.radius, x, up);
  }
  std::vector<Vector3> vertices;
  for (const Float3& v : scene.lightVertices) vertices.push_back(exact(v));
  return oracle::ofPolygon(vertices, x, up);
}

struct Measured {
  double relative = 0.0;        // error
  double standardErrors = 0.0;  // the same in these
};

// The floor is white, and reflects the irradiance over pi.
Measured directLight(StressWorker& worker, const LoadedScene& scene, std::uint64_t rays) {
  constexpr std::uint32_t kReplicates = 32;
  worker.load(scene.flat);
  const EstimateRequest request{
      .function = static_cast<std::uint32_t>(CourseworkFunction::kDirectLighting),
      .sampler = SamplerKind::kPcg,
      .seed = 1,
      .replicates = kReplicates,
      .calls = 1,
      .rays = rays};
  CallWords inputs;
  const vec3 p(0.0f), n(0, 1, 0), wo = normalize(vec3(1, 1, 0));
  constexpr float kRounding = 1e-6f;
  inputs.add(p, n, kRounding, 0, wo);
  double sum = 0.0, squares = 0.0;
  for (const Estimate& e : worker.estimate(request, inputs)) {
    sum += e.mean[0];
    squares += e.mean[0] * e.mean[0];
  }
  const double mean = sum / kReplicates;
  const double error =
      std::sqrt(std::max(squares / kReplicates - mean * mean, 0.0) / (kReplicates - 1));
  const auto expected = static_cast<double>(exactIrradiance(scene.flat) / kPiReal);
  return {std::abs(mean / expected - 1.0), std::abs(mean - expected) / error};
}

void stressDirectLight(Stress& stress, StressWorker& worker) {
  stress.begin({.key = "directLight",
                .title = "Direct light of lights over a floor, by directLighting in scenes",
                .columns = {{"light", "light"},
                            {"error", "relative error"},
                            {"standardErrors", "standard errors"}},
                .rows = {}});
  std::vector<std::pair<std::string, std::string>> lights;
  for (const double r : {0.45, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 5e-7})
    lights.emplace_back(fmt::format("sphere under {:.1e} rad", 2.0 * std::asin(r / 0.5)),
                        fmt::format(R"("type": "sphere", "centre": [0, 0.5, 0], "radius": {})", r));
  lights.emplace_back("sphere, 1e-4 above",
                      R"("type": "sphere", "centre": [0, 0.4001, 0], "radius": 0.4)");
  for (const double width : {1.0, 1e-2, 1e-4})
    lights.emplace_back(fmt::format("rectangle {:g} : 1", 1.0 / width),
                        fmt::format(R"("type": "rectangle", "vertices":
                    [[-0.5, 0.5, 0], [0.5, 0.5, 0], [0.5, 0.5, {0}], [-0.5, 0.5, {0}]])",
                                    width));
  for (const double size : {1e-2, 1e-4, 1e-6})
    lights.emplace_back(
        fmt::format("triangle, {:g}", size),
        fmt::format(
            R"("type": "triangle", "vertices": [[0, 0.5, 0], [{0}, 0.5, 0], [0, 0.5, {0}]])",
            size));
  // The largest of so many standard errors, of which each has its sign: beyond 6 once in 10^7
  // runs; rounding may add a hundredth of a percent.
  constexpr double kMost = 6.0, kRounding = 1e-4;
  double worst = 0.0;
  const std::uint64_t rays = stress.quick ? 4096 : 65536;
  for (const auto& [name, shape] : lights) {
    stress.progress.show(name);
    const Measured m = directLight(worker, litFloor(shape), rays);
    stress.row({name, fmt::format("{:.1e}", m.relative), fmt::format("{:.1f}", m.standardErrors)});
    if (!(m.relative <= kRounding)) worst = worse(worst, m.standardErrors);
  }
  stress.addError("directLight", "direct light in scenes: standard errors off, beyond 0.01 %",
                  worst, kMost, kMost);
}

}  // namespace

void stressLights(Stress& stress) {
  StressWorker worker(stress);
  stressSpheres(stress, worker);
  stressEnclosing(stress, worker);
  stressPolygons(stress, worker);
  stressDirectLight(stress, worker);
  stress.progress.advance(15.0);
}

}  // namespace pathmark::bench
