#include "intersect/flat_intersector.h"

#include "intersect/plane_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pathmark {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Float3 kNowhere{std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::quiet_NaN()};

}  // namespace

// The shear that turns the ray into the unit vector along its largest axis: a vertex is then
// tested by its x and y alone. kx and ky are swapped for negative directions, so that triangles
// keep their orientation.
struct FlatIntersector::Shear {
  int kx, ky, kz;
  float ox, oy, oz;
  float sx, sy, sz;

  Shear(const Point& origin, const Vector& direction) {
    const Vector a = glm::abs(direction);
    kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (direction[kz] < 0.0f) std::swap(kx, ky);
    ox = origin[kx];
    oy = origin[ky];
    oz = origin[kz];
    sx = direction[kx] / direction[kz];
    sy = direction[ky] / direction[kz];
    sz = 1.0f / direction[kz];
  }
};

FlatIntersector::FlatIntersector(const FlatSceneView& scene)
    : blocks_((scene.triangles.size() + kLanes - 1) / kLanes) {
  for (std::size_t i = 0; i < blocks_.size() * kLanes; ++i) {
    TriangleBlock& block = blocks_[i / kLanes];
    const std::size_t lane = i % kLanes;
    const bool present = i < scene.triangles.size();
    const auto corners =
        present ? scene.corners(scene.triangles[i]) : std::array<Float3, 3>{kNowhere, kNowhere};
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis)
        block.vertex[corner][axis][lane] = corners[corner][axis];
    const bool frontOnly = present && scene.shapes[scene.triangles[i].shape].frontOnly != 0;
    block.smallestArea[lane] = frontOnly ? 0.0f : -kInfinity;
  }
  for (const FlatTriangle& t : scene.triangles) {
    thin_.push_back(isThin(scene.corners(t)));
    anyThin_ = anyThin_ || thin_.back();
  }
  for (const FlatSphere& s : scene.spheres) {
    const bool frontOnly = scene.shapes[s.shape].frontOnly != 0, inward = s.inward != 0;
    spheres_.push_back({Point(s.centre[0], s.centre[1], s.centre[2]), s.radius, frontOnly && inward,
                        frontOnly && !inward});
  }
}

// Sets t of each lane to its hit in (tMin, tMax), or to infinity. Written without branches over
// plain arrays, which the compiler turns into vector instructions.
void FlatIntersector::intersectBlock(const TriangleBlock& block, const Shear& r, float tMin,
                                     float tMax, float (&t)[kLanes]) {
  const auto& a = block.vertex[0];
  const auto& b = block.vertex[1];
  const auto& c = block.vertex[2];
  for (int i = 0; i < kLanes; ++i) {
    const float az = a[r.kz][i] - r.oz, bz = b[r.kz][i] - r.oz, cz = c[r.kz][i] - r.oz;
    const float ax = (a[r.kx][i] - r.ox) - r.sx * az, ay = (a[r.ky][i] - r.oy) - r.sy * az;
    const float bx = (b[r.kx][i] - r.ox) - r.sx * bz, by = (b[r.ky][i] - r.oy) - r.sy * bz;
    const float cx = (c[r.kx][i] - r.ox) - r.sx * cz, cy = (c[r.ky][i] - r.oy) - r.sy * cz;
    const float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    const float area = u + v + w;
    const float distance = r.sz * (u * az + v * bz + w * cz) / area;
    const bool sameSide =
        ((u >= 0.0f) & (v >= 0.0f) & (w >= 0.0f)) | ((u <= 0.0f) & (v <= 0.0f) & (w <= 0.0f));
    const bool hit = sameSide & (area != 0.0f) & (area > block.smallestArea[i]) &
                     (distance > tMin) & (distance < tMax);
    t[i] = hit ? distance : kInfinity;
  }
}

// The discriminant comes from the distance of the line to the centre, and the smaller root from
// the product of both: neither cancels for far or large spheres (Haines et al., "Precision
// Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7, 2019).
float FlatIntersector::intersectSphere(const SphereRecord& sphere, const Point& origin,
                                       const Vector& direction, float tMax) {
  const Vector f = origin - sphere.centre;
  const float a = dot(direction, direction), b = -dot(f, direction);
  const Vector toLine = f + (b / a) * direction;
  const float discriminant = sphere.radius * sphere.radius - dot(toLine, toLine);
  if (!(discriminant > 0.0f)) return kInfinity;
  const float d = length(f);
  const float c = (d - sphere.radius) * (d + sphere.radius);
  const float q = b + std::copysign(std::sqrt(a * discriminant), b);
  const float near = std::min(c / q, q / a), far = std::max(c / q, q / a);
  if (near > 0.0f && near < tMax && !sphere.hideOutside) return near;
  if (far > 0.0f && far < tMax && !sphere.hideInside) return far;
  return kInfinity;
}

std::array<Float3, 3> FlatIntersector::corners(std::uint32_t triangle) const {
  const TriangleBlock& block = blocks_[triangle / kLanes];
  std::array<Float3, 3> result{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[corner][axis] = block.vertex[corner][axis][triangle % kLanes];
  return result;
}

Vector FlatIntersector::barycentrics(std::uint32_t triangle, const Shear& r) const {
  const TriangleBlock& block = blocks_[triangle / kLanes];
  const std::uint32_t lane = triangle % kLanes;
  float x[3], y[3];
  for (int corner = 0; corner < 3; ++corner) {
    const float z = block.vertex[corner][r.kz][lane] - r.oz;
    x[corner] = (block.vertex[corner][r.kx][lane] - r.ox) - r.sx * z;
    y[corner] = (block.vertex[corner][r.ky][lane] - r.oy) - r.sy * z;
  }
  const Vector areas(x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2],
                     x[1] * y[0] - y[1] * x[0]);
  return areas / (areas.x + areas.y + areas.z);
}

bool FlatIntersector::nearest(const Ray& ray, const Shear& shear, float tMin,
                              PrimitiveHit& hit) const {
  float best[kLanes];
  std::uint32_t bestBlock[kLanes] = {};
  for (float& t : best) t = kInfinity;
  for (std::uint32_t k = 0; k < blocks_.size(); ++k) {
    float t[kLanes];
    intersectBlock(blocks_[k], shear, tMin, kInfinity, t);
    for (int i = 0; i < kLanes; ++i) {
      bestBlock[i] = t[i] < best[i] ? k : bestBlock[i];
      best[i] = t[i] < best[i] ? t[i] : best[i];
    }
  }
  hit.t = kInfinity;
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    if (best[i] < hit.t) {
      hit.t = best[i];
      hit.index = bestBlock[i] * kLanes + i;
      hit.isSphere = false;
    }
  }
  for (std::uint32_t k = 0; k < spheres_.size(); ++k) {
    const float t = intersectSphere(spheres_[k], ray.origin, ray.direction, hit.t);
    if (t < hit.t) {
      hit.t = t;
      hit.index = k;
      hit.isSphere = true;
    }
  }
  return hit.t < kInfinity;
}

// Nothing lies between the origin and a hit that turns out to be behind it.
bool FlatIntersector::closest(const Ray& ray, PrimitiveHit& hit) const {
  const Shear shear(ray.origin, ray.direction);
  float tMin = 0.0f;
  while (nearest(ray, shear, tMin, hit)) {
    if (hit.isSphere) return true;
    if (!thin_[hit.index] || planeDistance(corners(hit.index), ray.origin, ray.direction) > 0.0) {
      hit.barycentric = barycentrics(hit.index, shear);
      return true;
    }
    tMin = hit.t;
  }
  return false;
}

bool FlatIntersector::occluded(const Point& origin, const Vector& segment) const {
  for (const SphereRecord& sphere : spheres_)
    if (intersectSphere(sphere, origin, segment, 1.0f) < kInfinity) return true;
  const Shear shear(origin, segment);
  for (std::uint32_t k = 0; k < blocks_.size(); ++k) {
    float t[kLanes];
    intersectBlock(blocks_[k], shear, 0.0f, 1.0f, t);
    float nearest = kInfinity;
    for (const float lane : t) nearest = std::min(nearest, lane);
    if (!(nearest < kInfinity)) continue;
    if (!anyThin_) return true;
    for (std::uint32_t i = 0; i < kLanes; ++i) {
      if (!(t[i] < kInfinity)) continue;
      if (!thin_[k * kLanes + i]) return true;
      const double exact = planeDistance(corners(k * kLanes + i), origin, segment);
      if (exact > 0.0 && exact < 1.0) return true;
    }
  }
  return false;
}

}  // namespace pathmark
