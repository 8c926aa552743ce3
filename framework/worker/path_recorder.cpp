#include "worker/path_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark {

namespace {

thread_local PathRecorder* recorder = nullptr;

void put(float (&to)[3], const vec3& from) {
  for (int k = 0; k < 3; ++k) to[k] = from[k];
}

// Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997; in double, for a
// picture and not for marks.
double distanceTo(const Triangle& triangle, const Ray& ray) {
  using glm::dvec3;
  const dvec3 corner = triangle.positions[0], d = ray.direction;
  const dvec3 e1 = dvec3(triangle.positions[1]) - corner,
              e2 = dvec3(triangle.positions[2]) - corner;
  const dvec3 p = glm::cross(d, e2), s = dvec3(ray.origin) - corner, q = glm::cross(s, e1);
  const double determinant = glm::dot(e1, p);
  const double u = glm::dot(s, p) / determinant, v = glm::dot(d, q) / determinant;
  const double t = glm::dot(e2, q) / determinant;
  const bool met = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0;
  return met ? t : std::numeric_limits<double>::infinity();
}

}  // namespace

PathEvent pathEvent(PathEventKind kind, const vec3& a, const vec3& b, const vec3& c) {
  PathEvent event;
  event.kind = kind;
  put(event.a, a);
  put(event.b, b);
  put(event.c, c);
  return event;
}

// A material that tells what it is asked, and what it answers.
class PathRecorder::Material final : public BRDF {
 public:
  Material(PathRecorder& told, const BRDF& real, std::int32_t index)
      : told_(told), real_(real), index_(index) {}

  const BRDF& real() const { return real_; }
  std::int32_t index() const { return index_; }

  Colour brdf(const Vector& wo, const Vector& wi, const Vector& n) const override {
    const Colour f = real_.brdf(wo, wi, n);
    told_.add(pathEvent(PathEventKind::kBrdf, wo, wi, f));
    return f;
  }

  float pdf(const Vector& wo, const Vector& wi, const Vector& n) const override {
    PathEvent event = pathEvent(PathEventKind::kPdf, wo, wi);
    event.x = real_.pdf(wo, wi, n);
    told_.add(event);
    return event.x;
  }

  DirectionSample reflection(const Vector& wo, const Vector& n, float s, float t,
                             float u) const override {
    const DirectionSample sample = real_.reflection(wo, n, s, t, u);
    PathEvent event = pathEvent(PathEventKind::kReflection, wo, sample.wi, n);
    event.x = sample.pdf;
    told_.add(event);
    return sample;
  }

 private:
  PathRecorder& told_;
  const BRDF& real_;
  std::int32_t index_;
};

PathRecorder::PathRecorder(const SceneCore& core, bool filtered)
    : core_(core), filtered_(filtered) {
  for (std::size_t i = 0; i < core.materialCount(); ++i) {
    addMaterial(core.material(i), i);
    const MaterialLobes& lobes = core.lobes(i);
    if (!filtered || !lobes.shares().hasBoth()) continue;
    for (const Lobe lobe : {Lobe::kDiffuse, Lobe::kSpecular}) {
      addMaterial(lobes.alone(lobe), i);
      addMaterial(lobes.overShare(lobe), i);
    }
  }
  std::sort(materials_.begin(), materials_.end(),
            [](const auto& a, const auto& b) { return std::less<>()(&a->real(), &b->real()); });
}

void PathRecorder::addMaterial(const BRDF& real, std::size_t index) {
  materials_.push_back(std::make_unique<Material>(*this, real, static_cast<std::int32_t>(index)));
}

PathRecorder::~PathRecorder() = default;

PathRecorder* PathRecorder::ofThisThread() { return recorder; }

void PathRecorder::useForThisThread() { recorder = this; }

// A path has room for two events at least, its first and its last.
void PathRecorder::beginPath(const Ray& ray) {
  if (depth_++ > 0) return;
  ++paths_;
  recording_ = events_.size() + 2 <= kMostPathEvents;
  first_ = events_.size();
  dropped_ = 0;
  lastRay_.reset();
  left_ = 0;
  add(pathEvent(PathEventKind::kPath, ray.origin, ray.direction));
}

void PathRecorder::endPath(const Colour& radiance) {
  if (--depth_ > 0) return;
  if (!recording_) return;
  PathEvent event = pathEvent(PathEventKind::kRadiance, radiance);
  event.integer = dropped_;
  events_.push_back(event);
  recording_ = false;
}

void PathRecorder::add(const PathEvent& event) {
  if (!recording_) return;
  const bool room =
      events_.size() - first_ + 1 < kMostEventsOfAPath && events_.size() + 1 < kMostPathEvents;
  if (room)
    events_.push_back(event);
  else
    dropped_ += dropped_ < std::numeric_limits<std::int32_t>::max() ? 1 : 0;
}

void PathRecorder::meet(const Ray& ray, Hit& hit) {
  const auto material = std::lower_bound(
      materials_.begin(), materials_.end(), hit.brdf,
      [](const auto& m, const BRDF* brdf) { return std::less<>()(&m->real(), brdf); });
  if (material == materials_.end() || &(*material)->real() != hit.brdf) return;
  PathEvent event = pathEvent(PathEventKind::kHit, hit.p, hit.n, hit.emission);
  put(event.d, ray.origin);
  event.integer = (*material)->index();
  add(event);
  hit.brdf = material->get();
}

void PathRecorder::miss(const Ray& ray) {
  PathEvent event = pathEvent(PathEventKind::kMiss, ray.origin, ray.direction);
  Hit hit;
  event.flag = filtered_ && core_.intersect(ray, hit) ? 1 : 0;
  add(event);
}

void PathRecorder::shadowRay(const Hit& from, const LightSample& to, bool visible) {
  PathEvent event = pathEvent(PathEventKind::kShadowRay, from.p, to.p, to.p);
  event.flag = visible ? 1 : 0;
  const Vector way = to.p - from.p;
  Hit blocker;
  if (!visible && core_.intersect(from.spawnRay(normalize(way)), blocker) &&
      dot(blocker.p - from.p, way) < dot(way, way))
    put(event.c, blocker.p);
  else if (!visible && filtered_)
    event.integer = 1;
  add(event);
}

// The density 1 / (2 pi), and a diffuse surface.
void PathRecorder::leave(const Point& p, const Triangle& triangle, const Ray& next) {
  if (!recording_) return;
  PathEvent hit = pathEvent(PathEventKind::kHit, p, triangle.normal, triangle.emission);
  put(hit.d, lastRay_ ? lastRay_->origin
                      : Point(events_[first_].a[0], events_[first_].a[1], events_[first_].a[2]));
  hit.integer = -1;
  add(hit);
  PathEvent drawn =
      pathEvent(PathEventKind::kReflection, vec3(0.0f), next.direction, triangle.normal);
  drawn.x = 0.5f * kInvPi;
  add(drawn);
  add(pathEvent(PathEventKind::kBrdf, vec3(0.0f), next.direction, triangle.colour * kInvPi));
  lastRay_ = next;
  ++left_;
}

void PathRecorder::meetLast(const Ray& cameraRay) {
  if (!recording_ || left_ >= MAX_PATH_LENGTH) return;
  if (warmUp_.empty()) warmUp_ = core_.warmUpTriangles();
  const Ray ray = lastRay_.value_or(cameraRay);
  const Triangle* nearest = nullptr;
  double distance = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : warmUp_)
    if (const double t = distanceTo(triangle, ray); t < distance) {
      distance = t;
      nearest = &triangle;
    }
  if (nearest == nullptr) return add(pathEvent(PathEventKind::kMiss, ray.origin, ray.direction));
  PathEvent hit =
      pathEvent(PathEventKind::kHit, glm::dvec3(ray.origin) + distance * glm::dvec3(ray.direction),
                nearest->normal, nearest->emission);
  put(hit.d, ray.origin);
  hit.integer = -1;
  add(hit);
}

}  // namespace pathmark
