// What the sample view is asked to show.
//
//   SampleSettings      a function, its points, its parameters
//   SampledFunction     the functions that can be chosen, by part
#pragma once

#include "sampling/sampler_kind.h"
#include "worker/contract.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace pathmark::preview {

struct SampledFunction {
  CourseworkFunction function;
  std::string_view domain;  // what is sampled
};

inline constexpr std::array kSampledFunctions{
    SampledFunction{CourseworkFunction::kGetRandomNumbers, "unit square"},
    SampledFunction{CourseworkFunction::kSampleSphere, "sphere"},
    SampledFunction{CourseworkFunction::kSampleHemisphere, "hemisphere"},
    SampledFunction{CourseworkFunction::kStratifiedRandomRay, "pixel"},
    SampledFunction{CourseworkFunction::kTriangularSampling, "triangle"},
    SampledFunction{CourseworkFunction::kRectangularSampling, "rectangle"},
    SampledFunction{CourseworkFunction::kPolygonSampling, "polygon"},
    SampledFunction{CourseworkFunction::kSphereSample, "sphere light"},
    SampledFunction{CourseworkFunction::kLambertianReflection, "cosine lobe"},
    SampledFunction{CourseworkFunction::kPhongReflection, "diffuse and specular lobe"},
};

inline constexpr std::uint32_t kFewestSamples = 64, kMostSamples = 4096;
inline constexpr int kMostStrata = 16;

// Angles in degrees. Each function has its own of these; the others change nothing.
struct SampleSettings {
  CourseworkFunction function = CourseworkFunction::kSampleSphere;
  SamplerKind points = SamplerKind::kPcg;
  std::uint32_t count = 512;
  std::uint32_t seed = 0;

  double normalTilt = 30.0;  // of the normal, from the vertical axis
  double normalTurn = 40.0;  // around it
  double woAngle = 40.0;     // between wo and the normal
  double exponent = 20.0;
  double diffuseShare = 0.5;  // of Kd in Kd + Ks

  double radius = 1.0;                      // of the sphere light
  double distance = 2.5;                    // of its centre from the receiver
  double elevation = 35.0, azimuth = 30.0;  // where the receiver sees it

  int strata = 4;      // of a pixel: n by n
  double shape = 0.5;  // of a polygon, in [0,1]: how far it is pulled out of shape

  bool operator==(const SampleSettings&) const = default;
};

}  // namespace pathmark::preview
