#include "preview/samples/sphere_light_domain.h"

#include "preview/samples/domain_parts.h"
#include "preview/samples/sketch_parts.h"

namespace pathmark::preview {

namespace {

constexpr double kPi = std::numbers::pi;

// With the receiver outside, the density is uniform over the cone of directions in which it sees
// the sphere; else it is uniform over the area (Shirley, Wang & Zimmerman 1996, section 3.2).
class SphereLightDomain final : public SampleDomain {
 public:
  SphereLightDomain(const vec3& centre, float radius)
      : floatCentre_(centre),
        centre_(centre),
        radius_(double{radius}),
        distance_(glm::length(centre_)),
        frame_(distance_ > 0.0 ? centre_ : glm::dvec3(0, 1, 0)),
        outside_(distance_ > radius_) {
    if (!outside_) return;
    const double sine = radius_ / distance_;
    oneMinusCosMax_ = sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)));
  }

  void addCall(CallWords& calls, std::size_t, const CallNumbers& x) const override {
    calls.add(floatCentre_, radius_, vec3(0.0f), x.s, x.t);
  }
  Answer read(std::span<const std::uint32_t> answer) const override {
    return {vectorAt(answer, 0), numberAt(answer, 6)};
  }

  double density(const glm::dvec3& place) const override {
    if (!(std::abs(glm::length(place - centre_) - radius_) < kRounding * (radius_ + distance_)))
      return 0.0;
    if (!outside_) return 1.0 / (4.0 * kPi * radius_ * radius_);
    const glm::dvec3 n = glm::normalize(place - centre_), back = -(centre_ + radius_ * n);
    const double distance2 = glm::dot(back, back);
    const double cosine = glm::dot(n, back) / std::sqrt(distance2);
    return cosine > 0.0 ? cosine / (2.0 * kPi * distance2 * oneMinusCosMax_) : 0.0;
  }

  std::string_view astray() const override {
    return outside_ ? "lie off the sphere, or where the receiver cannot see them"
                    : "lie off the sphere";
  }

  Cells cells(std::size_t about) const override {
    const Grid grid = gridOf(about);
    const std::size_t count = grid.rows * grid.columns;
    return {std::vector<double>(count, 1.0 / static_cast<double>(count)),
            [=, this](const glm::dvec3& place) {
              return intervalOf(massWithin(1.0 - cosine(place)), grid.rows) * grid.columns +
                     intervalOf(frame_.turn(around(place)), grid.columns);
            }};
  }

  std::vector<Marginal> marginals() const override {
    Marginal angle;
    if (outside_) {
      angle.name = "angle to the axis (°)";
      angle.high = std::asin(radius_ / distance_) / kDegree;
      angle.coordinate = [this](const glm::dvec3& p) { return angleTo(p) / kDegree; };
      angle.mass = [this](double from, double to) {
        return massWithin(oneMinusCos(to * kDegree)) - massWithin(oneMinusCos(from * kDegree));
      };
    } else {
      angle.name = "cosine at the centre, to the axis";
      angle.low = -1.0;
      angle.coordinate = [this](const glm::dvec3& p) { return cosine(p); };
      angle.mass = [](double from, double to) { return 0.5 * (to - from); };
    }
    return {angle, azimuthMarginal("azimuth around it (°)", frame_,
                                   [](double from, double to) { return to - from; })};
  }

  Sketch sketch() const override {
    Sketch sketch;
    // From the receiver to behind the sphere; of a far receiver's view, the end.
    constexpr double kMargin = 1.15, kFarthest = 3.0;
    const double length =
        std::min(std::max(distance_ + radius_, 2.0 * radius_), kFarthest * 2.0 * radius_);
    sketch.radius = 0.5 * kMargin * length;
    sketch.centre = (distance_ + radius_ - 0.5 * length) * frame_.n;
    // Wires around the vertical, so that they are not taken for the strata of the cone.
    addWireSphere(sketch, centre_, radius_, DirectionFrame(glm::dvec3(0, 1, 0)), false);
    sketch.strokes.push_back({StrokeKind::kFaint, {glm::dvec3(0), centre_}});
    sketch.captions.push_back({glm::dvec3(0), "receiver"});
    if (outside_) addCone(sketch);
    return sketch;
  }

 private:
  static constexpr double kRounding = 1e-5;

  static double oneMinusCos(double angle) {
    const double half = std::sin(0.5 * angle);
    return 2.0 * half * half;
  }

  // The point, or where it is as seen from the middle of the domain.
  glm::dvec3 around(const glm::dvec3& place) const { return outside_ ? place : place - centre_; }

  double angleTo(const glm::dvec3& place) const {
    const glm::dvec3 d = glm::normalize(around(place));
    return 2.0 * std::asin(std::min(0.5 * glm::length(d - frame_.n), 1.0));
  }
  double cosine(const glm::dvec3& place) const { return 1.0 - oneMinusCos(angleTo(place)); }

  double massWithin(double oneMinusCosine) const {
    return std::clamp(oneMinusCosine / (outside_ ? oneMinusCosMax_ : 2.0), 0.0, 1.0);
  }

  // From the receiver to the circle on which the cone touches the sphere.
  void addCone(Sketch& sketch) const {
    constexpr int kLines = 12;
    const double sine = radius_ / distance_, cosine = std::sqrt(1.0 - sine * sine);
    const glm::dvec3 middle = centre_ - radius_ * sine * frame_.n;
    sketch.strokes.push_back(circle(StrokeKind::kEdge, middle, frame_, radius_ * cosine));
    for (int k = 0; k < kLines; ++k)
      sketch.strokes.push_back(
          {StrokeKind::kFaint,
           {glm::dvec3(0),
            middle + radius_ * cosine * frame_.direction(0.0, 2.0 * kPi * k / kLines)}});
  }

  vec3 floatCentre_;
  glm::dvec3 centre_;
  double radius_, distance_;
  DirectionFrame frame_;  // around the axis from the receiver to the centre
  bool outside_;
  double oneMinusCosMax_ = 2.0;
};

}  // namespace

std::unique_ptr<SampleDomain> makeSphereLightDomain(const SampleSettings& settings) {
  const glm::dvec3 towards =
      DirectionFrame(glm::dvec3(0, 1, 0))
          .direction(std::sin(settings.elevation * kDegree), settings.azimuth * kDegree);
  return std::make_unique<SphereLightDomain>(vec3(settings.distance * towards),
                                             static_cast<float>(settings.radius));
}

}  // namespace pathmark::preview
