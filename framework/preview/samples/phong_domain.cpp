#include "preview/samples/phong_domain.h"

#include "preview/samples/cosine_lobe.h"
#include "preview/samples/domain_parts.h"
#include "preview/samples/sketch_parts.h"

namespace pathmark::preview {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kReflectance = 0.8;  // Kd + Ks

class PhongDomain final : public SampleDomain {
 public:
  PhongDomain(const vec3& n, const vec3& wo, const SampleSettings& settings)
      : n_(n),
        wo_(wo),
        kd_(static_cast<float>(kReflectance * settings.diffuseShare)),
        ks_(static_cast<float>(kReflectance * (1.0 - settings.diffuseShare))),
        exponent_(static_cast<float>(settings.exponent)),
        share_(double{kd_} / (double{kd_} + double{ks_})),
        specular_{double{exponent_}},
        normal_(glm::normalize(glm::dvec3(n))),
        around_(mirrorOf(normal_, glm::normalize(glm::dvec3(wo))), normal_),
        tilt_(std::acos(std::clamp(glm::dot(around_.n, normal_), -1.0, 1.0))) {}

  CallWords object() const override { return CallWords().add(Colour(kd_), Colour(ks_), exponent_); }
  void addCall(CallWords& calls, std::size_t, const CallNumbers& x) const override {
    calls.add(wo_, n_, x.s, x.t, x.u);
  }
  Answer read(std::span<const std::uint32_t> answer) const override {
    return {vectorAt(answer, 0), numberAt(answer, 3)};
  }

  double density(const glm::dvec3& d) const override {
    if (!isDirection(d)) return 0.0;
    return share_ * CosineLobe{}.density(glm::dot(glm::normalize(d), normal_)) +
           (1.0 - share_) * specular_.density(cosAlpha(d));
  }

  std::string_view astray() const override {
    return "lie where neither lobe reaches, or are not unit length";
  }

  Cells cells(std::size_t about) const override {
    const Grid grid = gridOf(about);
    std::vector<double> edges{0.0};
    for (std::size_t row = 1; row < grid.rows; ++row)
      edges.push_back(angleWith(static_cast<double>(row) / static_cast<double>(grid.rows)));
    edges.push_back(kPi);
    Cells cells;
    for (std::size_t row = 0; row < grid.rows; ++row)
      for (std::size_t column = 0; column < grid.columns; ++column)
        cells.masses.push_back(massOf({edges[row], edges[row + 1], turnOf(column, grid.columns),
                                       turnOf(column + 1, grid.columns)}));
    cells.cellOf = [=, this](const glm::dvec3& d) {
      const auto edge = std::upper_bound(edges.begin() + 1, edges.end() - 1, alpha(d));
      const auto row = static_cast<std::size_t>(edge - edges.begin()) - 1;
      return row * grid.columns + intervalOf(around_.turn(d), grid.columns);
    };
    return cells;
  }

  std::vector<Marginal> marginals() const override {
    return {angleToMirror(), heightOverSurface(),
            azimuthMarginal("azimuth around it (°)", around_, [this](double from, double to) {
              return massOf({0.0, kPi, 2.0 * kPi * from, 2.0 * kPi * to});
            })};
  }

  Sketch sketch() const override {
    Sketch sketch;
    sketch.radius = 1.15;
    addWireSphere(sketch, glm::dvec3(0), 1.0, DirectionFrame(normal_), true);
    addAxes(sketch, 0.3);
    addNormal(sketch, normal_);
    addArrow(sketch, StrokeKind::kOutgoing, 1.15 * glm::dvec3(wo_), "wo");
    addArrow(sketch, StrokeKind::kMirror, 1.15 * around_.n, "mirror");
    return sketch;
  }

 private:
  static glm::dvec3 mirrorOf(const glm::dvec3& n, const glm::dvec3& wo) {
    return glm::normalize(2.0 * glm::dot(n, wo) * n - wo);
  }
  static double turnOf(std::size_t column, std::size_t columns) {
    return 2.0 * kPi * static_cast<double>(column) / static_cast<double>(columns);
  }

  // By the distance from the mirror direction, since the cosine loses digits next to 1.
  double cosAlpha(const glm::dvec3& d) const {
    const glm::dvec3 difference = glm::normalize(d) - around_.n;
    return 1.0 - 0.5 * glm::dot(difference, difference);
  }
  double alpha(const glm::dvec3& d) const {
    return 2.0 * std::asin(std::min(0.5 * glm::length(glm::normalize(d) - around_.n), 1.0));
  }

  // Around the mirror direction.
  double massWithin(double angle) const {
    return share_ * CosineLobe{}.massWithinOf(tilt_, angle) +
           (1.0 - share_) * specular_.massWithin(angle);
  }
  double angleWith(double mass) const {
    double low = 0.0, high = kPi;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (low + high);
      (massWithin(middle) < mass ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  double massOf(const RingSector& sector) const {
    const double turn = (sector.toAzimuth - sector.fromAzimuth) / (2.0 * kPi);
    return share_ * diffuseMass(tilt_, sector) +
           (1.0 - share_) * turn *
               (specular_.massWithin(sector.toAngle) - specular_.massWithin(sector.fromAngle));
  }

  // The axis ends behind the specular lobe, if there is one.
  Marginal angleToMirror() const {
    constexpr double kAll = 0.999, kSome = 0.01;
    const double behind =
        share_ < 1.0 - kSome ? 1.2 * specular_.angleWith(kAll) : 0.5 * kPi + tilt_;
    Marginal marginal;
    marginal.name = "angle to the mirror (°)";
    marginal.high = std::min(behind, kPi) / kDegree;
    marginal.coordinate = [this](const glm::dvec3& d) { return alpha(d) / kDegree; };
    marginal.mass = [this](double from, double to) {
      return massWithin(to * kDegree) - massWithin(from * kDegree);
    };
    return marginal;
  }

  // The axis goes below the surface only where the specular lobe does.
  Marginal heightOverSurface() const {
    constexpr double kHardly = 1e-4;
    const auto massAbove = [this](double cosine) {
      const double c = std::clamp(cosine, -1.0, 1.0), angle = std::acos(c);
      return share_ * CosineLobe{}.massWithin(angle) +
             (1.0 - share_) * specular_.massWithinOf(tilt_, angle);
    };
    Marginal marginal;
    marginal.name = "cos(theta) to the normal";
    marginal.low = massAbove(0.0) < 1.0 - kHardly ? -1.0 : 0.0;
    marginal.coordinate = [this](const glm::dvec3& d) { return glm::dot(d, normal_); };
    marginal.mass = [massAbove](double from, double to) { return massAbove(from) - massAbove(to); };
    return marginal;
  }

  vec3 n_, wo_;
  float kd_, ks_, exponent_;
  double share_;  // of the diffuse lobe
  CosineLobe specular_;
  glm::dvec3 normal_;
  DirectionFrame around_;  // the mirror direction
  double tilt_;            // of the normal from it
};

}  // namespace

std::unique_ptr<SampleDomain> makePhongDomain(const SampleSettings& settings) {
  const vec3 n = normalOf(settings, {0, 1, 0});
  return std::make_unique<PhongDomain>(n, outgoingOf(settings, glm::dvec3(n)), settings);
}

}  // namespace pathmark::preview
