#include "preview/samples/sample_controls.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <bit>

namespace pathmark::preview {

namespace {

using F = CourseworkFunction;

constexpr std::array kPointKinds{SamplerKind::kPcg, SamplerKind::kStratified, SamplerKind::kSobol};

const char* nameOfPoints(SamplerKind kind) {
  switch (kind) {
    case SamplerKind::kPcg:
      return "plain random";
    case SamplerKind::kStratified:
      return "stratified (jittered grid)";
    default:
      return "Owen-scrambled Sobol";
  }
}

std::string labelOf(const SampledFunction& f) {
  const FunctionContract& c = contractOf(f.function);
  return fmt::format("{}  {} ({})", c.section, c.name, f.domain);
}

void offer(SampleSettings& settings, const SampledFunction& f) {
  if (ImGui::Selectable(labelOf(f).c_str(), settings.function == f.function))
    settings.function = f.function;
}

// Puts widgets beside each other, two a row where there is room.
class Rows {
 public:
  explicit Rows(float scale) {
    const float all = ImGui::GetContentRegionAvail().x;
    columns_ = all < 280.0f * scale ? 1 : 2;
    width_ = (all - ImGui::GetStyle().ItemSpacing.x * static_cast<float>(columns_ - 1)) /
             static_cast<float>(columns_);
  }
  void next() {
    if (count_++ % columns_ != 0) ImGui::SameLine();
    ImGui::SetNextItemWidth(width_);
  }

 private:
  int columns_, count_ = 0;
  float width_;
};

class Sliders {
 public:
  explicit Sliders(float scale) : rows_(scale) {}

  // What the slider is for stands in it, as part of the format.
  void slider(const char* format, double& value, double low, double high,
              bool logarithmic = false) {
    rows_.next();
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    ImGui::SliderScalar(fmt::format("##{}", format).c_str(), ImGuiDataType_Double, &value, &low,
                        &high, format, flags);
  }
  void slider(const char* format, int& value, int low, int high) {
    rows_.next();
    ImGui::SliderInt(fmt::format("##{}", format).c_str(), &value, low, high, format,
                     ImGuiSliderFlags_AlwaysClamp);
  }

 private:
  Rows rows_;
};

void chooseNormal(Sliders& sliders, SampleSettings& s) {
  sliders.slider("normal: tilt %.0f°", s.normalTilt, 0.0, 180.0);
  sliders.slider("normal: turn %.0f°", s.normalTurn, 0.0, 360.0);
}

}  // namespace

void chooseFunction(SampleSettings& settings, int part) {
  const auto* const chosen =
      std::find_if(kSampledFunctions.begin(), kSampledFunctions.end(),
                   [&](const SampledFunction& f) { return f.function == settings.function; });
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::BeginCombo("##function", labelOf(*chosen).c_str(), ImGuiComboFlags_HeightLarge))
    return;
  bool any = false;
  for (const SampledFunction& f : kSampledFunctions)
    if (contractOf(f.function).part == part) {
      offer(settings, f);
      any = true;
    }
  if (any) ImGui::Separator();
  for (const SampledFunction& f : kSampledFunctions)
    if (contractOf(f.function).part != part) offer(settings, f);
  ImGui::EndCombo();
}

void choosePoints(SampleSettings& settings, float scale) {
  const bool own = settings.function == F::kGetRandomNumbers;
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::BeginCombo("##points",
                        own ? "its own random numbers" : nameOfPoints(settings.points))) {
    for (const SamplerKind kind : kPointKinds)
      if (!own && ImGui::Selectable(nameOfPoints(kind), kind == settings.points))
        settings.points = kind;
    if (own) ImGui::TextUnformatted("get_random_numbers makes the points itself.");
    ImGui::EndCombo();
  }
  Rows rows(scale);
  rows.next();
  int power = std::countr_zero(settings.count);
  constexpr int kLow = std::countr_zero(kFewestSamples), kHigh = std::countr_zero(kMostSamples);
  // There is nothing in it for the slider to format.
  const std::string text = fmt::format("{} samples", settings.count);
  ImGui::SliderInt("##count", &power, kLow, kHigh, text.c_str(),
                   ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  settings.count = 1u << std::clamp(power, kLow, kHigh);
  rows.next();
  constexpr std::uint32_t kFirst = 0, kLast = 99;
  ImGui::SliderScalar("##seed", ImGuiDataType_U32, &settings.seed, &kFirst, &kLast, "seed %u",
                      ImGuiSliderFlags_AlwaysClamp);
}

void chooseParameters(SampleSettings& s, float scale) {
  Sliders sliders(scale);
  switch (s.function) {
    case F::kSampleHemisphere:
      chooseNormal(sliders, s);
      break;
    case F::kLambertianReflection:
      chooseNormal(sliders, s);
      sliders.slider("wo: %.0f° from the normal", s.woAngle, 0.0, 89.0);
      break;
    case F::kPhongReflection:
      chooseNormal(sliders, s);
      sliders.slider("wo: %.0f° from the normal", s.woAngle, 0.0, 89.0);
      sliders.slider("exponent %.4g", s.exponent, 0.0, 1e6, true);
      sliders.slider("Kd / (Kd + Ks) = %.2f", s.diffuseShare, 0.0, 1.0);
      break;
    case F::kSphereSample:
      sliders.slider("radius %.2f", s.radius, 0.05, 2.0);
      sliders.slider("receiver's distance %.2f", s.distance, 0.0, 6.0);
      sliders.slider("light: %.0f° up", s.elevation, -90.0, 90.0);
      sliders.slider("light: turn %.0f°", s.azimuth, 0.0, 360.0);
      break;
    case F::kStratifiedRandomRay:
      sliders.slider("strata: n = %d", s.strata, 1, kMostStrata);
      break;
    case F::kTriangularSampling:
    case F::kRectangularSampling:
    case F::kPolygonSampling:
      sliders.slider("shape %.2f", s.shape, 0.0, 1.0);
      break;
    default:
      break;
  }
}

}  // namespace pathmark::preview
