// LobeShares: which lobes a material has.
//
// A Lambertian surface is diffuse, whatever its reflectance; a Phong surface has the lobes whose
// reflectance is not 0, and one without any counts as diffuse.
#pragma once

#include "scene/flat_scene.h"

namespace pathmark {

struct LobeShares {
  float diffuse = 1.0f, specular = 0.0f;  // in proportion to their mean reflectances, sum 1

  bool hasBoth() const { return diffuse > 0.0f && specular > 0.0f; }
};

inline LobeShares lobeSharesOf(const FlatMaterial& material) {
  const auto sum = [](const Float3& c) { return c[0] + c[1] + c[2]; };
  const float kd = sum(material.kd), ks = sum(material.ks);
  if (material.kind == FlatMaterialKind::kLambertian || !(ks > 0.0f)) return {};
  return {kd / (kd + ks), ks / (kd + ks)};
}

}  // namespace pathmark
