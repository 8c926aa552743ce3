#include "intersect/triangle_blocks.h"

#include "intersect/triangle_pairs.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace pathmark {

namespace {

// Of the corners as they are in float: the normal of a thin triangle in the scene may be that of
// corners that were not rounded yet.
Float3 normalOf(const std::array<Float3, 3>& corners) {
  const auto corner = [&](std::size_t k) {
    return glm::dvec3(corners[k][0], corners[k][1], corners[k][2]);
  };
  const Vector n(glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
  return {n.x, n.y, n.z};
}

}  // namespace

TriangleBlocks::TriangleBlocks(const FlatSceneView& scene, std::span<const std::uint32_t> triangles,
                               const FlatTests& tests)
    : culls_(tests.backsOfAll) {
  std::vector<TrianglePair> pairs =
      tests.pairs ? pairTriangles(scene, triangles) : inNoPairs(scene, triangles);
  // Those that are not flat side by side, in as few blocks as they need.
  std::stable_partition(pairs.begin(), pairs.end(), [](const TrianglePair& p) { return !p.flat; });
  pairs_ = pairs.size();
  const std::size_t least = tests.kindsOfNothing ? 1 : 0;
  blocks_.resize(std::max(least, (pairs.size() + kLanes - 1) / kLanes));
  for (std::size_t i = 0; i < blocks_.size() * kLanes; ++i) {
    Block& block = blocks_[i / kLanes];
    const std::size_t lane = i % kLanes;
    const bool present = i < pairs.size();
    for (std::size_t corner = 0; corner < 4; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis)
        block.vertex[corner][axis].lane[lane] = present ? pairs[i].corner[corner][axis] : kNaN;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t triangle = present ? pairs[i].triangle[pairs[i].flat ? 0 : k] : 0;
      block.index[k].lane[lane] = bitsOfIndex(triangle);
      // The plane of no triangle is met nowhere.
      const Float3 n =
          present ? normalOf(scene.corners(scene.triangles[triangle])) : Float3{kNaN, kNaN, kNaN};
      for (std::size_t axis = 0; axis < 3; ++axis) block.normal[k][axis].lane[lane] = n[axis];
    }
    const bool frontOnly = present && scene.frontOnly(scene.triangles[pairs[i].triangle[0]]);
    block.folded = block.folded || (present && !pairs[i].flat);
    block.largestSlope.lane[lane] = frontOnly ? 0.0f : kInfinity;
    culls_ = culls_ || frontOnly;
  }
}

// One pair of a block, for all lanes.
struct TriangleBlocks::OnePair {
  const Block& block;
  std::size_t lane;

  const LaneArray (&vertex)[4][3] = block.vertex;
  const LaneArray (&normal)[2][3] = block.normal;
  const LaneArray& largestSlope = block.largestSlope;
  const LaneArray (&index)[2] = block.index;
  bool folded = block.folded;

  FloatV take(const LaneArray& a) const { return a.lane[lane]; }
};

// A ray for all lanes, or one in each lane, all of the same origin and largest axis.
struct TriangleBlocks::Lines {
  unsigned kx, ky, kz;         // which coordinate is which
  FloatV ox, oy, oz;           // origin
  FloatV sx, sy;               // shear
  FloatV backX, backY, backZ;  // the direction turned round

  Lines(const Point& origin, const Vector& direction)
      : Lines(RayShear(origin, direction), glm::value_ptr(direction)) {}

  Lines(const SegmentFan& fan, unsigned largestAxis)
      : kx((largestAxis + 1) % 3),
        ky((largestAxis + 2) % 3),
        kz(largestAxis),
        ox(glm::value_ptr(fan.origin)[kx]),
        oy(glm::value_ptr(fan.origin)[ky]),
        oz(glm::value_ptr(fan.origin)[kz]),
        backX(-fan.way[kx]),
        backY(-fan.way[ky]),
        backZ(-fan.way[kz]) {
    const FloatV inverse = 1.0f / fan.way[kz];
    sx = fan.way[kx] * inverse;
    sy = fan.way[ky] * inverse;
  }

 private:
  Lines(const RayShear& r, const float* d)
      : kx(r.kx),
        ky(r.ky),
        kz(r.kz),
        ox(r.ox),
        oy(r.oy),
        oz(r.oz),
        sx(r.sx),
        sy(r.sy),
        backX(-d[r.kx]),
        backY(-d[r.ky]),
        backZ(-d[r.kz]) {}
};

// From a corner of each pair to the origin of the ray: this way round what comes from memory is
// subtracted, which is one instruction. x and y with the ray as the z axis.
struct TriangleBlocks::Corner {
  FloatV toX, toY, toZ;
  FloatV x, y;

  template <class Pairs>
  Corner(const Pairs& pairs, std::size_t k, const Lines& r)
      : toX(r.ox - pairs.take(pairs.vertex[k][r.kx])),
        toY(r.oy - pairs.take(pairs.vertex[k][r.ky])),
        toZ(r.oz - pairs.take(pairs.vertex[k][r.kz])),
        x(minusProduct(toX, r.sx, toZ)),
        y(minusProduct(toY, r.sy, toZ)) {}

  // The edge function of the ray and the edge from here: twice the area of the triangle that they
  // span.
  FloatV edgeTo(const Corner& q) const { return q.x * y - q.y * x; }
};

// The triangles that the ray's line meets, and where.
struct TriangleBlocks::Met {
  FloatV::mask_type any;  // of the pair
  FloatV t, index;

  // Of pairs of which both are met, on the common edge or one behind the other: any, t and index
  // are the second's.
  FloatV::mask_type both;
  FloatV firstT;

  FloatV::mask_type onSegment() const {
    const auto within = [](const FloatV& at) { return at > 0.0f && at < 1.0f; };
    return (any && within(t)) || (both && within(firstT));
  }
};

// Where the ray meets the planes with normals n through the corners a. Interpolating the distances
// of all corners would lose as many digits as a triangle is longer than high: rays that leave a
// thin one would meet it again. Differences first: far from the origin all products are large. A
// ray in the plane divides by 0, and meets nothing.
template <bool kCulls, class Pairs>
inline FloatV TriangleBlocks::distance(const Pairs& pairs, const Lines& line, const Corner& a,
                                       const FloatV (&n)[3]) {
  FloatV slope = plusProduct(plusProduct(n[0] * line.backX, n[1], line.backY), n[2], line.backZ);
  if constexpr (kCulls) where(!(-slope < pairs.take(pairs.largestSlope)), slope) = kNaN;
  return plusProduct(plusProduct(n[0] * a.toX, n[1], a.toY), n[2], a.toZ) / slope;
}

// Whether the segments cross the plane of a flat pair, as `meet` will find.
template <bool kCulls>
inline SegmentFan::Mask TriangleBlocks::crossesPlane(const OnePair& pair, const Lines& lines) {
  const auto normal = [&](unsigned axis) { return pair.take(pair.normal[0][axis]); };
  const FloatV t = distance<kCulls>(pair, lines, Corner(pair, 0, lines),
                                    {normal(lines.kx), normal(lines.ky), normal(lines.kz)});
  return t > 0.0f && t < 1.0f;
}

template <bool kCulls, class Pairs>
inline TriangleBlocks::Met TriangleBlocks::meet(const Pairs& pairs, const Lines& line) {
  const Corner a(pairs, 0, line), b(pairs, 1, line), c(pairs, 2, line), d(pairs, 3, line);
  const FloatV ab = a.edgeTo(b), bc = b.edgeTo(c), cd = c.edgeTo(d), da = d.edgeTo(a);
  const auto normal = [&](std::size_t k, unsigned axis) {
    return pairs.take(pairs.normal[k][axis]);
  };
  const FloatV first[3] = {normal(0, line.kx), normal(0, line.ky), normal(0, line.kz)};
  if (!pairs.folded)
    return {min(min(ab, bc), min(cd, da)) >= 0.0f || max(max(ab, bc), max(cd, da)) <= 0.0f,
            distance<kCulls>(pairs, line, a, first), pairs.take(pairs.index[0]),
            FloatV::mask_type(false), 0.0f};
  const FloatV ca = c.edgeTo(a), ac = -ca;
  const FloatV::mask_type inFirst = min(min(ab, bc), ca) >= 0.0f || max(max(ab, bc), ca) <= 0.0f;
  const FloatV::mask_type inSecond = min(min(cd, da), ac) >= 0.0f || max(max(cd, da), ac) <= 0.0f;
  const auto choose = [&](FloatV value, const FloatV& second) {
    where(inSecond, value) = second;
    return value;
  };
  const FloatV chosen[3] = {choose(first[0], normal(1, line.kx)),
                            choose(first[1], normal(1, line.ky)),
                            choose(first[2], normal(1, line.kz))};
  Met met{inFirst || inSecond, distance<kCulls>(pairs, line, a, chosen),
          choose(pairs.take(pairs.index[0]), pairs.take(pairs.index[1])), inFirst && inSecond,
          0.0f};
  if (any_of(met.both)) [[unlikely]]
    met.firstT = distance<kCulls>(pairs, line, a, first);
  return met;
}

template <bool kCulls>
bool TriangleBlocks::closestOf(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  const Lines line(ray.origin, ray.direction);
  NearestV nearest(tMax);
  for (const Block& block : blocks_) {
    const Met met = meet<kCulls>(block, line);
    nearest.take(met.any, met.t, met.index);
    if (any_of(met.both)) [[unlikely]]
      nearest.take(met.both, met.firstT, load(block.index[0]));
  }
  if (!nearest.reduce(tMax, hit)) return false;
  hit.isSphere = false;
  return true;
}

template <bool kCulls>
bool TriangleBlocks::occludedOf(const Point& origin, const Vector& segment) const {
  const Lines line(origin, segment);
  for (const Block& block : blocks_)
    if (any_of(meet<kCulls>(block, line).onSegment())) return true;
  return false;
}

// Of a fan's segments with this largest axis.
template <bool kCulls>
SegmentFan::Mask TriangleBlocks::occludedOf(const Lines& lines, SegmentFan::Mask lanes) const {
  SegmentFan::Mask occluded(false);
  for (std::size_t i = 0; i < pairs_; ++i) {
    const OnePair pair{blocks_[i / kLanes], i % kLanes};
    // Most planes have the origin and all ends on the same side.
    if (!pair.folded && none_of(lanes && crossesPlane<kCulls>(pair, lines))) continue;
    occluded = occluded || (lanes && meet<kCulls>(pair, lines).onSegment());
    if (all_of(occluded == lanes)) break;
  }
  return occluded;
}

template <bool kCulls>
SegmentFan::Mask TriangleBlocks::occludedOf(const SegmentFan& fan) const {
  // The largest axis of each, by the order of RayShear.
  const FloatV x = abs(fan.way[0]), y = abs(fan.way[1]), z = abs(fan.way[2]);
  const SegmentFan::Mask alongZ = z >= x && z >= y, alongY = !alongZ && y >= x;
  const SegmentFan::Mask along[3] = {!alongZ && !alongY, alongY, alongZ};
  SegmentFan::Mask occluded(false);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const SegmentFan::Mask lanes = fan.lanes && along[axis];
    if (any_of(lanes)) occluded = occluded || occludedOf<kCulls>(Lines(fan, axis), lanes);
  }
  return occluded;
}

bool TriangleBlocks::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  return culls_ ? closestOf<true>(ray, tMax, hit) : closestOf<false>(ray, tMax, hit);
}

bool TriangleBlocks::occluded(const Point& origin, const Vector& segment) const {
  return culls_ ? occludedOf<true>(origin, segment) : occludedOf<false>(origin, segment);
}

SegmentFan::Mask TriangleBlocks::occluded(const SegmentFan& fan) const {
  return culls_ ? occludedOf<true>(fan) : occludedOf<false>(fan);
}

}  // namespace pathmark
