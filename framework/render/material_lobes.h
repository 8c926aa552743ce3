// MaterialLobes: the lobes of a material, apart.
#pragma once

#include "render/lobe_shares.h"
#include "render/path_automaton.h"

#include <pathmark/brdf.h>

#include <optional>

namespace pathmark {

class MaterialLobes {
 public:
  explicit MaterialLobes(const FlatMaterial& material) : shares_(lobeSharesOf(material)) {
    if (!shares_.hasBoth()) return;
    const Colour kd(material.kd[0], material.kd[1], material.kd[2]);
    const Colour ks(material.ks[0], material.ks[1], material.ks[2]);
    const float m = material.exponent;
    apart_.emplace(phongBRDF(kd, Colour(0.0f), m), phongBRDF(Colour(0.0f), ks, m),
                   phongBRDF(kd / shares_.diffuse, Colour(0.0f), m),
                   phongBRDF(Colour(0.0f), ks / shares_.specular, m));
  }

  const LobeShares& shares() const { return shares_; }

  // Of a material with both lobes: one of them as it is, or over its share. The latter, chosen with
  // the share as probability, is the material in the mean; its reflectance may be above 1.
  const BRDF& alone(Lobe lobe) const {
    return lobe == Lobe::kDiffuse ? apart_->diffuse : apart_->specular;
  }
  const BRDF& overShare(Lobe lobe) const {
    return lobe == Lobe::kDiffuse ? apart_->diffuseOverShare : apart_->specularOverShare;
  }

 private:
  struct Apart {
    phongBRDF diffuse, specular, diffuseOverShare, specularOverShare;

    Apart(const phongBRDF& d, const phongBRDF& s, const phongBRDF& dOverShare,
          const phongBRDF& sOverShare)
        : diffuse(d), specular(s), diffuseOverShare(dOverShare), specularOverShare(sOverShare) {}
  };

  LobeShares shares_;
  std::optional<Apart> apart_;  // if there are both
};

}  // namespace pathmark
