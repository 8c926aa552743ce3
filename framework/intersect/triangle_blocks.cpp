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

// A ray, for all lanes.
struct TriangleBlocks::Lines {
  unsigned kx, ky, kz;         // which coordinate is which
  FloatV ox, oy, oz;           // origin
  FloatV sx, sy;               // shear
  FloatV backX, backY, backZ;  // the direction turned round

  Lines(const Point& origin, const Vector& direction)
      : Lines(RayShear(origin, direction), glm::value_ptr(direction)) {}

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

  Corner(const LaneArray (&vertex)[3], const Lines& r)
      : toX(r.ox - load(vertex[r.kx])),
        toY(r.oy - load(vertex[r.ky])),
        toZ(r.oz - load(vertex[r.kz])),
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
};

// Where the ray meets the planes with normals n through the corners a. Interpolating the distances
// of all corners would lose as many digits as a triangle is longer than high: rays that leave a
// thin one would meet it again. Differences first: far from the origin all products are large. A
// ray in the plane divides by 0, and meets nothing.
template <bool kCulls>
inline FloatV TriangleBlocks::distance(const Block& block, const Lines& line, const Corner& a,
                                       const FloatV (&n)[3]) {
  FloatV slope = plusProduct(plusProduct(n[0] * line.backX, n[1], line.backY), n[2], line.backZ);
  if constexpr (kCulls) where(!(-slope < load(block.largestSlope)), slope) = kNaN;
  return plusProduct(plusProduct(n[0] * a.toX, n[1], a.toY), n[2], a.toZ) / slope;
}

template <bool kCulls>
inline TriangleBlocks::Met TriangleBlocks::meet(const Block& block, const Lines& line) {
  const Corner a(block.vertex[0], line), b(block.vertex[1], line), c(block.vertex[2], line),
      d(block.vertex[3], line);
  const FloatV ab = a.edgeTo(b), bc = b.edgeTo(c), cd = c.edgeTo(d), da = d.edgeTo(a);
  const auto normal = [&](std::size_t k, unsigned axis) { return load(block.normal[k][axis]); };
  const FloatV first[3] = {normal(0, line.kx), normal(0, line.ky), normal(0, line.kz)};
  if (!block.folded)
    return {min(min(ab, bc), min(cd, da)) >= 0.0f || max(max(ab, bc), max(cd, da)) <= 0.0f,
            distance<kCulls>(block, line, a, first), load(block.index[0]), FloatV::mask_type(false),
            0.0f};
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
  Met met{inFirst || inSecond, distance<kCulls>(block, line, a, chosen),
          choose(load(block.index[0]), load(block.index[1])), inFirst && inSecond, 0.0f};
  if (any_of(met.both)) [[unlikely]]
    met.firstT = distance<kCulls>(block, line, a, first);
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
  const auto within = [](const FloatV& t) { return t > 0.0f && t < 1.0f; };
  for (const Block& block : blocks_) {
    const Met met = meet<kCulls>(block, line);
    if (any_of((met.any && within(met.t)) || (met.both && within(met.firstT)))) return true;
  }
  return false;
}

bool TriangleBlocks::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  return culls_ ? closestOf<true>(ray, tMax, hit) : closestOf<false>(ray, tMax, hit);
}

bool TriangleBlocks::occluded(const Point& origin, const Vector& segment) const {
  return culls_ ? occludedOf<true>(origin, segment) : occludedOf<false>(origin, segment);
}

}  // namespace pathmark
