// Exponents and reflectances at their ends: the share of light that a material reflects, against a
// quadrature in long double, and furnaces, whose radiance is known.
#include "bench/stress/irradiance_oracle.h"
#include "bench/stress/stress.h"
#include "bench/stress/words.h"
#include "bench/stress/worse.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark::bench {

namespace {

using oracle::Real;

constexpr Real kPiReal = std::numbers::pi_v<Real>;

struct Phong {
  float kd, ks, exponent;
};

// The share of light from wo, at an angle with the cosine `mirrorCos`, that the specular lobe with
// Ks = 1 reflects. Over x = cos^(m+1)(alpha), of which the lobe is (m + 2) / (m + 1) times a
// uniform density, and over the azimuth in closed form: what of the circle at alpha around the
// mirror direction is above the surface, times its cosine.
Real specularAlbedo(Real exponent, Real mirrorCos) {
  constexpr int kSteps = 20000;
  const Real mirrorSin = std::sqrt(1 - mirrorCos * mirrorCos);
  Real sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    const Real logX = std::log((k + Real{0.5L}) / kSteps);
    const Real cosAlpha = std::exp(logX / (exponent + 1));
    const Real sinAlpha = std::sqrt(-std::expm1(2 * logX / (exponent + 1)));
    const Real a = cosAlpha * mirrorCos, b = sinAlpha * mirrorSin;
    if (a >= b) {
      sum += a;
    } else {
      const Real half = std::acos(-a / b);  // of the azimuths above the surface
      sum += (half * a + b * std::sin(half)) / kPiReal;
    }
  }
  return (exponent + 2) / (exponent + 1) * sum / kSteps;
}

vec3 towards(float cosine) {
  return normalize(vec3(std::sqrt((1.0f - cosine) * (1.0f + cosine)), cosine, 0.0f));
}

struct Albedo {
  double value = 0.0;
  double faults = 0.0;  // samples with values that are none
};

// The mean of f cos / pdf on a grid of s, t and u: two calls, for the directions and for the
// values.
Albedo albedoOf(StressWorker& worker, const Phong& material, const vec3& wo, int side) {
  const vec3 n(0, 1, 0);
  CallWords object, inputs;
  object.add(vec3(material.kd), vec3(material.ks), material.exponent);
  constexpr int kChoices = 8;
  for (int k = 0; k < side; ++k)
    for (int l = 0; l < side; ++l)
      for (int m = 0; m < kChoices; ++m)
        inputs.add(wo, n, (static_cast<float>(k) + 0.5f) / static_cast<float>(side),
                   (static_cast<float>(l) + 0.5f) / static_cast<float>(side),
                   (static_cast<float>(m) + 0.5f) / kChoices);
  const auto directions = worker.call(CourseworkFunction::kPhongReflection, object, inputs);
  AnswerWords reflected(directions);
  CallWords questions;
  std::vector<DirectionSample> samples;
  while (!reflected.atEnd()) {
    DirectionSample& sample = samples.emplace_back();
    sample.wi = reflected.vector();
    sample.pdf = reflected.number();
    questions.add(wo, sample.wi, n);
  }
  const auto values = worker.call(CourseworkFunction::kPhongBrdf, object, questions);
  AnswerWords value(values);
  Albedo result;
  for (const DirectionSample& sample : samples) {
    const double f = value.vector().x;
    if (sample.pdf == 0.0f) continue;
    const double weight = f * sample.wi.y / sample.pdf;
    if (std::isfinite(weight) && sample.pdf > 0.0f && f >= 0.0)
      result.value += weight;
    else
      ++result.faults;
  }
  result.value /= static_cast<double>(samples.size());
  return result;
}

void stressAlbedos(Stress& stress, StressWorker& worker) {
  stress.begin({.key = "albedos",
                .title = "Modified Phong: the share of light reflected, relative errors",
                .columns = {{"exponent", "exponent"},
                            {"specular", "Ks = 1"},
                            {"mixed", "Kd = Ks = 1/2"},
                            {"diffuse", "Kd = 1"},
                            {"black", "Kd = Ks = 0"}},
                .rows = {}});
  const int side = stress.quick ? 32 : 96;
  double worst = 0.0, faults = 0.0, light = 0.0;
  for (const float exponent : {0.0f, 0.5f, 1.0f, 10.0f, 1e2f, 1e3f, 1e4f, 1e5f, 1e6f}) {
    std::array<double, 4> errors{};
    for (const float cosine : {1.0f, 0.7f, 0.1f, 1e-2f, 1e-3f}) {
      const auto specular = static_cast<double>(specularAlbedo(exponent, cosine));
      const vec3 wo = towards(cosine);
      const std::array<std::pair<Phong, double>, 4> materials{
          {{{0.0f, 1.0f, exponent}, specular},
           {{0.5f, 0.5f, exponent}, 0.5 + 0.5 * specular},
           {{1.0f, 0.0f, exponent}, 1.0},
           {{0.0f, 0.0f, exponent}, 0.0}}};
      for (std::size_t k = 0; k < materials.size(); ++k) {
        const auto& [material, expected] = materials[k];
        const Albedo albedo = albedoOf(worker, material, wo, side);
        faults += albedo.faults;
        if (expected == 0.0)
          light += albedo.value;
        else
          errors[k] = worse(errors[k], std::abs(albedo.value / expected - 1.0));
      }
    }
    stress.row({fmt::format("{:g}", exponent), fmt::format("{:.1e}", errors[0]),
                fmt::format("{:.1e}", errors[1]), fmt::format("{:.1e}", errors[2]),
                fmt::format("{:g}", light)});
    for (const double error : {errors[0], errors[1], errors[2]}) worst = worse(worst, error);
  }
  stress.addError("albedo", "modified Phong, exponents 0 to 1e6: share of light reflected", worst,
                  stress.quick ? 3e-2 : 1e-2, 1e-3);
  stress.addFaults("blackMaterial", "light that a black material reflects", light);
  stress.addFaults("materialFaults", "samples of materials with values that are none", faults);
}

// A sphere whose inside reflects `albedo` and emits so much that the sum over all paths with at
// most `bounces` scattering events is 1 everywhere.
LoadedScene furnace(double albedo, int bounces, const std::string& material) {
  double sum = 0.0, power = 1.0;
  for (int k = 0; k <= bounces; ++k, power *= albedo) sum += power;
  return sceneOf("furnace", fmt::format(R"({{
    "camera": {{"eye": [0.1, 0.2, 0.3], "target": [0, 0, 1], "fieldOfView": 60}}, "size": [16, 16],
    "maxBounces": {0}, "materials": {{"wall": {1}}},
    "shapes": [{{"type": "sphere", "material": "wall", "centre": [0, 0, 0], "radius": 1,
                "inward": true, "emission": [{2}, {2}, {2}]}}]}})",
                                        bounces, material, 1.0 / sum));
}

void stressFurnaces(Stress& stress, StressWorker& worker) {
  stress.begin({.key = "furnaces",
                .title = "Furnaces, in which every pixel is 1",
                .columns = {{"furnace", "wall reflects"},
                            {"bounces", "bounces", 0},
                            {"mean", "mean", 6},
                            {"error", "standard error", 6},
                            {"standardErrors", "standard errors", 1}},
                .rows = {}});
  constexpr double kRounding = 1e-5, kMost = 6.0;
  double worst = 0.0;
  for (const auto& [albedo, bounces] : {std::pair{0.0, 8},
                                        {0.5, 8},
                                        {0.9, 30},
                                        {0.99, 60},
                                        {0.999, 100},
                                        {1.0, 8},
                                        {1.0, 60},
                                        {1.0, 100}}) {
    for (const bool phong : {false, true}) {
      const std::string material =
          phong ? fmt::format(R"({{"type": "phong", "Kd": [{0}, {0}, {0}], "Ks": [0, 0, 0],
                                  "exponent": 1000}})",
                              albedo)
                : fmt::format(R"({{"type": "lambertian", "Kd": [{0}, {0}, {0}]}})", albedo);
      const std::string name = fmt::format("{:g}{}", albedo, phong ? ", Phong" : "");
      stress.progress.show(fmt::format("furnace of {}", name));
      const LoadedScene scene = furnace(albedo, bounces, material);
      RenderOptions options;
      options.raysPerPixel = stress.quick ? 256 : 1024;
      options.sampler = SamplerKind::kPcg;
      worker.load(scene.flat);
      const Image image = worker.render(settingsFor(scene, options)).image;
      double sum = 0.0, squares = 0.0;
      const double pixels = static_cast<double>(image.rgb.size()) / 3.0;
      for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const auto value = static_cast<double>(image.rgb[i]);
        sum += value;
        squares += value * value;
      }
      const double mean = sum / pixels;
      const double error =
          std::sqrt(std::max(squares / pixels - mean * mean, 0.0) / (pixels - 1.0));
      const double off = std::abs(mean - 1.0), z = off / std::max(error, 1e-30);
      const bool rounded = off <= kRounding;
      stress.row({name, static_cast<double>(bounces), mean, error, rounded ? 0.0 : z});
      if (!rounded) worst = worse(worst, z);
    }
  }
  stress.addError("furnace", "furnaces: standard errors off, beyond 1e-5", worst, kMost, kMost);
}

}  // namespace

void stressMaterials(Stress& stress) {
  StressWorker worker(stress);
  stressAlbedos(stress, worker);
  stressFurnaces(stress, worker);
  stress.progress.advance(15.0);
}

}  // namespace pathmark::bench
