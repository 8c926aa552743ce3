// What is asked of directions drawn from the modified Phong BRDF.
#include "checks/part4_checks.h"
#include "checks/phong_mixture.h"
#include "checks/points.h"
#include "checks/results.h"

namespace pathmark::checks::phong {

namespace {

using F = CourseworkFunction;

struct Input {
  Vector wo, n;
  float s, t, u;

  std::string text(const PhongMaterial& material) const {
    return fmt::format("wo = {}, n = {}, s = {:.8g}, t = {:.8g}, u = {:.8g}, {}", checks::text(wo),
                       checks::text(n), s, t, u, material.text());
  }
};

std::vector<Input> edgeInputs(std::uint64_t seed) {
  std::vector<Input> inputs;
  Random random(seed);
  for (const Vector& n : awkwardNormals(seed)) {
    for (const double cosine : {0.6, 1.0, 0.01, 1e-6}) {
      const Vector wo = cosine == 1.0 ? n : atCosine(n, cosine, 1.0);
      inputs.push_back({wo, n, random.uniform(), random.uniform(), random.uniform()});
      for (const float s : kEdgeNumbers)
        for (const float t : kEdgeNumbers)
          for (const float u : {kEdgeNumbers.front(), kEdgeNumbers.back()})
            inputs.push_back({wo, n, s, t, u});
    }
  }
  return inputs;
}

// Whether it is worth going on. `cause`: of what is no number.
bool judgeEdges(CheckRun& run, const PhongMaterial& material, const std::vector<Input>& inputs,
                Exact& exact, std::string& cause) {
  Calls calls(F::kPhongReflection, material.words());
  for (const Input& in : inputs) calls.add(in.wo, in.n, in.s, in.t, in.u);
  for (auto in = inputs.rbegin(); in != inputs.rend(); ++in)
    calls.add(in->wo, in->n, in->s, in->t, in->u);
  const Results results = calls.run(run.worker);
  exact.count(results.count());
  const bool black = material.kd == kBlack && material.ks == kBlack;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto where = [&] { return inputs[i].text(material); };
    const Vector wi = results.vector(i, 0);
    const double pdf = results.number(i, 3);
    const auto got = [&] { return fmt::format("wi = {}, pdf = {:.6g}", text(wi), pdf); };
    if (!exact.holds(results.finite(i) && pdf >= 0.0, "finite numbers, a density of at least 0",
                     got, where)) {
      if (std::isnan(pdf))
        cause = causeOfNoNumber(PhongLobes(inputs[i].wo, inputs[i].n, material.exponent), wi);
      return false;
    }
    const std::size_t again = results.count() - 1 - i;
    if (!exact.holds(
            results.same(i, again),
            "the same direction again for the same s, t, u, without random numbers of its own",
            [&] {
              return fmt::format("wi = {} and then {}", text(wi), text(results.vector(again, 0)));
            },
            where))
      return false;
    if (black && !exact.holds(pdf == 0.0, "pdf = 0, since nothing is reflected", got, where))
      return false;
    // The mirror direction of rounded vectors is not quite a unit vector, nor a frame around it.
    constexpr double kRoundings = 16.0 * 0x1p-24;
    if (pdf != 0.0)
      exact.value("length of wi", glm::length(glm::dvec3(wi)), 1.0, kRoundings, where);
  }
  return true;
}

// How many of these directions are of either lobe alone, for an exponent so large that the other
// hardly ever draws such a direction.
struct LobeCounts {
  int diffuse = 0, specular = 0;
};

constexpr float kSharp = 1e5f;

LobeCounts countLobes(CheckRun& run, const PhongMaterial& material) {
  constexpr double kCosOfLobe = 1.0 - 2e-4;  // cos^kSharp is 2e-9 there
  const Vector n(0, 1, 0), wo = atCosine(n, 0.7, 1.0);
  const PhongLobes lobes(wo, n, material.exponent);
  Random random(run.seed);
  std::vector<DirectionDraw> points;
  constexpr int kPoints = 1024;
  for (int k = 0; k < kPoints; ++k)
    points.push_back({{random.uniform(), random.uniform()},
                      (static_cast<float>(k) + random.uniform()) / kPoints});
  LobeCounts counts;
  for (const DrawnDirection& d : drawPhong(run, {material, n, wo}, points)) {
    if (d.pdf <= 0.0) continue;
    ++(lobes.cosAlpha(glm::dvec3(d.wi)) > kCosOfLobe ? counts.specular : counts.diffuse);
  }
  return counts;
}

struct Configuration {
  PhongMaterial material;
  double cosine;
};

// From the plain to the extreme: chosen so that each lobe alone, their mixture, and the part of the
// specular lobe below the surface are seen for every exponent.
std::vector<Configuration> configurations() {
  const Colour little(0.02f, 0.08f, 0.05f);
  std::vector<Configuration> result{{{kKd, kKs, 1.0f}, 1.0},
                                    {{kBlack, kKs, 0.5f}, 1.0},
                                    {{kKd, kBlack, 10.0f}, 0.6},
                                    {{kKd, kKs, 10.0f}, 1.0}};
  for (const float exponent : kExponents) {
    result.push_back({{kKd, kKs, exponent}, 0.6});
    result.push_back({{kBlack, kKs, exponent}, 0.4});
    result.push_back({{kKd, kKs, exponent}, 0.1});
  }
  for (const float exponent : {3.7f, 100.0f}) {
    result.push_back({{little, kKs, exponent}, 0.8});
    result.push_back({{kKs, little, exponent}, 0.8});
  }
  return result;
}

}  // namespace

Finding directionsAreValid(CheckRun& run) {
  const std::vector<Input> inputs = edgeInputs(run.seed);
  std::vector<PhongMaterial> materials;
  for (const float exponent : kExponents) materials.push_back({kKd, kKs, exponent});
  for (const auto& [kd, ks] : {std::pair{kBlack, kKs}, {kKd, kBlack}, {kBlack, kBlack}})
    materials.push_back({kd, ks, 3.7f});
  Exact exact;
  std::string cause;
  for (const PhongMaterial& material : materials)
    if (!judgeEdges(run, material, inputs, exact, cause)) break;
  Finding finding = exact.finding();
  if (!cause.empty()) finding.cause = cause;
  return finding;
}

// Kd has a colour in one channel only, Ks in the other two.
Finding bothLobesAreDrawn(CheckRun& run) {
  constexpr int kOfTheOtherLobe = 5;  // more than that the diffuse lobe has in the specular one
  Exact exact;
  int withoutDiffuse = 0, withoutSpecular = 0;
  for (int channel = 0; channel < 3; ++channel) {
    PhongMaterial material{kBlack, Colour(0.3f), kSharp};
    material.kd[channel] = 0.5f;
    material.ks[channel] = 0.0f;
    const LobeCounts counts = countLobes(run, material);
    exact.count(1024);
    const auto where = [&] { return material.text() + ", cos(theta) of wo = 0.7"; };
    if (!exact.holds(
            counts.specular > kOfTheOtherLobe, "directions of the specular lobe, among 1024",
            [&] { return fmt::format("{} near the mirror direction", counts.specular); }, where))
      ++withoutSpecular;
    if (!exact.holds(
            counts.diffuse > 0, "directions of the diffuse lobe, among 1024",
            [] { return "none but near the mirror direction"; }, where))
      ++withoutDiffuse;
  }
  Finding finding = exact.finding();
  if (withoutSpecular == 1 && withoutDiffuse == 2)
    finding.cause =
        "the lobe is chosen by one channel alone, which may be 0 where the others are not: choose "
        "it by the means over the channels";
  return finding;
}

Finding samplesFollowTheirDensity(CheckRun& run) {
  const std::vector<Vector> normals = awkwardNormals(run.seed);
  Random random(run.seed);
  Finding worst;
  std::uint64_t calls = 0;
  double variance = 0.0;
  std::string noisiest, remark;
  std::uint64_t k = 0;
  for (const Configuration& configuration : configurations()) {
    const Vector n = normals[k % normals.size()];
    const double azimuth = random.between(0.0, 6.0);
    const MixtureCase mixture{
        configuration.material, n,
        configuration.cosine == 1.0 ? n : atCosine(n, configuration.cosine, azimuth)};
    CheckRun own{run.worker, run.seed + k, run.budget};
    MixtureFinding judged = judgeMixture(own, mixture);
    calls += judged.finding.calls;
    if (judged.variance > variance) {
      variance = judged.variance;
      noisiest = configuration.material.text();
    }
    if (remark.empty()) remark = judged.finding.remark;
    if (k++ == 0 || severity(judged.finding.status) > severity(worst.status))
      worst = judged.finding;
    if (worst.status == Status::kFail) break;
  }
  constexpr double kNoisy = 0.1;
  if (worst.passed() && variance > kNoisy && remark.empty())
    remark = fmt::format(
        "correct, but noisier than lobes drawn in proportion to the means of Kd and Ks: the "
        "variance of the weights is {:.2g} instead of 0 for {}",
        variance, noisiest);
  if (worst.passed()) worst.remark = remark;
  worst.calls = calls;
  return worst;
}

}  // namespace pathmark::checks::phong
