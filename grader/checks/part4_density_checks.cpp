// What is asked of the density of the modified Phong BRDF's directions.
#include "checks/part4_checks.h"
#include "checks/phong_mixture.h"
#include "checks/phong_quadrature.h"
#include "checks/points.h"

namespace pathmark::checks::phong {

namespace {

using F = CourseworkFunction;

constexpr double kPiD = std::numbers::pi;

// A lobe is left out of a sum where its density is smaller than this.
constexpr double kNothing = 1e-6;

}  // namespace

std::string causeOfNoNumber(const PhongLobes& lobes, const Vector& wi) {
  // A roundoff of the vectors moves the cosine by about 1e-7.
  constexpr double kNear = 1e-5;
  if (!std::isfinite(wi.x + wi.y + wi.z)) return {};
  const double cosAlpha = lobes.cosAlpha(glm::normalize(glm::dvec3(wi)));
  if (cosAlpha < -kNear)
    return "NaN: a logarithm or power of a negative number; beyond 90 degrees of the mirror "
           "direction the lobe is 0";
  if (cosAlpha < kNear)
    return "NaN: a logarithm or power of a negative number; near 90 degrees of the mirror "
           "direction rounding makes the cosine negative or 0";
  return {};
}

namespace {

class DensityJudge {
 public:
  explicit DensityJudge(CheckRun& run) : run_(run) {}

  // Whether it is worth going on.
  bool judge(const PhongMaterial& material, const Vector& n, const Vector& wo) {
    const PhongLobes lobes(wo, n, material.exponent);
    const std::vector<PhongNode> nodes = phongNodes(lobes);
    const std::vector<double> pdf = densities(material, n, wo, nodes);
    const auto where = [&] { return MixtureCase{material, n, wo}.text(); };
    if (pdf.empty()) return false;
    double integral = 0.0, diffuse = 0.0, specular = 0.0, specularBelow = 0.0, even = 0.0,
           rounded = 0.0;  // cos^m of the exponent rounded down
    bool emptyBelow = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double s = lobes.specular(nodes[i].wi), weight = nodes[i].weight;
      integral += weight * pdf[i];
      diffuse += weight * lobes.diffuse(nodes[i].wi);
      specular += weight * s;
      const double c = lobes.cosAlpha(nodes[i].wi), m = lobes.m;
      rounded += weight * (m + 1.0) / (2.0 * kPiD) * (c > 0.0 ? std::pow(c, std::floor(m)) : 0.0);
      even += weight * std::max(glm::dot(lobes.wo, lobes.n), 0.0) / kPiD;
      if (nodes[i].above) continue;
      specularBelow += weight * s;
      if (s > kNothing && pdf[i] != 0.0) emptyBelow = false;
    }
    const double share = material.diffuseShare(), m = material.exponent;
    const double rounding = lobeTolerance(m, 1.0);
    constexpr double kOfTheSum = 1e-3;
    const double allowed = kOfTheSum + (1.0 - share) * rounding;
    if (emptyBelow && specularBelow > 1e-5) {
      // Directions below the surface carry no light; a density of 0 says "no sample".
      exact_.holds(
          integral < 1.0 + allowed && integral > 1.0 - specularBelow - allowed,
          fmt::format("the integral of pdf over all directions between {:.6g} and 1, since pdf is "
                      "0 below the surface",
                      1.0 - specularBelow),
          [&] { return fmt::format("{:.6g}", integral); }, where);
      return true;
    }
    exact_.value("integral of pdf over all directions", integral, 1.0, allowed, where,
                 {share * diffuse + (1.0 - share) * specular * (m + 2.0) / (m + 1.0), 2.0, 0.5,
                  share * kPiD + (1.0 - share) * specular, share * even + (1.0 - share) * specular,
                  share * diffuse + (1.0 - share) * specular * m / (m + 1.0),
                  share * diffuse + (1.0 - share) * specular * 2.0 * kPiD / (m + 1.0),
                  share * diffuse + (1.0 - share) * rounded});
    return true;
  }

  void judgeBlack(const Vector& n, const Vector& wo) {
    const PhongMaterial black{kBlack, kBlack, 3.7f};
    Calls calls(F::kPhongPdf, black.words());
    calls.add(wo, n, n);
    const double pdf = calls.run(run_.worker).number(0, 0);
    exact_.count(1);
    exact_.holds(
        pdf == 0.0, "pdf = 0, since nothing is reflected",
        [&] { return fmt::format("pdf = {:.6g}", pdf); },
        [&] { return fmt::format("Kd = Ks = 0, wo = {}, wi = n = {}", text(wo), text(n)); });
  }

  Finding finding() const {
    Finding result = exact_.finding();
    if (!cause_.empty()) result.cause = cause_;
    return result;
  }

 private:
  // Asked for twice, the second time in the opposite order. Empty after a value that is none.
  std::vector<double> densities(const PhongMaterial& material, const Vector& n, const Vector& wo,
                                const std::vector<PhongNode>& nodes) {
    constexpr std::size_t kRepeated = 64;
    Calls calls(F::kPhongPdf, material.words());
    for (const PhongNode& node : nodes) calls.add(wo, Vector(node.wi), n);
    for (std::size_t k = 0; k < kRepeated; ++k)
      calls.add(wo, Vector(nodes[kRepeated - 1 - k].wi), n);
    const Results results = calls.run(run_.worker);
    exact_.count(results.count());
    std::vector<double> pdf;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double x = results.number(i, 0);
      const auto got = [&] { return fmt::format("pdf = {:.6g}", x); };
      const auto where = [&] {
        return fmt::format("wo = {}, wi = {}, n = {}, {}", text(wo), text(Vector(nodes[i].wi)),
                           text(n), material.text());
      };
      if (!exact_.holds(std::isfinite(x) && x >= 0.0, "a density, at least 0", got, where)) {
        if (std::isnan(x))
          cause_ = causeOfNoNumber(PhongLobes(wo, n, material.exponent), Vector(nodes[i].wi));
        return {};
      }
      if (i < kRepeated &&
          !exact_.holds(results.same(i, nodes.size() + kRepeated - 1 - i),
                        "the same density again for the same directions", got, where))
        return {};
      pdf.push_back(x);
    }
    return pdf;
  }

  CheckRun& run_;
  std::string cause_;  // of a density that is none
  Exact exact_{"m + 2 stands where m + 1 belongs: m + 2 is the BRDF's",
               "the densities of the lobes are added without their probabilities",
               "everything is halved: the probabilities of the lobes add up to 1 already",
               "the diffuse density lacks its factor 1/pi",
               "the diffuse density has the cosine of wo instead of wi's",
               "m stands where m + 1 belongs",
               "the factor (m + 1) / (2 pi) of the specular density is missing",
               "the exponent is rounded down to an integer"};
};

}  // namespace

Finding densityIsADensity(CheckRun& run) {
  const std::vector<PhongMaterial> lobes{
      {kKd, kKs, 0.0f}, {kBlack, kKs, 0.0f}, {kKd, kBlack, 0.0f}};
  const std::vector<Vector> normals = awkwardNormals(run.seed);
  Random random(run.seed);
  DensityJudge judge(run);
  std::size_t turn = 0;
  for (PhongMaterial material : lobes) {
    for (const float exponent : kExponents) {
      material.exponent = exponent;
      for (const double cosine : {1.0, 0.6, 0.1}) {
        const Vector n = normals[turn++ % normals.size()];
        const Vector wo = cosine == 1.0 ? n : atCosine(n, cosine, random.between(0.0, 6.0));
        if (!judge.judge(material, n, wo)) return judge.finding();
      }
      if (material.ks == kBlack) break;
    }
  }
  judge.judgeBlack(Vector(0, 1, 0), Vector(0, 1, 0));
  return judge.finding();
}

}  // namespace pathmark::checks::phong
