#include "preview/samples/square_domain.h"

#include "preview/samples/domain_parts.h"

#include <pathmark/camera.h>

namespace pathmark::preview {

namespace {

// Places are (x, y, 0), y downwards for a pixel; uniform on the unit square.
class SquareDomain : public SampleDomain {
 public:
  SquareDomain(bool downwards, int strata) : downwards_(downwards), strata_(strata) {}

  double density(const glm::dvec3& place) const override {
    // Film points are known up to rounding; numbers are what they are.
    const double rounding = downwards_ ? 1e-5 : 0.0;
    const auto within = [&](double x) { return x >= -rounding && x < 1.0 + rounding; };
    return within(place.x) && within(place.y) && place.z == 0.0 ? 1.0 : 0.0;
  }

  Cells cells(std::size_t about) const override {
    const Grid grid = gridOf(about);
    const std::size_t count = grid.rows * grid.columns;
    return {
        std::vector<double>(count, 1.0 / static_cast<double>(count)), [=](const glm::dvec3& place) {
          return intervalOf(place.y, grid.rows) * grid.columns + intervalOf(place.x, grid.columns);
        }};
  }

  std::vector<Marginal> marginals() const override {
    const auto uniform = [](double from, double to) { return to - from; };
    return {{"x", 0.0, 1.0, [](const glm::dvec3& place) { return place.x; }, uniform},
            {"y", 0.0, 1.0, [](const glm::dvec3& place) { return place.y; }, uniform}};
  }

  Sketch sketch() const override {
    Sketch sketch;
    sketch.flat = true;
    sketch.centre = shown({0.5, 0.5, 0.0});
    sketch.radius = 0.62;
    for (int k = 0; k <= strata_; ++k) {
      const double x = static_cast<double>(k) / strata_;
      const StrokeKind kind = k == 0 || k == strata_ ? StrokeKind::kEdge : StrokeKind::kFaint;
      sketch.strokes.push_back({kind, {shown({x, 0, 0}), shown({x, 1, 0})}});
      sketch.strokes.push_back({kind, {shown({0, x, 0}), shown({1, x, 0})}});
    }
    sketch.captions.push_back({shown({1.05, 0, 0}), "x"});
    sketch.captions.push_back({shown({0.0, 1.05, 0}), "y"});
    return sketch;
  }

  glm::dvec3 shown(const glm::dvec3& place) const override {
    return {place.x, downwards_ ? -place.y : place.y, place.z};
  }

 private:
  bool downwards_;
  int strata_;
};

class UnitSquareDomain final : public SquareDomain {
 public:
  UnitSquareDomain() : SquareDomain(false, 1) {}

  // The seed is made by whoever calls: each follows from the one before.
  void addCall(CallWords&, std::size_t, const CallNumbers&) const override {}
  Answer read(std::span<const std::uint32_t> answer) const override {
    return {{numberAt(answer, 0), numberAt(answer, 1), 0.0}, {}};
  }
  std::string_view astray() const override { return "lie outside [0,1)"; }
};

// A camera that looks along -z, and the pixel in column 2, row 1 of its film.
class PixelDomain final : public SquareDomain {
 public:
  explicit PixelDomain(int strata) : SquareDomain(true, strata), strata_(strata) {}

  CallWords object() const override {
    return CallWords().add(camera_.eye(), camera_.topLeft(), camera_.pixelRight(),
                           camera_.pixelDown(), camera_.width(), camera_.height());
  }
  void addCall(CallWords& calls, std::size_t index, const CallNumbers& x) const override {
    const int stratum = static_cast<int>(index) % (strata_ * strata_);
    calls.add(kColumn, kRow, stratum % strata_, stratum / strata_, strata_, x.s, x.t);
  }

  // Where on the film the ray goes through; behind the camera is nowhere.
  Answer read(std::span<const std::uint32_t> answer) const override {
    const glm::dvec3 direction = vectorAt(answer, 3);
    const glm::dmat3 film(glm::dvec3(camera_.pixelRight()), glm::dvec3(camera_.pixelDown()),
                          glm::dvec3(camera_.topLeft()));
    const glm::dvec3 scaled = glm::inverse(film) * direction;
    const double behind = scaled.z > 0.0 ? 0.0 : 1.0;
    return {{scaled.x / scaled.z - kColumn, scaled.y / scaled.z - kRow, behind}, {}};
  }
  std::string_view astray() const override { return "lie outside the pixel"; }

 private:
  static constexpr int kColumn = 2, kRow = 1;

  int strata_;
  SimpleCamera camera_{{0, 0, 0}, {-2.0f, 1.5f, -4.0f}, {1, 0, 0}, {0, -1, 0}, 4, 3};
};

}  // namespace

std::unique_ptr<SampleDomain> makeUnitSquareDomain() {
  return std::make_unique<UnitSquareDomain>();
}

std::unique_ptr<SampleDomain> makePixelDomain(const SampleSettings& settings) {
  return std::make_unique<PixelDomain>(settings.strata);
}

}  // namespace pathmark::preview
