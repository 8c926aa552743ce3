// The modified Phong BRDF. Which probability a lobe is drawn with is left open: where both lobes
// are there, a density is described by how it goes with the direction, and samples are weighted.
#include "checks/channels.h"
#include "checks/phong_oracle.h"
#include "checks/points.h"
#include "diagnosis/direction_probe.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

struct Case {
  const char* name;
  PhongMaterial material;
  bool both;  // lobes
};

const Colour kBlack(0.0f), kKd(0.25f, 0.4f, 0.125f), kKs(0.5f, 0.3f, 0.25f);

std::vector<Case> cases() {
  return {{"Ks = 0", {kKd, kBlack, 10.0f}, false},
          {"Kd = 0, exponent 10", {kBlack, kKs, 10.0f}, false},
          {"Kd = 0, exponent 3.7", {kBlack, kKs, 3.7f}, false},
          {"Kd = 0, exponent 1", {kBlack, kKs, 1.0f}, false},
          {"Kd = 0, exponent 0", {kBlack, kKs, 0.0f}, false},
          {"no red", {{0.0f, 0.4f, 0.1f}, {0.0f, 0.0f, 0.5f}, 10.0f}, true},
          {"red in both lobes, green and blue in one each",
           {{0.3f, 0.4f, 0.0f}, {0.5f, 0.0f, 0.5f}, 10.0f},
           true},
          {"both lobes, exponent 10", {kKd, kKs, 10.0f}, true},
          {"both lobes, exponent 2.5", {kKs, kKd, 2.5f}, true},
          {"Kd = Ks = 0", {kBlack, kBlack, 10.0f}, false}};
}

struct Directions {
  Vector wo, n;
  std::vector<Vector> wi;
  std::vector<std::string> words;
};

std::vector<Directions> directions() {
  Random random(41);
  std::vector<Directions> all;
  for (const auto& [n, cosO] :
       {std::pair{Vector(0, 1, 0), 0.8}, {random.direction(), 0.35}, {Vector(0, 0, -1), -0.5}}) {
    const Vector wo = atCosine(n, cosO, random.between(0.0, 6.0));
    const Vector mirror = 2.0f * dot(wo, n) * n - wo;
    Directions d{wo, n, {}, {}};
    for (const double cosA : {1.0, 0.9, 0.6, 0.2, -0.5})
      d.wi.push_back(atCosine(mirror, cosA, random.between(0.0, 6.0)));
    d.wi.push_back(n);
    d.wi.push_back(atCosine(n, -0.4, 2.0));
    for (const Vector& wi : d.wi)
      d.words.push_back(fmt::format(" where wo . n = {:.2g}, wi . n = {:.2g}, cos(alpha) = {:.2g}",
                                    dot(wo, n), dot(wi, n), dot(wi, mirror)));
    all.push_back(d);
  }
  return all;
}

Results ask(const ProbeRun& run, const PhongMaterial& material, const Directions& d) {
  Calls calls(run.function, material.words());
  for (const Vector& wi : d.wi) calls.add(d.wo, wi, d.n);
  return calls.run(run.worker);
}

Signature values(const ProbeRun& run) {
  Signature signature;
  for (const Case& c : cases())
    for (const Directions& d : directions()) {
      const Results results = ask(run, c.material, d);
      for (std::size_t i = 0; i < d.wi.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
          signature.add(fmt::format("{}{}, {}", inChannel("f", channel), d.words[i], c.name),
                        results.number(i, static_cast<std::size_t>(channel)));
    }
  return signature;
}

// The share of the diffuse lobe that explains the densities best, and what it leaves unexplained.
void describeMixture(const Results& results, const Case& c, const Directions& d,
                     Signature& signature) {
  const PhongLobes lobes(d.wo, d.n, c.material.exponent);
  double above = 0.0, below = 0.0;
  std::vector<double> rest;
  for (std::size_t i = 0; i < d.wi.size(); ++i) {
    const glm::dvec3 wi(d.wi[i]);
    const double difference = lobes.diffuse(wi) - lobes.specular(wi);
    above += (double{results.number(i, 0)} - lobes.specular(wi)) * difference;
    below += difference * difference;
  }
  const double share = above / below;
  for (std::size_t i = 0; i < d.wi.size(); ++i)
    signature.add(
        fmt::format("pdf, less that of the lobes that fit best,{}, {}", d.words[i], c.name),
        results.number(i, 0) - lobes.mixture(share, glm::dvec3(d.wi[i])));
}

Signature densities(const ProbeRun& run) {
  Signature signature;
  for (const Case& c : cases())
    for (const Directions& d : directions()) {
      const Results results = ask(run, c.material, d);
      if (c.both) {
        describeMixture(results, c, d, signature);
        continue;
      }
      for (std::size_t i = 0; i < d.wi.size(); ++i)
        signature.add(fmt::format("pdf{}, {}", d.words[i], c.name), results.number(i, 0));
    }
  return signature;
}

Signature samples(const ProbeRun& run) {
  Random random(43);
  Signature signature;
  const Vector n = random.direction();
  for (const double cosO : {0.8, 0.3})
    for (const Case& c : cases()) {
      if (cosO < 0.5 && c.material.exponent != 10.0f) continue;
      const Vector wo = atCosine(n, cosO, 2.0);
      const PhongLobes lobes(wo, n, c.material.exponent);
      const bool black = c.material.kd + c.material.ks == kBlack;
      const double share = black ? 0.5 : c.material.diffuseShare();
      probeDirections(run,
                      {.pdf = F::kPhongPdf,
                       .object = c.material.words(),
                       .wo = wo,
                       .n = n,
                       .axis = c.material.kd == kBlack ? Vector(lobes.mirror) : n,
                       .where = fmt::format(", wo . n = {}, {}", cosO, c.name),
                       .named =
                           [lobes, share, black](const Vector& wi) {
                             return black ? 0.0 : lobes.mixture(share, glm::dvec3(wi));
                           },
                       .weighted = c.both},
                      signature);
    }
  return signature;
}

}  // namespace

Signature probePart4(const ProbeRun& run) {
  switch (run.function) {
    case F::kPhongBrdf:
      return values(run);
    case F::kPhongPdf:
      return densities(run);
    default:
      return samples(run);
  }
}

}  // namespace pathmark::diagnosis
