#include "render/receivers.h"

namespace pathmark {

namespace {

using Vectors = std::array<FloatV, 3>;

Vectors load(const LaneArray (&a)[3]) {
  return {pathmark::load(a[0]), pathmark::load(a[1]), pathmark::load(a[2])};
}

void store(const FloatV& v, LaneArray& to) { v.copy_to(to.lane, simd::vector_aligned); }

Vectors towards(const Point& to, const Vectors& from) {
  return {to.x - from[0], to.y - from[1], to.z - from[2]};
}

FloatV dot(const Vectors& a, const Vectors& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

FloatV dot(const Vectors& a, const Vector& b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }

SegmentFan::Mask occludedOneByOne(const SceneCore& core, const LaneArray (&origins)[3],
                                  const Point& end, const SegmentFan::Mask& lanes) {
  SegmentFan::Mask occluded(false);
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (!lanes[i]) continue;
    const Point origin(origins[0].lane[i], origins[1].lane[i], origins[2].lane[i]);
    occluded[i] = core.occluded(origin, end - origin);
  }
  return occluded;
}

}  // namespace

Receivers::Receivers(std::size_t pixels) : groups_((pixels + kLanes - 1) / kLanes) {
  for (std::size_t pixel = 0; pixel < groups_.size() * kLanes; ++pixel) takeAway(pixel);
}

void Receivers::put(std::size_t pixel, const Hit& surface) {
  Group& group = groups_[pixel / kLanes];
  const std::size_t lane = pixel % kLanes;
  const Point origin = surface.spawnRay(surface.n).origin;
  for (int axis = 0; axis < 3; ++axis) {
    group.p[axis].lane[lane] = surface.p[axis];
    group.n[axis].lane[lane] = surface.n[axis];
    group.origin[axis].lane[lane] = origin[axis];
  }
}

void Receivers::takeAway(std::size_t pixel) {
  Group& group = groups_[pixel / kLanes];
  group.cosX.lane[pixel % kLanes] = 0.0f;
  // Its cosines are then not above 0.
  for (LaneArray& n : group.n) n.lane[pixel % kLanes] = kNaN;
}

std::uint64_t Receivers::look(const SceneCore& core, const Hit& y, std::size_t except) {
  const Point start = y.spawnRay(y.n).origin;
  std::uint64_t shadowRays = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    Group& group = groups_[g];
    const Vectors way = towards(y.p, load(group.p));
    const FloatV squared = dot(way, way), distance = sqrt(squared);
    const Vectors wi{way[0] / distance, way[1] / distance, way[2] / distance};
    const FloatV cosY = -dot(wi, y.n);
    FloatV cosX = dot(load(group.n), wi);
    SegmentFan::Mask lanes = cosX > 0.0f && cosY > 0.0f;
    if (except / kLanes == g) lanes[except % kLanes] = false;
    if (any_of(lanes)) shadowRays += static_cast<std::uint64_t>(popcount(lanes));
    if (any_of(lanes) && core.hidesOneWay()) {
      // As the pixels' own rays would go.
      lanes = lanes && !occludedOneByOne(core, group.origin, start, lanes);
    } else if (any_of(lanes)) {
      const Vectors back = towards(start, load(group.origin));
      lanes = lanes && !core.occluded({start, {-back[0], -back[1], -back[2]}, lanes});
    }
    where(!lanes, cosX) = 0.0f;
    for (std::size_t axis = 0; axis < 3; ++axis) store(wi[axis], group.wi[axis]);
    store(cosX, group.cosX);
    store(cosY / squared, group.perArea);
  }
  return shadowRays;
}

}  // namespace pathmark
