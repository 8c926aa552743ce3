// What is asked of the value of the modified Phong BRDF.
#include "checks/channels.h"
#include "checks/part4_checks.h"
#include "checks/phong_quadrature.h"
#include "checks/points.h"

namespace pathmark::checks::phong {

namespace {

using F = CourseworkFunction;

constexpr double kPiD = std::numbers::pi;

struct Pair {
  Vector wo, wi, n;
};

// Directions in the lobe and beside it, from the mirror direction itself to beyond 90 degrees of
// it, and on all sides of the surface.
std::vector<Pair> pairs(std::uint64_t seed, float exponent) {
  std::vector<Pair> result{{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  Random random(seed);
  const std::vector<Vector> normals = awkwardNormals(seed);
  for (const double cosO : {0.6, 0.999, 0.05, -0.6}) {
    for (const Vector& n : normals) {
      const Vector wo = atCosine(n, cosO, random.between(0.0, 2.0 * kPiD));
      const PhongFrame frame(PhongLobes(wo, n, exponent));
      const auto inLobe = [&](double quantile) {
        const double cosine = std::pow(quantile, 1.0 / (double{exponent} + 1.0));
        return Vector(
            glm::normalize(frame.direction(std::acos(cosine), random.between(-kPiD, kPiD))));
      };
      for (const double quantile : {1.0, 0.9, 0.5, 0.1, 1e-3})
        result.push_back({wo, inLobe(quantile), n});
      for (const double cosI : {0.7, 0.2, 0.03, -0.2, -0.7})
        result.push_back({wo, atCosine(n, cosI, random.between(0.0, 2.0 * kPiD)), n});
    }
  }
  return result;
}

// So near the horizon, or the end of the lobe, that rounding decides on the side.
bool onAnEdge(const PhongLobes& lobes, const glm::dvec3& wi) {
  return std::abs(lobes.cosTheta(wi)) < 1e-6 || std::abs(lobes.cosAlpha(wi)) < 1e-4;
}

// Asked for first: what is kept from one call to the next is of this one.
const PhongMaterial kFirst{kKd, kKs, kExponents[0]};

// Every exponent, each lobe alone, and another material.
std::vector<PhongMaterial> materials() {
  std::vector<PhongMaterial> all{kFirst};
  for (const float exponent : kExponents)
    if (exponent != kFirst.exponent) all.push_back({kKd, kKs, exponent});
  all.push_back({kBlack, kKs, 3.7f});
  all.push_back({kKd, kBlack, 3.7f});
  all.push_back({kBlack, kBlack, 3.7f});
  all.push_back({kKs, kKd, 10.0f});
  return all;
}

class ValueJudge {
 public:
  void judge(const PhongMaterial& material, const Pair& p, const Colour& f) {
    const PhongLobes lobes(p.wo, p.n, material.exponent);
    const glm::dvec3 wi = glm::normalize(glm::dvec3(p.wi));
    if (onAnEdge(lobes, wi)) return;
    const double m = lobes.m, c = lobes.cosAlpha(wi), cosI = lobes.cosTheta(wi);
    const bool above = glm::dot(lobes.wo, lobes.n) > 0.0 && cosI > 0.0;
    // cos^m of another angle: of mistakes.
    const double c2 = glm::dot(wi, lobes.wo);
    const double half = glm::dot(glm::normalize(lobes.wo + wi), lobes.n);
    const double side = above ? 1.0 : 0.0;
    for (int k = 0; k < 3; ++k) {
      const double kd = double{material.kd[k]} / kPiD, ks = double{material.ks[k]} / (2.0 * kPiD);
      const double specular = ks * (m + 2.0) * lobes.power(c);
      const double expected = side * (kd + specular);
      const double allowed =
          relativeTolerance() * expected + 1e-6 + side * specular * lobeTolerance(m, c);
      const std::string what = inChannel("f", k);
      const auto where = [&] {
        return fmt::format("wo = {}, wi = {}, n = {}, {}", text(p.wo), text(p.wi), text(p.n),
                           material.text());
      };
      // The values of mistakes in a large power are as ill-conditioned as the power.
      if (m > 20.0) {
        exact_.value(what, f[k], expected, allowed, where);
        continue;
      }
      const auto with = [&](double factor, double power) {
        return above ? kd + ks * factor * power : 0.0;
      };
      const double power = lobes.power(c);
      exact_.value(what, f[k], expected, allowed, where,
                   {with(m + 1.0, power),
                    with(2.0 * kPiD, power),
                    with(m + 2.0, lobes.power(half)),
                    with(m + 2.0, lobes.power(c2)),
                    with(m + 2.0, lobes.power(-c)),
                    side * ((1.0 - double{material.ks[k]}) / kPiD + specular),
                    0.5 * expected,
                    kd + specular,
                    with(m + 2.0, std::pow(c, m)),
                    with(m + 2.0, m == 0.0 ? 1.0 : power),
                    expected * cosI,
                    side * (kd * kPiD + specular),
                    with(m + 2.0, lobes.power(lobes.cosTheta(wi))),
                    side * kd,
                    side * specular,
                    cosI > 0.0 ? kd + specular : 0.0,
                    glm::dot(lobes.wo, lobes.n) > 0.0 ? kd + specular : 0.0,
                    with(m + 2.0, c > 0.0 ? std::pow(c, std::floor(m)) : 0.0),
                    material.kd == kBlack || material.ks == kBlack ? 0.0 : expected,
                    material.kd == kBlack ? 0.0 : expected,
                    side * (double{kFirst.kd[k]} / kPiD + specular)});
    }
  }

  Finding finding(std::uint64_t calls) {
    exact_.count(calls);
    return exact_.finding();
  }

 private:
  Exact exact_{"m + 1 stands where m + 2 belongs: m + 1 is the density's",
               "the factor (m + 2) / (2 pi) is missing",
               "alpha is the angle between the half-vector and n: that is Blinn's model",
               "alpha is measured from wo instead of its mirror direction",
               "the mirror direction has the wrong sign: 2 (n . wo) n - wo points away from the "
               "surface",
               "Kd is replaced by 1 - Ks",
               "the lobes are added with half their weight each",
               "no test of the sides: f is not 0 below the surface",
               "the cosine is not clamped at 0: beyond 90 degrees pow gets a negative number",
               "exponent 0: beyond 90 degrees the lobe is 0, though 0 to the power 0 is 1",
               "the cosine is part of the BRDF: it belongs to the caller",
               "the factor 1/pi of the diffuse term is missing",
               "alpha is measured from n instead of the mirror direction of wo",
               "the specular term is missing",
               "the diffuse term is missing",
               "only the side of wi is tested",
               "only the side of wo is tested",
               "the exponent is rounded down to an integer",
               "f is 0 as soon as one of Kd and Ks is: the other lobe still reflects",
               "f is 0 as soon as Kd is: the specular lobe still reflects",
               "Kd/pi is kept from the first call: each material has its own Kd"};
};

}  // namespace

Finding valueIsTheFormula(CheckRun& run) {
  ValueJudge judge;
  std::uint64_t calls = 0;
  for (const PhongMaterial& material : materials()) {
    const std::vector<Pair> inputs = pairs(run.seed, material.exponent);
    Calls values(F::kPhongBrdf, material.words());
    for (const Pair& p : inputs) values.add(p.wo, p.wi, p.n);
    const Results results = values.run(run.worker);
    calls += inputs.size();
    for (std::size_t i = 0; i < inputs.size(); ++i)
      judge.judge(material, inputs[i], results.vector(i, 0));
  }
  return judge.finding(calls);
}

}  // namespace pathmark::checks::phong
