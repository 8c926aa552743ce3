#include "preview/samples/axial_domain.h"

#include "preview/samples/domain_parts.h"
#include "preview/samples/sketch_parts.h"

namespace pathmark::preview {

namespace {

constexpr double kPi = std::numbers::pi;

enum class Axial { kSphere, kHemisphere, kCosine };

class AxialDomain final : public SampleDomain {
 public:
  AxialDomain(Axial kind, const vec3& axis, const vec3& wo)
      : kind_(kind), axis_(axis), wo_(wo), frame_(glm::dvec3(axis)) {}

  CallWords object() const override {
    return kind_ == Axial::kCosine ? CallWords().add(Colour(0.5f)) : CallWords();
  }

  void addCall(CallWords& calls, std::size_t, const CallNumbers& x) const override {
    if (kind_ == Axial::kSphere) calls.add(x.s, x.t);
    if (kind_ == Axial::kHemisphere) calls.add(x.s, x.t, axis_);
    if (kind_ == Axial::kCosine) calls.add(wo_, axis_, x.s, x.t, x.u);
  }

  Answer read(std::span<const std::uint32_t> answer) const override {
    Answer result{vectorAt(answer, 0), {}};
    if (kind_ == Axial::kCosine) result.claimed = numberAt(answer, 3);
    return result;
  }

  double density(const glm::dvec3& d) const override {
    if (!isDirection(d)) return 0.0;
    if (kind_ == Axial::kSphere) return 0.25 / kPi;
    const double cosine = glm::dot(d, frame_.n);
    if (kind_ == Axial::kCosine) return std::max(cosine, 0.0) / kPi;
    constexpr double kRounding = 1e-6;
    return cosine >= -kRounding ? 0.5 / kPi : 0.0;
  }

  std::string_view astray() const override {
    return kind_ == Axial::kSphere ? "are not unit length"
                                   : "lie below the surface, or are not unit length";
  }

  Cells cells(std::size_t about) const override {
    const Grid grid = gridOf(about);
    const std::size_t count = grid.rows * grid.columns;
    return {std::vector<double>(count, 1.0 / static_cast<double>(count)),
            [=, this](const glm::dvec3& d) {
              return intervalOf(massBelow(glm::dot(d, frame_.n)), grid.rows) * grid.columns +
                     intervalOf(frame_.turn(d), grid.columns);
            }};
  }

  std::vector<Marginal> marginals() const override {
    Marginal height;
    height.name = kind_ == Axial::kSphere ? "z" : "cos(theta) to the normal";
    height.low = kind_ == Axial::kSphere ? -1.0 : 0.0;
    height.coordinate = [n = frame_.n](const glm::dvec3& d) { return glm::dot(d, n); };
    height.mass = [this](double from, double to) { return massBelow(to) - massBelow(from); };
    const bool sphere = kind_ == Axial::kSphere;
    return {height, azimuthMarginal(sphere ? "azimuth around z (°)" : "azimuth (°)", frame_,
                                    [](double from, double to) { return to - from; })};
  }

  Sketch sketch() const override {
    Sketch sketch;
    sketch.radius = 1.15;
    if (kind_ != Axial::kCosine) sketch.up = {0, 0, 1};
    addWireSphere(sketch, glm::dvec3(0), 1.0, frame_, kind_ != Axial::kSphere);
    addAxes(sketch, kind_ == Axial::kSphere ? 1.2 : 0.3);
    if (kind_ == Axial::kSphere) return sketch;
    addNormal(sketch, frame_.n);
    if (kind_ == Axial::kCosine)
      addArrow(sketch, StrokeKind::kOutgoing, 1.15 * glm::dvec3(wo_), "wo");
    return sketch;
  }

 private:
  // Of the cosine to the axis.
  double massBelow(double cosine) const {
    if (kind_ == Axial::kSphere) return std::clamp(0.5 * (cosine + 1.0), 0.0, 1.0);
    const double c = std::clamp(cosine, 0.0, 1.0);
    return kind_ == Axial::kHemisphere ? c : c * c;
  }

  Axial kind_;
  vec3 axis_, wo_;
  DirectionFrame frame_;
};

}  // namespace

std::unique_ptr<SampleDomain> makeSphereDomain() {
  return std::make_unique<AxialDomain>(Axial::kSphere, vec3(0, 0, 1), vec3(0, 0, 1));
}

std::unique_ptr<SampleDomain> makeHemisphereDomain(const SampleSettings& settings) {
  const vec3 n = normalOf(settings, {0, 0, 1});
  return std::make_unique<AxialDomain>(Axial::kHemisphere, n, n);
}

std::unique_ptr<SampleDomain> makeCosineDomain(const SampleSettings& settings) {
  const vec3 n = normalOf(settings, {0, 1, 0});
  return std::make_unique<AxialDomain>(Axial::kCosine, n, outgoingOf(settings, glm::dvec3(n)));
}

}  // namespace pathmark::preview
