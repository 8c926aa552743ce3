#include "bench/raw_embree.h"

#if PATHMARK_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace pathmark::bench {

namespace {

RTCRay rayFrom(const Point& origin, const Vector& direction, float tMax) {
  RTCRay ray;
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tnear = 0.0f;
  ray.tfar = tMax;
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
  return ray;
}

}  // namespace

void RawEmbree::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void RawEmbree::Release::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

RawEmbree::RawEmbree(const FlatSceneView& scene) : device_(rtcNewDevice(nullptr)) {
  if (!device_) throw std::runtime_error("Embree cannot be started.");
  scene_.reset(rtcNewScene(device_.get()));
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Float3), scene.vertices.size());
  if (vertices == nullptr) throw std::runtime_error("Embree has no memory for the vertices.");
  std::copy(scene.vertices.begin(), scene.vertices.end(), static_cast<Float3*>(vertices));
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             scene.triangles.data(), offsetof(FlatTriangle, vertex),
                             sizeof(FlatTriangle), scene.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_.get());
}

bool RawEmbree::closest(const Ray& ray, PrimitiveHit& hit) const {
  RTCRayHit query;
  query.ray = rayFrom(ray.origin, ray.direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if PATHMARK_EMBREE == 4
  rtcIntersect1(scene_.get(), &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_.get(), &context, &query);
#endif
  hit.t = query.ray.tfar;
  hit.index = query.hit.primID;
  hit.isSphere = false;
  return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

bool RawEmbree::occluded(const Point& origin, const Vector& segment) const {
  RTCRay ray = rayFrom(origin, segment, 1.0f);
#if PATHMARK_EMBREE == 4
  rtcOccluded1(scene_.get(), &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_.get(), &context, &ray);
#endif
  return ray.tfar < 0.0f;
}

}  // namespace pathmark::bench
