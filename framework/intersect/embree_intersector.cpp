#include "intersect/embree_intersector.h"

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
#include <span>
#include <stdexcept>
#include <string>

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

// A hit that Embree has found and asks about.
struct Candidate {
  const FlatSceneView& scene;
  const FlatTriangle& triangle;
  Point origin;
  Vector direction;

  Candidate(const RTCFilterFunctionNArguments& arguments, unsigned i)
      : scene(*static_cast<const FlatSceneView*>(arguments.geometryUserPtr)),
        triangle(scene.triangles[RTCHitN_primID(arguments.hit, arguments.N, i)]),
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

void passThroughRounding(const RTCFilterFunctionNArguments* arguments) {
  for (unsigned i = 0; i < arguments->N; ++i)
    if (arguments->valid[i] != 0 && !Candidate(*arguments, i).isOnSegment())
      arguments->valid[i] = 0;
}

// Where no triangle is thin, only hits near an end of the segment are put there by rounding: of
// rays along the surface, whose cosine is below 1e-3, and then within 0.05 of the end. The other
// hits are answered without a look at their triangles, which are seldom in a cache.
void passThroughRoundingAtEnds(const RTCFilterFunctionNArguments* arguments) {
  constexpr float kEnd = 0.125f;
  for (unsigned i = 0; i < arguments->N; ++i) {
    const float t = RTCRayN_tfar(arguments->ray, arguments->N, i);
    if (t > kEnd && t < 1.0f - kEnd) continue;
    if (arguments->valid[i] != 0 && !Candidate(*arguments, i).isOnSegment())
      arguments->valid[i] = 0;
  }
}

void passThroughBacksAndRounding(const RTCFilterFunctionNArguments* arguments) {
  passThroughBacks(arguments);
  passThroughRounding(arguments);
}

// Less than a quarter as high as long.
bool isThin(const std::array<Float3, 3>& corners) {
  constexpr float kThin = 0.25f;
  const auto corner = [&](std::size_t k) {
    return Vector(corners[k][0], corners[k][1], corners[k][2]);
  };
  const Vector a = corner(1) - corner(0), b = corner(2) - corner(0), c = b - a, n = cross(a, b);
  const float longest = std::max({dot(a, a), dot(b, b), dot(c, c)});
  return dot(n, n) < kThin * kThin * longest * longest;
}

RTCFilterFunctionN shadowFilterFor(const FlatSceneView& scene, bool frontOnly) {
  if (frontOnly) return passThroughBacksAndRounding;
  const bool thin = std::any_of(scene.triangles.begin(), scene.triangles.end(),
                                [&](const FlatTriangle& t) { return isThin(scene.corners(t)); });
  return thin ? passThroughRounding : passThroughRoundingAtEnds;
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

void addTriangles(RTCDevice device, RTCScene scene, const FlatSceneView& view) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  giveVertices(geometry, view);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             view.triangles.data(), offsetof(FlatTriangle, vertex),
                             sizeof(FlatTriangle), view.triangles.size());
  rtcSetGeometryUserData(geometry, const_cast<FlatSceneView*>(&view));
  const bool frontOnly = view.anyFrontOnly();
  if (frontOnly) rtcSetGeometryIntersectFilterFunction(geometry, passThroughBacks);
  rtcSetGeometryOccludedFilterFunction(geometry, shadowFilterFor(view, frontOnly));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

// Embree does not say what it does with a ray that is no ray.
bool isFinite(const Point& origin, const Vector& direction) {
  return std::isfinite(origin.x + origin.y + origin.z + direction.x + direction.y + direction.z);
}

constexpr float kNearest = std::numeric_limits<float>::min();  // Embree would accept a hit at 0

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

}  // namespace

void EmbreeIntersector::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void EmbreeIntersector::Release::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

EmbreeIntersector::EmbreeIntersector(const FlatSceneView& scene)
    : view_(std::make_unique<FlatSceneView>(scene)), device_(rtcNewDevice(nullptr)) {
  if (!device_) throw std::runtime_error("Embree cannot be started.");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  addTriangles(device_.get(), scene_.get(), *view_);
  rtcCommitScene(scene_.get());
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
    const FlatTriangle& triangle = view_->triangles[query.hit.primID];
    if (planeDistance(*view_, triangle, ray.origin, ray.direction) > 0.0f) {
      hit = {query.ray.tfar, query.hit.primID, false};
      return true;
    }
    // Behind the origin, but for rounding.
    tMin = std::nextafter(query.ray.tfar, std::numeric_limits<float>::infinity());
  }
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

}  // namespace pathmark
