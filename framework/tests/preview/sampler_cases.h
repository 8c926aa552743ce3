// The samplers of the sample view with parameters from plain to extreme.
#pragma once

#include "preview/samples/sample_settings.h"

#include <string>
#include <vector>

namespace pathmark::preview::test {

struct SamplerCase {
  std::string name;
  SampleSettings settings;
};

inline std::vector<SamplerCase> samplerCases() {
  using F = CourseworkFunction;
  std::vector<SamplerCase> cases;
  const auto add = [&](const std::string& name, F function, auto&& change) {
    SampleSettings settings;
    settings.function = function;
    change(settings);
    cases.push_back({name, settings});
  };
  const auto nothing = [](SampleSettings&) {};
  add("square", F::kGetRandomNumbers, nothing);
  add("sphere", F::kSampleSphere, nothing);
  add("hemisphere", F::kSampleHemisphere, nothing);
  add("hemisphere upside down", F::kSampleHemisphere,
      [](SampleSettings& s) { s.normalTilt = 180.0; });
  add("pixel", F::kStratifiedRandomRay, nothing);
  add("pixel of one stratum", F::kStratifiedRandomRay, [](SampleSettings& s) { s.strata = 1; });
  add("pixel of 7 x 7 strata", F::kStratifiedRandomRay, [](SampleSettings& s) { s.strata = 7; });
  for (const double shape : {0.0, 0.5, 1.0}) {
    const auto shaped = [&](SampleSettings& s) { s.shape = shape; };
    const std::string text = " of shape " + std::to_string(shape).substr(0, 3);
    add("triangle" + text, F::kTriangularSampling, shaped);
    add("rectangle" + text, F::kRectangularSampling, shaped);
    add("polygon" + text, F::kPolygonSampling, shaped);
  }
  const auto light = [&](const std::string& name, double radius, double distance) {
    add(name, F::kSphereSample, [&](SampleSettings& s) {
      s.radius = radius;
      s.distance = distance;
    });
  };
  light("sphere light", 1.0, 2.5);
  light("small sphere light", 0.05, 6.0);
  light("near sphere light", 1.0, 1.05);
  light("sphere light around the receiver", 1.0, 0.4);
  light("sphere light with the receiver in the middle", 1.0, 0.0);
  add("cosine", F::kLambertianReflection, nothing);
  add("cosine on the ceiling", F::kLambertianReflection,
      [](SampleSettings& s) { s.normalTilt = 180.0; });
  const auto phong = [&](const std::string& name, double exponent, double share, double woAngle) {
    add(name, F::kPhongReflection, [&](SampleSettings& s) {
      s.exponent = exponent;
      s.diffuseShare = share;
      s.woAngle = woAngle;
    });
  };
  phong("Phong", 20.0, 0.5, 40.0);
  phong("Phong with exponent 0", 0.0, 0.4, 50.0);
  phong("Phong with a sharp lobe", 1000.5, 0.3, 30.0);
  phong("Phong without Kd", 7.5, 0.0, 60.0);
  phong("Phong without Ks", 20.0, 1.0, 60.0);
  phong("Phong from straight above", 20.0, 0.5, 0.0);
  phong("Phong grazing", 5.0, 0.5, 85.0);
  return cases;
}

}  // namespace pathmark::preview::test
