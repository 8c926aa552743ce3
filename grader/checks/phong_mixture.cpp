#include "checks/phong_mixture.h"

#include "checks/calls.h"
#include "checks/phong_mistakes.h"
#include "checks/phong_quadrature.h"
#include "stats/moments.h"

#include <fmt/format.h>

#include <array>

namespace pathmark::checks {

namespace {

constexpr std::uint32_t kPointsPerReplicate = 128;
constexpr int kLooks = 3;

constexpr std::array kNames{
    "mean weight",
    "mean of cos(theta)",
    "mean of cos(theta)^2",
    "mean of the tangential component in the plane of incidence",
    "mean of the component across the plane of incidence",
    "mean of cos(alpha)^(m+1)",
    "mean of cos(alpha)^(2m+2)",
    "mean of cos(alpha)^(m+1) times the cosine of the azimuth around the mirror direction",
    "mean of cos(alpha)^(m+1) times the sine of the azimuth around the mirror direction",
    "third harmonic of the azimuth around the mirror direction",
    "mean weight of the directions below the surface",
};
constexpr std::size_t kWeight = 0, kMoments = kNames.size() - 1, kBelow = kMoments;
constexpr std::size_t kMeans = kNames.size() + PhongFrame::kCells;

// Of a direction above the surface: without the cells.
std::array<double, kMoments> moments(const PhongFrame& frame, const PhongLobes& lobes,
                                     const glm::dvec3& wi) {
  const double cosine = lobes.cosTheta(wi), v = frame.lobeQuantile(wi);
  const double azimuth = frame.azimuth(wi);
  return {
      1.0, cosine, cosine * cosine,       glm::dot(wi, frame.tangent), glm::dot(wi, frame.across),
      v,   v * v,  v * std::cos(azimuth), v * std::sin(azimuth),       v * std::cos(3.0 * azimuth)};
}

// Next to the horizon, and far from a lobe, a density is a small number with a rounding of its own.
double weightOf(double density, double pdf) {
  constexpr double kRounding = 16.0 * 0x1p-24;
  return std::abs(density - pdf) <= kRounding ? 1.0 : density / pdf;
}

// The tangential components of grazing lobes are the noisiest.
constexpr double kDeltaOfWeight = 0.01, kDeltaOfMoments = 0.03, kDeltaOfCells = 0.02;

// Sums of weighted functions of directions.
class Sums {
 public:
  explicit Sums(const MixtureCase& c)
      : lobes_(c.wo, c.n, c.material.exponent), frame_(lobes_), share_(c.material.diffuseShare()) {}

  const PhongLobes& lobes() const { return lobes_; }
  double contract(const glm::dvec3& wi) const { return lobes_.mixture(share_, wi); }

  void add(std::span<double> sums, const glm::dvec3& wi, double weight) const {
    if (lobes_.cosTheta(wi) <= 0.0) {
      sums[kWeight] += weight;
      sums[kBelow] += weight;
      return;
    }
    const auto g = moments(frame_, lobes_, wi);
    for (std::size_t k = 0; k < kMoments; ++k) sums[k] += weight * g[k];
    sums[kNames.size() + frame_.cellOf(wi)] += weight;
  }

 private:
  PhongLobes lobes_;
  PhongFrame frame_;
  double share_;
};

struct Expected {
  std::array<double, kMeans> mean{}, size{};  // of the functions, and of their absolute values
};

Expected expectedOf(const Sums& sums) {
  Expected result;
  std::array<double, kMeans> g{};
  for (const PhongNode& node : phongNodes(sums.lobes())) {
    g.fill(0.0);
    sums.add(g, node.wi, node.weight * sums.contract(node.wi));
    for (std::size_t k = 0; k < kMeans; ++k) {
      result.mean[k] += g[k];
      result.size[k] += std::abs(g[k]);
    }
  }
  return result;
}

std::string cellName(std::size_t cell) {
  constexpr std::array kRingNames{
      "innermost quarter of the specular lobe", "second quarter of the specular lobe",
      "third quarter of the specular lobe", "outermost quarter of the specular lobe",
      "directions beyond 90 degrees of the mirror direction"};
  return fmt::format("share of the samples in the {}, above the surface, quarter turn {}",
                     kRingNames[cell / PhongFrame::kSectors], cell % PhongFrame::kSectors + 1);
}

// `relative`: of the lobe's power, by rounding.
std::vector<Mean> meansOf(const Expected& expected, double relative) {
  std::vector<Mean> means(kMeans);
  for (std::size_t k = 0; k < kMeans; ++k) {
    Mean& mean = means[k];
    mean.what = k < kNames.size() ? kNames[k] : cellName(k - kNames.size());
    mean.expected = expected.mean[k];
    mean.delta = k == kWeight ? kDeltaOfWeight : k <= kBelow ? kDeltaOfMoments : kDeltaOfCells;
    const double rounding = std::max(relative * expected.size[k] - mean.tolerance, 0.0);
    mean.tolerance += rounding;
    mean.delta += 1.5 * rounding;
  }
  return means;
}

// Where no direction below the surface has a density, which is right too.
void countNothingBelowAsRight(std::span<double> means, const Expected& expected) {
  if (means[kBelow] != 0.0) return;
  means[kBelow] = expected.mean[kBelow];
  means[kWeight] += expected.mean[kBelow];
}

// What directions drawn in the wrong way would give, if they were returned with the density of the
// contract's mixture.
std::vector<Suspicion> suspicionsOf(const MixtureCase& c, const Sums& sums,
                                    const Expected& expected, std::uint64_t seed) {
  constexpr std::uint32_t kPoints = 1u << 10, kReplicates = 16;
  std::vector<Suspicion> suspicions;
  Points points(seed, kPoints);
  const std::vector<DirectionDraw> draws = drawsOf(points, kPoints, 0, kReplicates);
  for (const PhongMistake& mistake : phongMistakes(c)) {
    Suspicion suspicion{mistake.text, std::vector<double>(kMeans, 0.0)};
    for (const DirectionDraw& p : draws) {
      const glm::dvec3 wi = mistake.draw(p);
      if (sums.contract(wi) > 0.0) sums.add(suspicion.means, wi, 1.0 / (kPoints * kReplicates));
    }
    countNothingBelowAsRight(suspicion.means, expected);
    suspicions.push_back(std::move(suspicion));
  }
  return suspicions;
}

}  // namespace

std::string MixtureCase::text() const {
  return fmt::format("{}, n = {}, wo = {}", material.text(), checks::text(n), checks::text(wo));
}

std::vector<DrawnDirection> drawPhong(CheckRun& run, const MixtureCase& c,
                                      const std::vector<DirectionDraw>& points) {
  return drawReflections(run, CourseworkFunction::kPhongReflection, c.material.words(), c.wo, c.n,
                         points);
}

MixtureFinding judgeMixture(CheckRun& run, const MixtureCase& c, Follow follow) {
  const Sums sums(c);
  const Expected expected = expectedOf(sums);
  Points points(run.seed, kPointsPerReplicate);
  std::uint64_t calls = 0;
  stats::RunningMoments weights;
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    const std::vector<DirectionDraw> draws = drawsOf(points, kPointsPerReplicate, first, count);
    calls += draws.size();
    const std::vector<DrawnDirection> drawn = drawPhong(run, c, draws);
    std::fill(values.begin(), values.end(), 0.0);
    bool anyBelow = false;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (drawn[i].pdf == 0.0) continue;
      const glm::dvec3 wi = glm::normalize(glm::dvec3(drawn[i].wi));
      const double weight =
          follow == Follow::kContract ? 1.0 : weightOf(sums.contract(wi), drawn[i].pdf);
      weights.add(weight);
      anyBelow = anyBelow || sums.lobes().cosTheta(wi) <= 0.0;
      sums.add(values.subspan(i / kPointsPerReplicate * kMeans, kMeans), wi,
               weight / kPointsPerReplicate);
    }
    if (!anyBelow)
      for (std::size_t at = 0; at < values.size(); at += kMeans)
        countNothingBelowAsRight(values.subspan(at, kMeans), expected);
  };
  const double rounding = lobeTolerance(c.material.exponent, 1.0);
  const std::vector<Mean> means = meansOf(expected, 0.0);
  MixtureFinding result{judgeMeans(run, means, measure, c.text(), {}, kLooks), 0.0};
  constexpr double kUsual = 2e-4, kMostRounding = 0.5;
  if (result.finding.status == Status::kFail && rounding > kUsual) {
    result.finding = judgeMeans(run, meansOf(expected, std::min(rounding, kMostRounding)), measure,
                                c.text(), {}, kLooks);
    if (result.finding.passed())
      result.finding.remark = fmt::format(
          "correct, but at the exponent {:g} the density has lost its last digits: the handout "
          "shows a form of cos^m(alpha) that keeps them",
          c.material.exponent);
  }
  if (result.finding.status == Status::kFail) {
    result.finding = judgeMeans(run, means, measure, c.text(),
                                suspicionsOf(c, sums, expected, run.seed), kLooks);
    if (const std::string mistake = numberUsedTwice(run, c); !mistake.empty())
      result.finding.cause = mistake;
  }
  result.finding.calls = calls;
  result.variance = weights.variance();
  return result;
}

}  // namespace pathmark::checks
