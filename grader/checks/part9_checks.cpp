// What is asked of bonus part 9: points on triangles and rectangles by the solid angle.
#include "checks/all_checks.h"
#include "checks/calls.h"
#include "checks/exact.h"
#include "checks/seen_light.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

constexpr bool isOfTriangles(F f) {
  return f == F::kSphericalTriangleSampling || f == F::kSphericalTrianglePdf;
}

constexpr F twinOf(F sampling) {
  return isOfTriangles(sampling) ? F::kSphericalTrianglePdf : F::kSphericalRectanglePdf;
}

constexpr F samplingOf(F pdf) {
  return isOfTriangles(pdf) ? F::kSphericalTriangleSampling : F::kSphericalRectangleSampling;
}

std::vector<vec2> randomPairs(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<vec2> pairs;
  for (std::size_t k = 0; k < count; ++k) pairs.emplace_back(random.uniform(), random.uniform());
  return pairs;
}

Results draw(CheckRun& run, F sampling, const SeenLight& light, const std::vector<vec2>& pairs) {
  Calls calls(sampling, light.outline().words());
  for (const vec2& st : pairs) calls.add(light.from(), st);
  return calls.run(run.worker);
}

std::string withNumbers(const SeenLight& light, const vec2& st) {
  return fmt::format("{}, s = {:.8g}, t = {:.8g}", light.text(), st.x, st.y);
}

constexpr const char* kAtan =
    "the solid angle is wrong where a triangle fills more than pi: use atan2, whose denominator "
    "may be negative";

bool isPastPi(const SeenLight& light) {
  return light.outline().vertices().size() == 3 && light.omega() > std::numbers::pi;
}

// What is not a density above 0 on lights of more than pi only.
Finding noDensity(const Exact& exact, const SeenLight& light, double pdf) {
  Finding finding = exact.finding();
  if (pdf <= 0.0 && isPastPi(light)) finding.cause = kAtan;
  return finding;
}

template <F kSampling>
Finding pointsAreOfTheLight(CheckRun& run) {
  Exact exact;
  for (const SeenLight& light : lightsInSight(isOfTriangles(kSampling), run.seed)) {
    std::vector<vec2> pairs = randomPairs(run.seed + 1, 48);
    for (const float s : kEdgeNumbers)
      for (const float t : kEdgeNumbers) pairs.emplace_back(s, t);
    const std::size_t count = pairs.size();
    for (std::size_t i = count; i-- > 0;) pairs.push_back(pairs[i]);
    const Results results = draw(run, kSampling, light, pairs);
    exact.count(results.count());
    for (std::size_t i = 0; i < count; ++i) {
      const auto where = [&] { return withNumbers(light, pairs[i]); };
      const Point p = results.vector(i, 0);
      const double pdf = results.number(i, 6);
      const auto got = [&] {
        return fmt::format("p = {}, n = {}, pdf = {:.6g}", text(p), text(results.vector(i, 3)),
                           pdf);
      };
      if (!exact.holds(results.finite(i) && pdf > 0.0, "finite numbers, and a density above 0", got,
                       where))
        return noDensity(exact, light, pdf);
      const double distance = light.outline().distance(p);
      exact.holds(
          distance <= light.edgeTolerance(p) && light.offPlane(p) <= light.planeTolerance(),
          "a point of the light",
          [&] { return fmt::format("p = {}, which is off it by {:.3g}", text(p), distance); },
          where);
      exact.holds(
          glm::length(glm::dvec3(results.vector(i, 3)) - glm::dvec3(light.outline().normal())) <=
              relativeTolerance(light.outline().condition()),
          fmt::format("n = normal() = {}", text(light.outline().normal())), got, where);
      exact.holds(results.same(i, 2 * count - 1 - i), "the same point again for the same s and t",
                  got, where);
    }
  }
  return exact.finding();
}

class DensityValues {
 public:
  void see(const SeenLight& light, const Point& p, double pdf, const Where& where) {
    const double q = light.density(p), omega = light.omega();
    const double r = glm::length(glm::dvec3(p) - glm::dvec3(light.from()));
    const double perArea = q * omega;  // cos(theta') / r^2
    // The triangle's half angle is beyond a right angle then.
    const double rest = 2.0 * std::numbers::pi - omega;
    exact_.value("pdf", pdf, q, light.tolerance(p) * q, where,
                 {isPastPi(light) ? -perArea / rest : q, isPastPi(light) ? perArea / rest : q,
                  1.0 / light.outline().area(), 1.0 / omega, perArea, 1.0 / perArea / omega, q * r,
                  perArea / (4.0 * std::numbers::pi), perArea * omega, 2.0 * q, q * r * r});
  }
  void count(std::uint64_t calls) { exact_.count(calls); }
  Finding finding() const { return exact_.finding(); }

 private:
  Exact exact_{kAtan,
               kAtan,
               "one over the area: these points are to be uniform over the solid angle",
               "1 / omega is the density per unit solid angle: it must be per unit area",
               "omega is missing",
               "cos(theta') / r^2 is divided by where it must be multiplied with",
               "r stands where r^2 belongs",
               "the solid angle of the whole sphere stands in place of the light's",
               "multiplied with omega where it must be divided by",
               "the solid angle of half of the light, or omega / 2: 2 atan(...) is it, and a "
               "rectangle is two triangles",
               "r^2 is missing"};
};

template <F kSampling>
Finding densityIsOverTheSolidAngle(CheckRun& run) {
  DensityValues values;
  for (const SeenLight& light : lightsInSight(isOfTriangles(kSampling), run.seed)) {
    if (!light.mustBeUniform()) continue;
    const std::vector<vec2> pairs = randomPairs(run.seed + 2, 64);
    const Results results = draw(run, kSampling, light, pairs);
    values.count(results.count());
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values.see(light, results.vector(i, 0), results.number(i, 6),
                 [&] { return withNumbers(light, pairs[i]); });
  }
  return values.finding();
}

// Each sample counts with the contract's density over its own, so that of a small light any density
// passes that its points follow.
template <F kSampling>
Finding judgeLight(CheckRun& run, const SeenLight& light, std::uint64_t seed) {
  constexpr std::uint32_t kPerReplicate = 256;
  const std::vector<Mean> means = light.means();
  Points points(seed, kPerReplicate);
  std::uint64_t made = 0;
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<vec2> pairs;
    for (std::uint32_t r = first; r < first + count; ++r) {
      points.start(r);
      for (std::uint32_t m = 0; m < kPerReplicate; ++m) {
        points.point(m);
        pairs.push_back(points.pair());
      }
    }
    const Results results = draw(run, kSampling, light, pairs);
    made += results.count();
    std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t i = 0; i < results.count(); ++i) {
      const auto sums = values.subspan(i / kPerReplicate * means.size(), means.size());
      const double pdf = results.number(i, 6);
      if (!results.finite(i))
        sums[0] = std::numeric_limits<double>::quiet_NaN();
      else if (pdf > 0.0)
        light.add(results.vector(i, 0), light.density(results.vector(i, 0)) / pdf / kPerReplicate,
                  sums);
    }
  };
  std::vector<Suspicion> suspicions;
  if (light.mustBeUniform())
    suspicions.push_back(
        {"the points are uniform by area, and not over the solid angle that the "
         "density is of",
         light.meansByArea()});
  CheckRun own{run.worker, seed, run.budget, run.function};
  Finding finding = judgeMeans(own, means, measure, light.text(), suspicions);
  finding.calls = made;
  if (finding.status == Status::kFail && finding.cause.empty() && !light.mustBeUniform())
    finding.cause =
        "what cancels for lights that fill a small solid angle: a sum of angles minus pi, or "
        "cosines that round to 1; below 1e-3 sr points uniform by area, with their density, will "
        "do";
  return finding;
}

template <F kSampling>
Finding samplesFollowTheirDensity(CheckRun& run) {
  Finding worst;
  std::uint64_t calls = 0, seed = run.seed;
  for (const SeenLight& light : lightsInSight(isOfTriangles(kSampling), run.seed)) {
    const Finding finding = judgeLight<kSampling>(run, light, ++seed);
    calls += finding.calls;
    if (worst.passed()) worst = finding;
    if (!finding.passed()) break;
  }
  worst.calls = calls;
  return worst;
}

// From behind, and in the plane.
template <F kFunction>
Finding darkFromBehind(CheckRun& run) {
  Exact exact;
  for (const SeenLight& light : lightsInSight(isOfTriangles(kFunction), run.seed)) {
    const Outline& outline = light.outline();
    std::vector<std::pair<Point, const char*>> places{
        {outline.vertices()[0] - (light.from() - outline.vertices()[0]),
         "`from` is behind the light"}};
    const Vector n = outline.normal();
    if (n == Vector(0, -1, 0))
      places.emplace_back(outline.vertices()[0] + Vector(7, 0, 3),
                          "`from` is in the light's plane");
    for (const auto& [from, why] : places) {
      Calls calls(kFunction, outline.words());
      constexpr bool kDraws = kFunction == samplingOf(kFunction);
      const std::vector<vec2> pairs = randomPairs(run.seed, 16);
      for (const vec2& st : pairs) {
        if (kDraws)
          calls.add(from, st);
        else
          calls.add(from, outline.vertices()[0] +
                              0.5f * st.x * (outline.vertices()[1] - outline.vertices()[0]));
      }
      const Results results = calls.run(run.worker);
      exact.count(results.count());
      for (std::size_t i = 0; i < results.count(); ++i) {
        const double pdf = results.number(i, kDraws ? 6 : 0);
        exact.holds(
            pdf == 0.0, "the density 0", [&] { return fmt::format("pdf = {:.6g}", pdf); },
            [&, where = from] {
              return fmt::format("{}, from = {}: {}", outline.text(), text(where), why);
            });
      }
    }
  }
  Finding finding = exact.finding();
  if (exact.failed())
    finding.cause = "the sign of the cosine at the light: from behind nothing of it is seen";
  return finding;
}

template <F kPdf>
Finding pdfIsThatOfSample(CheckRun& run) {
  Exact exact;
  for (const SeenLight& light : lightsInSight(isOfTriangles(kPdf), run.seed)) {
    const std::vector<vec2> pairs = randomPairs(run.seed + 3, 64);
    const Results drawn = draw(run, samplingOf(kPdf), light, pairs);
    Calls calls(kPdf, light.outline().words());
    for (std::size_t i = 0; i < drawn.count(); ++i) calls.add(light.from(), drawn.vector(i, 0));
    const Results pdf = calls.run(run.worker);
    exact.count(2 * drawn.count());
    for (std::size_t i = 0; i < drawn.count(); ++i) {
      const double claimed = drawn.number(i, 6);
      exact.value("pdf of the point that was drawn", pdf.number(i, 0), claimed,
                  light.tolerance(drawn.vector(i, 0)) * claimed,
                  [&] { return withNumbers(light, pairs[i]); });
    }
  }
  return exact.finding();
}

template <F kPdf>
Finding pdfIsADensity(CheckRun& run) {
  Exact exact;
  DensityValues values;
  for (const SeenLight& light : lightsInSight(isOfTriangles(kPdf), run.seed)) {
    const auto nodes = light.quadrature();
    Calls calls(kPdf, light.outline().words());
    for (const auto& [p, share] : nodes) calls.add(light.from(), p);
    const Results results = calls.run(run.worker);
    exact.count(results.count());
    double integral = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double pdf = results.number(i, 0);
      if (!exact.holds(
              std::isfinite(pdf) && pdf > 0.0, "a density above 0 on all of the light",
              [&] { return fmt::format("pdf = {:.6g}", pdf); },
              [&] { return fmt::format("{}, p = {}", light.text(), text(nodes[i].first)); }))
        return noDensity(exact, light, pdf);
      if (light.mustBeUniform() && i % 37 == 0)
        values.see(light, nodes[i].first, pdf,
                   [&] { return fmt::format("{}, p = {}", light.text(), text(nodes[i].first)); });
      integral += nodes[i].second * pdf;
    }
    const double rounding = light.mustBeUniform() ? light.angleTolerance() / light.omega() : 0.0;
    exact.value("integral of pdf over the light's area", integral, 1.0, 1e-3 + rounding,
                [&] { return light.text(); });
  }
  Finding finding = exact.finding();
  if (exact.failed()) finding.cause = values.finding().cause;
  return finding;
}

template <F kSampling>
void addChecks(std::vector<Check>& all) {
  constexpr F kPdf = twinOf(kSampling);
  all.push_back({"points", kSampling,
                 "for all s and t, also at the ends, p is a point of the light and n its normal, "
                 "the density is above 0, and the same again for the same numbers",
                 0.0, pointsAreOfTheLight<kSampling>});
  all.push_back({"density", kSampling,
                 "the density is cos(theta') / (omega r^2), where omega is 1e-3 sr or more", 0.0,
                 densityIsOverTheSolidAngle<kSampling>});
  all.push_back({"samples", kSampling,
                 "the points follow the density per unit area that they are returned with", 0.01,
                 samplesFollowTheirDensity<kSampling>});
  all.push_back({"dark", kSampling, "the density is 0 from behind the light and in its plane", 0.0,
                 darkFromBehind<kSampling>});
  all.push_back({"integral", kPdf,
                 "pdf is a density per unit area: above 0, and its integral over the light is 1",
                 0.0, pdfIsADensity<kPdf>});
  all.push_back({"dark", kPdf, "the density is 0 from behind the light and in its plane", 0.0,
                 darkFromBehind<kPdf>});
  all.push_back({"own-density",
                 kPdf,
                 "pdf says of a point the density with which it is drawn",
                 0.0,
                 pdfIsThatOfSample<kPdf>,
                 {kSampling}});
}

}  // namespace

std::span<const Check> part9Checks() {
  static const std::vector<Check> kChecks = [] {
    std::vector<Check> all;
    addChecks<F::kSphericalTriangleSampling>(all);
    addChecks<F::kSphericalRectangleSampling>(all);
    return all;
  }();
  return kChecks;
}

}  // namespace pathmark::checks
