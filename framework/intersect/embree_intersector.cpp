#include "intersect/embree_intersector.h"

#include "math/rounding.h"

#if PATHMARK_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pathmark {

namespace {

// Where the ray meets the triangle's plane, in lengths of its direction. Embree interpolates
// distances by quotients of areas, which loses as many digits as a triangle is longer than high.
float planeDistance(const FlatSceneView& scene, const FlatTriangle& triangle, const Point& origin,
                    const Vector& direction) {
  const Float3& corner = scene.vertices[triangle.vertex[0]];
  const Vector n(triangle.normal[0], triangle.normal[1], triangle.normal[2]);
  return dot(Point(corner[0], corner[1], corner[2]) - origin, n) / dot(direction, n);
}

// What Embree says of a hit.
struct FoundHit {
  std::uint32_t primitive;
  float u, v;
  Vector normal;  // of any length
};

// Which triangle was hit. Along the edge between a quad's halves, where u + v = 1 but for rounding,
// the one with the more similar normal, since that is Embree's own of the half that it has hit.
std::uint32_t triangleOf(const EmbreeIntersector::Scene& scene, const FoundHit& hit) {
  if (!scene.quads) return hit.primitive;
  const std::uint32_t first = scene.quads->firstOf(hit.primitive);
  if (!scene.quads->isPair(hit.primitive)) return first;
  constexpr float kOnEdge = 64.0f * kUnitRoundoff;
  const float beyond = hit.u + hit.v - 1.0f;
  if (std::abs(beyond) > kOnEdge) return beyond > 0.0f ? first + 1 : first;
  const auto likeness = [&](std::uint32_t triangle) {
    const Float3& n = scene.view.triangles[triangle].normal;
    return dot(hit.normal, Vector(n[0], n[1], n[2]));
  };
  return likeness(first + 1) > likeness(first) ? first + 1 : first;
}

Vector normalOf(const RTCFilterFunctionNArguments& arguments, unsigned i) {
  return {RTCHitN_Ng_x(arguments.hit, arguments.N, i), RTCHitN_Ng_y(arguments.hit, arguments.N, i),
          RTCHitN_Ng_z(arguments.hit, arguments.N, i)};
}

// A hit that Embree has found and asks about.
struct Candidate {
  const FlatSceneView& scene;
  const FlatTriangle& triangle;
  Point origin;
  Vector direction;

  Candidate(const RTCFilterFunctionNArguments& arguments, unsigned i)
      : scene(static_cast<const EmbreeIntersector::Scene*>(arguments.geometryUserPtr)->view),
        triangle(scene.triangles[triangleOf(
            *static_cast<const EmbreeIntersector::Scene*>(arguments.geometryUserPtr),
            {RTCHitN_primID(arguments.hit, arguments.N, i),
             RTCHitN_u(arguments.hit, arguments.N, i), RTCHitN_v(arguments.hit, arguments.N, i),
             normalOf(arguments, i)})]),
        origin(RTCRayN_org_x(arguments.ray, arguments.N, i),
               RTCRayN_org_y(arguments.ray, arguments.N, i),
               RTCRayN_org_z(arguments.ray, arguments.N, i)),
        direction(RTCRayN_dir_x(arguments.ray, arguments.N, i),
                  RTCRayN_dir_y(arguments.ray, arguments.N, i),
                  RTCRayN_dir_z(arguments.ray, arguments.N, i)) {}

  // Rays pass through the backs of shapes that say so.
  bool isThere() const {
    const Vector n(triangle.normal[0], triangle.normal[1], triangle.normal[2]);
    return !scene.frontOnly(triangle) || dot(direction, n) < 0.0f;
  }

  // Not put onto the segment by rounding only.
  bool isOnSegment() const {
    const float t = planeDistance(scene, triangle, origin, direction);
    return t > 0.0f && t < 1.0f;
  }
};

void passThroughBacks(const RTCFilterFunctionNArguments* arguments) {
  for (unsigned i = 0; i < arguments->N; ++i)
    if (arguments->valid[i] != 0 && !Candidate(*arguments, i).isThere()) arguments->valid[i] = 0;
}

// Embree works with corners relative to a ray's origin, rounded. That turns a triangle's normal by
// up to a few roundoffs of the scene's size over the triangle's height, and so moves the heights of
// a segment's ends above its plane by this times the scene's size at most. Ends that are higher
// than this are on different sides indeed: no need to look at the triangle, which is seldom in a
// cache.
EmbreeIntersector::Scale scaleOf(const FlatSceneView& scene) {
  constexpr float kRoundoffs = 8.0f;
  float magnitude = 0.0f, lowest = std::numeric_limits<float>::infinity();
  for (const FlatTriangle& triangle : scene.triangles) {
    const std::array<Float3, 3> corners = scene.corners(triangle);
    const auto corner = [&](std::size_t k) {
      return Vector(corners[k][0], corners[k][1], corners[k][2]);
    };
    const Vector a = corner(1) - corner(0), b = corner(2) - corner(0), c = b - a;
    const float longest = std::max({dot(a, a), dot(b, b), dot(c, c)});
    const Vector n = cross(a, b);
    lowest = std::min(lowest, dot(n, n) / longest);
    for (std::size_t k = 0; k < 3; ++k)
      magnitude = std::max(magnitude, largestComponent(corner(k)));
  }
  const float size = 2.0f * magnitude;
  return {size, kRoundoffs * kUnitRoundoff * size * size / std::sqrt(lowest)};
}

bool endsAreHigh(const RTCFilterFunctionNArguments& arguments, unsigned i, float heightError) {
  const Vector n = normalOf(arguments, i);
  const Vector segment(RTCRayN_dir_x(arguments.ray, arguments.N, i),
                       RTCRayN_dir_y(arguments.ray, arguments.N, i),
                       RTCRayN_dir_z(arguments.ray, arguments.N, i));
  const float t = RTCRayN_tfar(arguments.ray, arguments.N, i);
  const float lower = std::min(t, 1.0f - t) * dot(segment, n);
  return lower * lower > heightError * heightError * dot(n, n);
}

void passThroughRounding(const RTCFilterFunctionNArguments* arguments) {
  const auto& scene = *static_cast<const EmbreeIntersector::Scene*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0 || endsAreHigh(*arguments, i, scene.scale.heightError)) continue;
    if (!Candidate(*arguments, i).isOnSegment()) arguments->valid[i] = 0;
  }
}

void passThroughBacksAndRounding(const RTCFilterFunctionNArguments* arguments) {
  passThroughBacks(arguments);
  passThroughRounding(arguments);
}

// Embree reads vertices 16 bytes at a time, and so 4 bytes beyond the last. In a packed scene the
// triangles stand there.
bool hasBytesBehindVertices(const FlatSceneView& view) {
  const std::span<const std::byte> vertices = std::as_bytes(view.vertices);
  const auto* triangles = reinterpret_cast<const std::byte*>(view.triangles.data());
  const auto end = reinterpret_cast<std::uintptr_t>(vertices.data() + vertices.size());
  const auto next = reinterpret_cast<std::uintptr_t>(triangles);
  return next >= end && next - end < 16 && view.triangles.size_bytes() >= 4;
}

void giveVertices(RTCGeometry geometry, const FlatSceneView& view) {
  if (hasBytesBehindVertices(view)) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               view.vertices.data(), 0, sizeof(Float3), view.vertices.size());
    return;
  }
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Float3), view.vertices.size());
  if (vertices != nullptr)
    std::copy(view.vertices.begin(), view.vertices.end(), static_cast<Float3*>(vertices));
}

void giveIndices(RTCGeometry geometry, const EmbreeIntersector::Scene& scene) {
  if (scene.quads) {
    const std::vector<QuadMesh::Quad>& quads = scene.quads->quads();
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, quads.data(),
                               0, sizeof(QuadMesh::Quad), quads.size());
    return;
  }
  const std::span<const FlatTriangle> triangles = scene.view.triangles;
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(),
                             offsetof(FlatTriangle, vertex), sizeof(FlatTriangle),
                             triangles.size());
}

void addTriangles(RTCDevice device, RTCScene scene, const EmbreeIntersector::Scene& triangles) {
  const FlatSceneView& view = triangles.view;
  RTCGeometry geometry =
      rtcNewGeometry(device, triangles.quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
  giveVertices(geometry, view);
  giveIndices(geometry, triangles);
  rtcSetGeometryUserData(geometry, const_cast<EmbreeIntersector::Scene*>(&triangles));
  const bool frontOnly = view.anyFrontOnly();
  if (frontOnly) rtcSetGeometryIntersectFilterFunction(geometry, passThroughBacks);
  rtcSetGeometryOccludedFilterFunction(
      geometry, frontOnly ? passThroughBacksAndRounding : passThroughRounding);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

// A triangle that is alone takes more of a hierarchy as a quad than as a triangle. Nothing large is
// made only to be freed: malloc would then take Embree's blocks from its heap, where they are in no
// large pages.
std::optional<QuadMesh> quadsOf(const FlatSceneView& view) {
  if (4 * countQuads(view) > 3 * view.triangles.size()) return std::nullopt;
  return std::optional<QuadMesh>(std::in_place, view);
}

// Embree does not say what it does with a ray that is no ray.
bool isFinite(const Point& origin, const Vector& direction) {
  return std::isfinite(origin.x + origin.y + origin.z + direction.x + direction.y + direction.z);
}

constexpr float kNearest = std::numeric_limits<float>::min();  // Embree would accept a hit at 0

// Whether the triangle is ahead of the origin by more than rounding can feign. Of rays from far
// outside the scene the errors are larger than its scale tells.
bool isFarAhead(const Ray& ray, float t, const Vector& n, const EmbreeIntersector::Scale& scale) {
  const Vector way = t * ray.direction;
  const float height = dot(way, n);
  return height * height > scale.heightError * scale.heightError * dot(n, n) &&
         dot(way, way) <= scale.size * scale.size;
}

// Returns whether the triangle that Embree has found is ahead of the ray's origin indeed, and only
// then sets `hit`.
bool accept(const EmbreeIntersector::Scene& scene, const Ray& ray, float t, const FoundHit& found,
            PrimitiveHit& hit) {
  const std::uint32_t index = triangleOf(scene, found);
  const bool ahead =
      isFarAhead(ray, t, found.normal, scene.scale) ||
      planeDistance(scene.view, scene.view.triangles[index], ray.origin, ray.direction) > 0.0f;
  if (ahead) hit = {t, index, false};
  return ahead;
}

RTCRay rayFrom(const Point& origin, const Vector& direction, float tMin, float tMax) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tnear = tMin;
  ray.tfar = tMax;
  ray.mask = ~0u;
  return ray;
}

// Rays that Embree traces together, of which it is told that they lie near each other.
template <class Query, std::size_t kSize>
class Packet {
 public:
  Packet() {
    for (unsigned& geometry : query_.hit.geomID) geometry = RTC_INVALID_GEOMETRY_ID;
  }

  void put(std::size_t i, const Ray& ray, float tMax) {
    if (!isFinite(ray.origin, ray.direction)) return;
    valid_[i] = -1;
    query_.ray.org_x[i] = ray.origin.x;
    query_.ray.org_y[i] = ray.origin.y;
    query_.ray.org_z[i] = ray.origin.z;
    query_.ray.dir_x[i] = ray.direction.x;
    query_.ray.dir_y[i] = ray.direction.y;
    query_.ray.dir_z[i] = ray.direction.z;
    query_.ray.tnear[i] = kNearest;
    query_.ray.tfar[i] = tMax;
    query_.ray.mask[i] = ~0u;
  }

  void trace(RTCScene scene) {
#if PATHMARK_EMBREE == 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    if constexpr (kSize == 16)
      rtcIntersect16(valid_.data(), scene, &query_, &arguments);
    else
      rtcIntersect8(valid_.data(), scene, &query_, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    if constexpr (kSize == 16)
      rtcIntersect16(valid_.data(), scene, &context, &query_);
    else
      rtcIntersect8(valid_.data(), scene, &context, &query_);
#endif
  }

  bool meets(std::size_t i) const { return query_.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID; }
  float t(std::size_t i) const { return query_.ray.tfar[i]; }
  FoundHit found(std::size_t i) const {
    const auto& hit = query_.hit;
    return {hit.primID[i], hit.u[i], hit.v[i], Vector(hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i])};
  }

 private:
  Query query_{};
  alignas(64) std::array<int, kSize> valid_{};  // -1: there is a ray
};

using Packet16 = Packet<RTCRayHit16, 16>;
using Packet8 = Packet<RTCRayHit8, 8>;

// The processor's own: others Embree takes apart.
std::size_t packetSizeOf(RTCDevice device) {
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) return 16;
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0) return 8;
  return 1;
}

}  // namespace

void EmbreeIntersector::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void EmbreeIntersector::Release::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

EmbreeIntersector::EmbreeIntersector(const FlatSceneView& scene)
    : triangles_(std::make_unique<Scene>(Scene{scene, quadsOf(scene), scaleOf(scene)})),
      device_(rtcNewDevice(nullptr)) {
  if (!device_) throw std::runtime_error("Embree cannot be started.");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  addTriangles(device_.get(), scene_.get(), *triangles_);
  rtcCommitScene(scene_.get());
  packetSize_ = packetSizeOf(device_.get());
  if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE) {
    throw std::runtime_error("Embree cannot build the scene: error " +
                             std::to_string(static_cast<int>(error)) + ".");
  }
}

EmbreeIntersector::~EmbreeIntersector() = default;

bool EmbreeIntersector::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  if (!isFinite(ray.origin, ray.direction)) return false;
  for (float tMin = kNearest;;) {
    RTCRayHit query{rayFrom(ray.origin, ray.direction, tMin, tMax), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if PATHMARK_EMBREE == 4
    rtcIntersect1(scene_.get(), &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &query);
#endif
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const FoundHit found{query.hit.primID, query.hit.u, query.hit.v,
                         Vector(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z)};
    if (accept(*triangles_, ray, query.ray.tfar, found, hit)) return true;
    // Behind the origin, but for rounding.
    tMin = std::nextafter(query.ray.tfar, std::numeric_limits<float>::infinity());
  }
}

std::uint32_t EmbreeIntersector::closest(std::span<const Ray> rays, std::span<const float> tMax,
                                         std::span<PrimitiveHit> hits) const {
  if (packetSize_ == 16) return closestOfPacket<Packet16>(rays, tMax, hits);
  if (packetSize_ == 8) return closestOfPacket<Packet8>(rays, tMax, hits);
  std::uint32_t met = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (closest(rays[i], tMax[i], hits[i])) met |= 1u << i;
  return met;
}

template <class Packet>
std::uint32_t EmbreeIntersector::closestOfPacket(std::span<const Ray> rays,
                                                 std::span<const float> tMax,
                                                 std::span<PrimitiveHit> hits) const {
  Packet packet;
  for (std::size_t i = 0; i < rays.size(); ++i) packet.put(i, rays[i], tMax[i]);
  packet.trace(scene_.get());
  std::uint32_t met = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!packet.meets(i)) continue;
    // Behind the origin, but for rounding: seldom.
    if (accept(*triangles_, rays[i], packet.t(i), packet.found(i), hits[i]) ||
        closest(rays[i], tMax[i], hits[i]))
      met |= 1u << i;
  }
  return met;
}

bool EmbreeIntersector::occluded(const Point& origin, const Vector& segment) const {
  if (!isFinite(origin, segment)) return false;
  RTCRay ray = rayFrom(origin, segment, kNearest, 1.0f);
#if PATHMARK_EMBREE == 4
  rtcOccluded1(scene_.get(), &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_.get(), &context, &ray);
#endif
  return ray.tfar < 0.0f;
}

SegmentFan::Mask EmbreeIntersector::occluded(const SegmentFan& fan) const {
  SegmentFan::Mask occluded(false);
  for (std::size_t i = 0; i < kLanes; ++i)
    if (fan.lanes[i])
      occluded[i] = this->occluded(fan.origin, {fan.way[0][i], fan.way[1][i], fan.way[2][i]});
  return occluded;
}

void warmUpEmbree() {
  constexpr int kTriangles = 1000;  // enough for several threads
  FlatScene scene;
  scene.materials.emplace_back();
  scene.shapes.emplace_back();
  for (int k = 0; k < kTriangles; ++k) {
    const auto x = static_cast<float>(k);
    scene.addTriangle({Float3{x, 0, 0}, Float3{x + 1, 0, 0}, Float3{x, 1, 0}}, {0, 0, 1}, 0);
  }
  const EmbreeIntersector used(viewOf(scene));
}

}  // namespace pathmark
