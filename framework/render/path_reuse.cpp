#include "render/path_reuse.h"

#include "render/camera_rays.h"
#include "render/first_surface.h"
#include "render/radiance.h"
#include "render/ray_count.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark {

namespace {

// Keep the paths' numbers apart from the camera rays', which are made of the same seeds.
constexpr std::uint64_t kDirectStream = 0x646972656374ull, kStream = 0x72657573656dull;

}  // namespace

struct PathReuse::Path {
  Hit first, second;
  Vector wo;                 // at the first surface, towards the eye
  bool meetsFirst = false;   // the camera ray meets a surface
  bool meetsSecond = false;  // and the path one after that
  Vector wi;                 // at the first surface, towards the second
  float pdf = 0.0f;          // of wi, per solid angle
  Colour light;              // radiance that leaves the second surface towards the first
  bool lightsAll = false;    // the same light leaves towards the other pixels

  Colour indirectLight() const {
    return first.brdf->brdf(wo, wi, first.n) * (dot(first.n, wi) / pdf) * light;
  }
};

struct PathReuse::Pixel {
  std::unique_ptr<PixelSampler> rays, directPaths, paths;
  glm::dvec3 sum{0.0};
  Path path;

  // Of its first surface, as a receiver of what comes from a second one.
  Colour response;  // BRDF times G
};

PathReuse::PathReuse(const SceneCore& core, const RenderJob& job, const SimpleCamera& camera)
    : core_(core),
      job_(job),
      camera_(camera),
      direct_(core, std::min(core.maxBounces(), 1)),
      rest_(core, std::max(core.maxBounces() - 1, 0)),
      cameraRays_(job.sharing.pixels),
      pixels_(job.sharing.pixels),
      receivers_(job.sharing.pixels) {
  const auto sampler = [&](std::uint64_t stream, std::uint32_t perRay) {
    return makePixelSampler(job.sampler, mix(job.seed ^ stream), job.raysPerPass * perRay);
  };
  for (Pixel& pixel : pixels_) {
    pixel.rays = makePixelSampler(job.sampler, job.seed, job.raysPerPass);
    pixel.directPaths = sampler(kDirectStream, job.sharing.directPaths);
    pixel.paths = sampler(kStream, job.sharing.pixels);
  }
}

PathReuse::~PathReuse() = default;

// The directions of all pixels are one set of well spread points, of which each has a part that is
// well spread by itself: `rays` that follow each other.
void PathReuse::render(const PixelBlock& block, std::uint64_t raysBefore, std::uint32_t rays,
                       std::span<Colour> means, ThreadSlot& slot) {
  const std::span<Pixel> pixels = std::span(pixels_).first(block.count());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    Pixel& pixel = pixels[k];
    pixel.sum = glm::dvec3(0.0);
    pixel.rays->startPixel(block.column(k), block.row(k), raysBefore);
    pixel.directPaths->startPixel(block.column(k), block.row(k),
                                  raysBefore * job_.sharing.directPaths);
    pixel.paths->startPixel(block.left, block.top, raysBefore * job_.sharing.pixels);
  }
  // Of a larger block before this one.
  for (std::size_t k = pixels.size(); k < pixels_.size(); ++k) receivers_.takeAway(k);
  for (int m = 0; m < static_cast<int>(rays); ++m) {
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      Sampler& sampler = *pixels[k].rays;
      sampler.startRay(m);
      cameraRays_[k] = cameraRay(camera_, block.column(k), block.row(k), m, static_cast<int>(rays),
                                 sampler.next2D());
    }
    meetFirst(pixels);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      slot.column.store(block.column(k), std::memory_order_relaxed);
      slot.row.store(block.row(k), std::memory_order_relaxed);
      trace(cameraRays_[k], m, k, pixels[k]);
    }
    for (std::size_t k = 0; k < pixels.size(); ++k)
      if (pixels[k].path.lightsAll) giveToAll(k, pixels);
  }
  for (std::size_t k = 0; k < pixels.size(); ++k)
    means[k] = Colour(pixels[k].sum / static_cast<double>(rays));
}

// And what the first surface emits.
Colour PathReuse::directLight(const Ray& cameraRay, int m, const Hit& first, Pixel& pixel) const {
  const auto paths = static_cast<int>(job_.sharing.directPaths);
  Colour sum(0.0f);
  for (int d = 0; d < paths; ++d) {
    pixel.directPaths->startPath(m * paths + d);
    beginWithSurface(first, false);
    sum += direct_.tracePath(cameraRay, *pixel.directPaths);
  }
  beginAnywhere();
  return sum / static_cast<float>(paths);
}

void PathReuse::meetFirst(std::span<Pixel> pixels) {
  countRaysOfThisThread(pixels.size());
  for (std::size_t begin = 0; begin < pixels.size(); begin += core_.packetSize()) {
    const std::size_t count = std::min(core_.packetSize(), pixels.size() - begin);
    std::array<Hit, kMostInPacket> hits;
    const std::uint32_t met = core_.intersect(std::span(cameraRays_).subspan(begin, count), hits);
    for (std::size_t i = 0; i < count; ++i) {
      Path& path = pixels[begin + i].path;
      path.meetsFirst = (met >> i & 1u) != 0;
      if (path.meetsFirst) path.first = hits[i];
    }
  }
}

void PathReuse::trace(const Ray& cameraRay, int m, std::size_t k, Pixel& pixel) {
  Path& path = pixel.path;
  path.meetsSecond = path.lightsAll = false;
  if (!path.meetsFirst) {
    receivers_.takeAway(k);
    return;
  }
  receivers_.put(k, path.first);
  path.wo = -cameraRay.direction;
  pixel.sum += directLight(cameraRay, m, path.first, pixel);
  if (core_.maxBounces() <= 1) return;
  pixel.paths->startPath(static_cast<int>(k * job_.raysPerPass) + m);
  findSecond(path, *pixel.paths);
  if (path.meetsSecond && !path.lightsAll) pixel.sum += path.indirectLight();
}

void PathReuse::findSecond(Path& path, Sampler& sampler) const {
  const Hit& x = path.first;
  const vec2 st = sampler.next2D();
  const DirectionSample next = x.brdf->reflection(path.wo, x.n, st.x, st.y, sampler.next1D());
  if (next.pdf == 0.0f) return;
  const Ray ray = x.spawnRay(next.wi);
  countRaysOfThisThread(1);
  Hit& y = path.second;
  if (!core_.intersect(ray, y)) return;
  // The direct light of the first surface has counted what this one emits.
  y.emission = Colour(0.0f);
  y.light = nullptr;
  beginWithSurface(y, false);
  path.light = rest_.tracePath(ray, sampler);
  beginAnywhere();
  path.meetsSecond = path.light != Colour(0.0f);
  path.wi = next.wi;
  path.pdf = next.pdf;
  // What a student's function returns may be no radiance: then it stays with its own pixel.
  path.lightsAll = path.meetsSecond && isRadiance(path.light) &&
                   core_.lobesOf(*y.brdf).shares().specular == 0.0f && dot(y.n, next.wi) < 0.0f;
}

void PathReuse::giveToAll(std::size_t from, std::span<Pixel> pixels) {
  Pixel& giver = pixels[from];
  const Hit& y = giver.path.second;
  countRaysOfThisThread(receivers_.look(core_, y, from));
  float density = 0.0f;  // of y, per unit area, by all paths
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    Pixel& pixel = pixels[k];
    const Path& path = pixel.path;
    const Hit& x = path.first;
    pixel.response = Colour(0.0f);
    if (k == from) {
      const Vector way = y.p - x.p;
      const float perArea = -dot(y.n, path.wi) / dot(way, way);
      density += path.pdf * perArea;
      pixel.response = x.brdf->brdf(path.wo, path.wi, x.n) * (dot(x.n, path.wi) * perArea);
    } else if (receivers_.sees(k)) {
      const Vector wi = receivers_.wi(k);
      const float perArea = receivers_.perArea(k);
      density += x.brdf->pdf(path.wo, wi, x.n) * perArea;
      pixel.response = x.brdf->brdf(path.wo, wi, x.n) * (receivers_.cosX(k) * perArea);
    }
  }
  // Surfaces so near that the density overflows, or one that a student's function got wrong.
  if (!(density > 0.0f && std::isfinite(density))) {
    giver.sum += giver.path.indirectLight();
    return;
  }
  const Colour light = giver.path.light / density;
  for (Pixel& pixel : pixels) pixel.sum += glm::dvec3(pixel.response * light);
}

}  // namespace pathmark
