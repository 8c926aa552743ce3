// Phong's pdf and the density that reflection returns are one and the same. Where they are not,
// which of them is wrong?
#include "checks/part4_checks.h"
#include "checks/phong_mixture.h"
#include "checks/points.h"

#include <optional>

namespace pathmark::checks::phong {

namespace {

using F = CourseworkFunction;

constexpr double kNothing = 1e-6;

// A direction that reflection drew, and the densities that describe it.
struct Drawn {
  Vector wi, wo, n;
  double returned = 0.0, own = 0.0;      // by reflection, by pdf
  double diffuse = 0.0, specular = 0.0;  // of the lobes
  double allowed = 0.0;                  // difference that rounding explains

  bool agrees() const { return std::abs(returned - own) <= allowed; }
};
using Density = double Drawn::*;

// Those of one material.
struct Sample {
  PhongMaterial material;
  std::vector<Drawn> drawn;

  bool agrees() const {
    return std::all_of(drawn.begin(), drawn.end(), [](const Drawn& d) { return d.agrees(); });
  }

  // Whether the densities are those of a mixture of both lobes.
  bool isMixture(Density density, double diffuseShare) const {
    return std::all_of(drawn.begin(), drawn.end(), [&](const Drawn& d) {
      const double mixture = diffuseShare * d.diffuse + (1.0 - diffuseShare) * d.specular;
      return std::abs(d.*density - mixture) <= d.allowed;
    });
  }
  bool isContract(Density density) const { return isMixture(density, material.diffuseShare()); }

  // The probability of the diffuse lobe, if it is a mixture: from the direction in which the lobes
  // differ most.
  std::optional<double> shareOf(Density density) const {
    const auto contrast = [](const Drawn& d) {
      return std::abs(d.diffuse - d.specular) / (d.allowed + kNothing);
    };
    const auto clearest =
        std::max_element(drawn.begin(), drawn.end(),
                         [&](const Drawn& a, const Drawn& b) { return contrast(a) < contrast(b); });
    if (clearest == drawn.end() || contrast(*clearest) < 1.0) return std::nullopt;
    const Drawn& d = *clearest;
    const double share = (d.*density - d.specular) / (d.diffuse - d.specular);
    if (share < 0.0 || share > 1.0 || !isMixture(density, share)) return std::nullopt;
    return share;
  }
};

// Not where rounding decides whether a lobe reaches a direction.
Sample draw(CheckRun& run, const PhongMaterial& material) {
  Sample sample{material, {}};
  Random random(run.seed);
  std::vector<Drawn> all;
  Calls reflection(F::kPhongReflection, material.words());
  for (const Vector& n : awkwardNormals(run.seed)) {
    for (int k = 0; k < 24; ++k) {
      const Vector wo = atCosine(n, random.between(0.05, 1.0), random.between(0.0, 6.0));
      reflection.add(wo, n, random.uniform(), random.uniform(), random.uniform());
      all.push_back({.wi = {}, .wo = wo, .n = n});
    }
  }
  const Results drawn = reflection.run(run.worker);
  Calls pdf(F::kPhongPdf, material.words());
  for (std::size_t i = 0; i < all.size(); ++i) pdf.add(all[i].wo, drawn.vector(i, 0), all[i].n);
  const Results own = pdf.run(run.worker);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Drawn d = all[i];
    d.wi = drawn.vector(i, 0);
    d.returned = drawn.number(i, 3);
    d.own = own.number(i, 0);
    const PhongLobes lobes(d.wo, d.n, material.exponent);
    const glm::dvec3 wi = glm::normalize(glm::dvec3(d.wi));
    const double height = lobes.cosTheta(wi), c = lobes.cosAlpha(wi);
    if (std::abs(height) < 1e-5 || std::abs(c) < 1e-4) continue;
    d.diffuse = lobes.diffuse(wi);
    d.specular = lobes.specular(wi);
    d.allowed = relativeTolerance(1.0 / std::max(std::abs(height), 1e-3)) * d.own +
                lobeTolerance(material.exponent, c) * d.specular + kNothing;
    sample.drawn.push_back(d);
  }
  return sample;
}

// Unequal lobes first: there it makes most of a difference with which probability each is drawn.
std::vector<Sample> drawAll(CheckRun& run) {
  const Colour little(0.04f, 0.05f, 0.06f);
  std::vector<Sample> samples{draw(run, {kKs, little, 10.0f})};
  for (const float exponent : kExponents) samples.push_back(draw(run, {kKd, kKs, exponent}));
  samples.push_back(draw(run, {kBlack, kKs, 3.7f}));
  samples.push_back(draw(run, {kKd, kBlack, 3.7f}));
  return samples;
}

std::uint64_t callsOf(const std::vector<Sample>& samples) {
  std::uint64_t calls = 0;
  for (const Sample& s : samples) calls += 2 * s.drawn.size();
  return calls;
}

// Of two densities that differ, the one that is the contract's is right, or else the one that is
// of a mixture at all.
bool pdfIsWrong(const Sample& sample) {
  if (sample.isContract(&Drawn::returned)) return true;
  if (sample.isContract(&Drawn::own)) return false;
  return sample.shareOf(&Drawn::returned) || !sample.shareOf(&Drawn::own);
}

Finding disagreement(const Sample& sample, std::string_view what, Density expected, Density got) {
  Exact exact;
  for (const Drawn& d : sample.drawn)
    exact.value(what, d.*got, d.*expected, d.allowed, [&] {
      return fmt::format("wo = {}, wi = {}, n = {}, {}", text(d.wo), text(d.wi), text(d.n),
                         sample.material.text());
    });
  return exact.finding();
}

// What the returned densities would be if each of them were of the lobe alone that was chosen.
bool isOfOneLobe(const Sample& sample, double diffuseFactor, double specularFactor) {
  return std::all_of(sample.drawn.begin(), sample.drawn.end(), [&](const Drawn& d) {
    const double slack = d.allowed + lobeTolerance(sample.material.exponent, 1.0) * d.specular;
    return std::abs(d.returned - diffuseFactor * d.diffuse) <= slack ||
           std::abs(d.returned - specularFactor * d.specular) <= slack;
  });
}

}  // namespace

// Directions that are drawn by the contract's probabilities, and a density, the same from both
// functions, that is of a mixture with others: then it is pdf that is wrong.
Finding densityIsThatOfReflection(CheckRun& run) {
  const std::vector<Sample> samples = drawAll(run);
  Finding pass;
  pass.calls = callsOf(samples);
  for (const Sample& sample : samples) {
    if (sample.agrees()) continue;
    if (!pdfIsWrong(sample)) return pass;
    Finding finding = disagreement(sample, "pdf(wo, wi, n) for the wi that reflection returned",
                                   &Drawn::returned, &Drawn::own);
    finding.calls = pass.calls;
    return finding;
  }
  for (const Sample& sample : samples) {
    const std::optional<double> share = sample.shareOf(&Drawn::own);
    if (!share || sample.isContract(&Drawn::own)) continue;
    const Vector n(0, 1, 0);
    const MixtureCase mixture{sample.material, n, atCosine(n, 0.6, 1.0)};
    MixtureFinding claimed = judgeMixture(run, mixture);
    if (claimed.finding.status != Status::kFail) continue;
    if (!judgeMixture(run, mixture, Follow::kContract).finding.passed()) return pass;
    claimed.finding.cause = fmt::format(
        "reflection draws the diffuse lobe with probability {:.3g}, and pdf is the density of a "
        "mixture that would draw it with probability {:.3g}",
        sample.material.diffuseShare(), *share);
    return claimed.finding;
  }
  return pass;
}

Finding densityIsOfTheMixture(CheckRun& run) {
  const std::vector<Sample> samples = drawAll(run);
  Finding finding;
  for (const Sample& sample : samples) {
    if (sample.agrees()) continue;
    finding = disagreement(sample, "density of wi", &Drawn::own, &Drawn::returned);
    const double share = sample.material.diffuseShare();
    if (isOfOneLobe(sample, share, 1.0 - share))
      finding.cause =
          "the returned density is that of the chosen lobe alone, times its probability: wi could "
          "have come from the other lobe too";
    else if (isOfOneLobe(sample, 1.0, 1.0))
      finding.cause =
          "the returned density is that of the chosen lobe alone, without its probability: wi "
          "could have come from the other lobe too";
    break;
  }
  finding.calls = callsOf(samples);
  return finding;
}

}  // namespace pathmark::checks::phong
