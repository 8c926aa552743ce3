// What is asked of part 3, the Lambertian BRDF.
#include "checks/all_checks.h"
#include "checks/calls.h"
#include "checks/channels.h"
#include "checks/direction_checks.h"
#include "checks/exact.h"
#include "checks/points.h"
#include "stats/moments.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr double kPiD = std::numbers::pi;
constexpr double kRoundoff = 0x1p-24;

const Colour kKd(0.9f, 0.5f, 0.2f), kOtherKd(0.1f, 0.7f, 0.4f);

// A pair of directions at a point of a surface. The cosines are those of the vectors as floats.
struct Pair {
  Vector wo, wi, n;
  double cosO, cosI;

  Pair(const Vector& wo_, const Vector& wi_, const Vector& n_)
      : wo(wo_),
        wi(wi_),
        n(n_),
        cosO(glm::dot(glm::dvec3(wo_), glm::dvec3(n_))),
        cosI(glm::dot(glm::dvec3(wi_), glm::dvec3(n_))) {}

  bool bothAbove() const { return cosO > 0.0 && cosI > 0.0; }
  std::string text() const {
    return fmt::format("wo = {}, wi = {}, n = {}", checks::text(wo), checks::text(wi),
                       checks::text(n));
  }
};

// From plain directions to all sides of awkward normals; none so near the horizon that rounding
// decides on which side it is.
std::vector<Pair> pairs(std::uint64_t seed) {
  std::vector<Pair> result{{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  Random random(seed);
  const std::vector<Vector> normals = awkwardNormals(seed);
  for (const double cosI : {0.7, -0.7, 0.2, -0.2, 0.999, -0.999, 0.01, -0.01})
    for (const double cosO : {0.6, -0.6, 0.05})
      for (const Vector& n : normals) {
        const double a = random.between(0.0, 2.0 * kPiD), b = random.between(0.0, 2.0 * kPiD);
        result.emplace_back(atCosine(n, cosO, a), atCosine(n, cosI, b), n);
      }
  return result;
}

Finding valueIsKdOverPi(CheckRun& run) {
  const std::vector<Pair> inputs = pairs(run.seed);
  Exact exact{"the factor 1/pi is missing",
              "the cosine is part of the BRDF: it belongs to the caller",
              "no test of the sides: the back reflects",
              "only the side of wi is tested",
              "only the side of wo is tested",
              "1/(2 pi) stands where 1/pi belongs",
              "Kd/pi is kept from the first call: each material has its own Kd"};
  for (const Colour& kd : {kKd, kOtherKd}) {
    Calls calls(F::kLambertianBrdf, Words().add(kd));
    for (const Pair& p : inputs) calls.add(p.wo, p.wi, p.n);
    const Results results = calls.run(run.worker);
    exact.count(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const Pair& p = inputs[i];
      for (int c = 0; c < 3; ++c) {
        const double f = double{kd[c]} / kPiD, expected = p.bothAbove() ? f : 0.0;
        const double kept = p.bothAbove() ? double{kKd[c]} / kPiD : 0.0;
        exact.value(inChannel("f", c), results.vector(i, 0)[c], expected, relativeTolerance() * f,
                    [&] { return fmt::format("Kd = {}, {}", text(kd), p.text()); },
                    {expected * kPiD, expected * p.cosI, f, p.cosI > 0.0 ? f : 0.0,
                     p.cosO > 0.0 ? f : 0.0, 0.5 * expected, kept});
      }
    }
  }
  return exact.finding();
}

// The contract's density, or any other that integrates to one: what it must fit is what
// `reflection` does, which another check asks.
Finding densityIsADensity(CheckRun& run) {
  constexpr int kCosines = 64, kAzimuths = 16;
  Exact exact;
  for (const Vector& n : awkwardNormals(run.seed)) {
    const DoubleFrame frame{glm::dvec3(n)};
    const Vector wo = atCosine(n, 0.6, 1.0);
    Calls calls(F::kLambertianPdf, Words().add(kKd));
    // The midpoint rule in the squared cosine, which is exact for a density of a + b cos(theta)
    // up to O(1/kCosines^2); the azimuth is spread evenly.
    std::vector<double> weights;
    for (int ring = 0; ring < kCosines; ++ring)
      for (int k = 0; k < kAzimuths; ++k) {
        const double low = static_cast<double>(ring) / kCosines,
                     high = static_cast<double>(ring + 1) / kCosines;
        const double cosine = 0.5 * (low + high);
        calls.add(wo, Vector(frame.direction(cosine, 2.0 * kPiD * (k + 0.5) / kAzimuths)), n);
        weights.push_back(2.0 * kPiD * (high - low) / kAzimuths);
      }
    for (const double cosine : {-0.01, -0.3, -0.7, -0.999})
      for (int k = 0; k < kAzimuths; ++k)
        calls.add(wo, atCosine(n, cosine, 2.0 * kPiD * k / kAzimuths), n);
    const Results results = calls.run(run.worker);
    exact.count(results.count());
    double integral = 0.0;
    const auto where = [&] { return fmt::format("n = {}", text(n)); };
    for (std::size_t i = 0; i < results.count(); ++i) {
      const double pdf = results.number(i, 0);
      if (!exact.holds(
              std::isfinite(pdf) && pdf >= 0.0, "a density, at least 0",
              [&] { return fmt::format("pdf = {:.6g}", pdf); }, where))
        return exact.finding();
      if (i < weights.size())
        integral += weights[i] * pdf;
      else
        exact.value("pdf below the surface", pdf, 0.0, 0.0, where);
    }
    exact.value("integral of pdf over the hemisphere", integral, 1.0, 2e-3, where);
  }
  return exact.finding();
}

Finding directionsAreValid(CheckRun& run) {
  struct Input {
    Vector wo, n;
    float s, t, u;
  };
  std::vector<Input> inputs;
  Random random(run.seed);
  for (const Vector& n : awkwardNormals(run.seed)) {
    const Vector wo = atCosine(n, 0.6, 1.0);
    for (int k = 0; k < 16; ++k)
      inputs.push_back({wo, n, random.uniform(), random.uniform(), random.uniform()});
    for (const float s : kEdgeNumbers)
      for (const float t : kEdgeNumbers)
        for (const float u : kEdgeNumbers) inputs.push_back({wo, n, s, t, u});
  }
  Calls calls(F::kLambertianReflection, Words().add(kKd));
  for (int again = 0; again < 2; ++again)
    for (const Input& in : inputs) calls.add(in.wo, in.n, in.s, in.t, in.u);
  const Results results = calls.run(run.worker);
  Exact exact{"the sine is taken of sqrt(1 - t): sqrt(1 - t) is sin(theta) already",
              "the sine is 1 - t, without its root", "the cosine is t, without its root"};
  exact.count(results.count());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input& in = inputs[i];
    const auto where = [&] {
      return fmt::format("n = {}, s = {:.8g}, t = {:.8g}, u = {:.8g}", text(in.n), in.s, in.t,
                         in.u);
    };
    const Vector wi = results.vector(i, 0);
    const double pdf = results.number(i, 3);
    const auto got = [&] { return fmt::format("wi = {}, pdf = {:.6g}", text(wi), pdf); };
    if (!exact.holds(results.finite(i) && pdf >= 0.0, "finite numbers, a density of at least 0",
                     got, where))
      break;
    exact.holds(
        results.same(i, i + inputs.size()),
        "the same direction again for the same s, t, u, without random numbers of its own",
        [&] {
          return fmt::format("wi = {} and then {}", text(wi),
                             text(results.vector(i + inputs.size(), 0)));
        },
        where);
    if (pdf == 0.0) continue;
    const double t = in.t, sine = std::sqrt(1.0 - t);
    exact.value("length of wi", glm::length(glm::dvec3(wi)), 1.0, 8.0 * kRoundoff, where,
                {std::hypot(std::sqrt(t), std::sin(sine)), std::hypot(std::sqrt(t), 1.0 - t),
                 std::hypot(t, sine)});
    exact.holds(glm::dot(glm::dvec3(wi), glm::dvec3(in.n)) > -8.0 * kRoundoff,
                "wi above the surface, or pdf = 0", got, where);
  }
  return exact.finding();
}

const AxialDensity kCosineDensity{
    .density = [](double c) { return std::max(c, 0.0) / kPiD; },
    .mass = [](double low, double high) { return high * high - low * low; },
    .meanCosine = 2.0 / 3.0,
    .meanCosine2 = 0.5};

std::vector<DrawnDirection> draw(CheckRun& run, const Vector& wo, const Vector& n,
                                 const std::vector<DirectionDraw>& points) {
  return drawReflections(run, F::kLambertianReflection, Words().add(kKd), wo, n, points);
}

// A density other than the contract's is correct; what it costs is said.
std::string remarkOnNoise(CheckRun& run) {
  constexpr std::uint32_t kPoints = 4096;
  const Vector n(0, 1, 0), wo(0.6f, 0.8f, 0.0f);
  Points points(run.seed, kPoints);
  stats::RunningMoments weights;
  for (const DrawnDirection& d : draw(run, wo, n, drawsOf(points, kPoints, 0, 1)))
    weights.add(d.pdf > 0.0 ? std::max(double{d.wi.y}, 0.0) / kPiD / d.pdf : 0.0);
  if (weights.variance() < 0.01) return {};
  return fmt::format(
      "correct, but noisier than the density cos(theta)/pi: the weight f cos(theta) / pdf varies "
      "by {:.0f} % from direction to direction, and by nothing with that density",
      100.0 * std::sqrt(weights.variance()) / weights.mean());
}

// Why directions around this normal do not follow their density; empty if most are above the
// surface.
std::string causeBelow(CheckRun& run, const Vector& wo, const Vector& n) {
  constexpr std::uint32_t kPoints = 1024;
  constexpr double kMany = 0.25;
  Points points(run.seed, kPoints);
  double below = 0.0;
  for (const DrawnDirection& d : draw(run, wo, n, drawsOf(points, kPoints, 0, 1)))
    if (glm::dot(glm::dvec3(d.wi), glm::dvec3(n)) < 0.0) below += 1.0 / kPoints;
  if (below < kMany) return {};
  return fmt::format(
      "{:.0f} % of the directions are below the surface: they must lie around n, not around an "
      "axis of the world or a tangent; Frame(n).toWorld takes a local direction with y along n",
      100.0 * below);
}

Finding samplesFollowTheirDensity(CheckRun& run) {
  const auto cosine = [](double c) { return std::max(c, 0.0) / kPiD; };
  const auto uniform = [](double) { return 0.5 / kPiD; };
  const auto axial = [&](const std::function<double(double)>& actual,
                         const std::function<double(double)>& claimed) {
    return axialMoments(kCosineDensity, actual, claimed, 0.0);
  };
  const std::vector<Suspicion> suspicions{
      {"the directions are uniform on the hemisphere, and the density is that of the cosine",
       axial(uniform, cosine)},
      {"the directions have the cosine's density, and the returned density is the uniform one",
       axial(cosine, uniform)},
      {"theta is proportional to t: the angle is uniform instead of the squared cosine",
       axial(
           [](double c) { return 1.0 / (kPiD * kPiD * std::sqrt(std::max(1.0 - c * c, 1e-300))); },
           cosine)},
      {"the returned density lacks its factor 1/pi",
       axial(cosine, [](double c) { return std::max(c, 0.0); })},
  };
  Finding worst;
  std::uint64_t calls = 0;
  const std::vector<Vector> normals = awkwardNormals(run.seed);
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Vector n = normals[k], wo = atCosine(n, 0.6, 1.0);
    CheckRun own{run.worker, run.seed + k, run.budget};
    Finding finding = judgeOwnDensity(
        own, n, kCosineDensity, [&](const auto& points) { return draw(run, wo, n, points); },
        fmt::format("n = {}", text(n)), 64, suspicions);
    calls += finding.calls;
    if (k == 0 || !finding.passed()) worst = finding;
    if (finding.passed()) continue;
    if (worst.status == Status::kFail && worst.cause.empty()) worst.cause = causeBelow(run, wo, n);
    break;
  }
  worst.calls = calls;
  if (worst.passed()) worst.remark = remarkOnNoise(run);
  return worst;
}

// Correct is any density; the one that the contract names leaves no noise of its own.
Finding densityIsThatOfReflection(CheckRun& run) {
  struct Input {
    Vector wo, n;
    vec2 st;
    float u;
  };
  std::vector<Input> inputs;
  Random random(run.seed);
  for (const Vector& n : awkwardNormals(run.seed))
    for (int k = 0; k < 64; ++k)
      inputs.push_back({atCosine(n, random.between(0.05, 1.0), random.between(0.0, 6.0)),
                        n,
                        {random.uniform(), random.uniform()},
                        random.uniform()});
  Calls sample(F::kLambertianReflection, Words().add(kKd)),
      density(F::kLambertianPdf, Words().add(kKd));
  for (const Input& in : inputs) sample.add(in.wo, in.n, in.st, in.u);
  const Results drawn = sample.run(run.worker);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    density.add(inputs[i].wo, drawn.vector(i, 0), inputs[i].n);
  const Results pdf = density.run(run.worker);
  Exact exact{"pdf lacks the factor 1/pi", "pdf is the uniform density 1/(2 pi)"};
  exact.count(drawn.count() + pdf.count());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double claimed = drawn.number(i, 3), got = pdf.number(i, 0);
    const double cosine = glm::dot(glm::dvec3(drawn.vector(i, 0)), glm::dvec3(inputs[i].n));
    // Next to the horizon the cosine is a difference: relative to it, a rounding of wi is large.
    const double allowed =
        relativeTolerance(1.0 / std::max(std::abs(cosine), 1e-3)) * claimed + 1e-6;
    exact.value(
        "pdf(wo, wi, n) for the wi and pdf of reflection", got, claimed, allowed,
        [&] { return fmt::format("wi = {}, n = {}", text(drawn.vector(i, 0)), text(inputs[i].n)); },
        {claimed * kPiD, 0.5 / kPiD});
  }
  return exact.finding();
}

}  // namespace

std::span<const Check> part3Checks() {
  static const std::vector<Check> kChecks{
      {"value", F::kLambertianBrdf,
       "f is Kd/pi where wo and wi are both above the surface, and 0 elsewhere", 0.0,
       valueIsKdOverPi},
      {"density", F::kLambertianPdf,
       "pdf is a density: at least 0, 0 below the surface, and its integral is 1", 0.0,
       densityIsADensity},
      {"valid", F::kLambertianReflection,
       "for all s, t, u, also at the ends, wi is a unit vector above the surface, and the same "
       "again for the same numbers",
       0.0, directionsAreValid},
      {"samples", F::kLambertianReflection,
       "the directions follow the density they are returned with", 0.01, samplesFollowTheirDensity},
      {"own-density",
       F::kLambertianPdf,
       "pdf says of a direction the density with which reflection returns it",
       0.0,
       densityIsThatOfReflection,
       {F::kLambertianReflection}},
  };
  return kChecks;
}

}  // namespace pathmark::checks
