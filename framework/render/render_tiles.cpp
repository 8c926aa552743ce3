#include "render/render_tiles.h"

#include "render/camera_hits.h"
#include "render/camera_rays.h"
#include "render/path_filter.h"
#include "render/path_reuse.h"
#include "render/ray_count.h"
#include "render/split_paths.h"
#include "sampling/pixel_sampler.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>
#include <vector>

#include <unistd.h>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace pathmark {

namespace {

// Throughputs of long paths become denormal numbers, which are slow and carry no light.
void flushDenormalsToZero() {
#if defined(__SSE__)
  constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  _mm_setcsr(_mm_getcsr() | kFlushToZero | kDenormalsAreZero);
#endif
}

class PixelRenderer {
 public:
  PixelRenderer(const SceneCore& core, const RenderJob& job, const SimpleCamera& camera)
      : camera_(camera),
        job_(job),
        scene_(core, core.maxBounces()),
        sampler_(makePixelSampler(job.sampler, job.seed, job.raysPerPass)) {
    if (job.estimator == Estimator::kWarmUp)
      warmUp_ = core.warmUpTriangles();
    else if (job.paths.filters())
      filter_ = std::make_unique<PathFilter>(core, job.paths, camera.eye(), job.seed);
    if (job.estimator == Estimator::kSplit) split_ = std::make_unique<SplitPaths>(core, job);
    filterPathsOfThisThread(filter_.get());
    const bool asksForCameraRays =
        job.estimator != Estimator::kWarmUp && job.estimator != Estimator::kReuse;
    if (core.packetSize() > 1 && asksForCameraRays && !filter_) cameraHits_.emplace(core);
    cameraHitsOfThisThread(cameraHits_ ? &*cameraHits_ : nullptr);
  }
  ~PixelRenderer() {
    cameraHitsOfThisThread(nullptr);
    filterPathsOfThisThread(nullptr);
  }
  PixelRenderer(const PixelRenderer&) = delete;
  PixelRenderer& operator=(const PixelRenderer&) = delete;

  Colour render(int i, int j, std::uint64_t firstRay, std::uint32_t rays) {
    sampler_->startPixel(i, j, firstRay);
    if (filter_) filter_->startPixel(i, j, firstRay);
    if (split_) split_->startPixel(i, j, firstRay);
    switch (job_.estimator) {
      case Estimator::kWarmUp:
        return meanOf(i, j, rays, [&](const Ray& ray, int) { return warmUp(ray); });
      case Estimator::kMis:
        return meanOf(i, j, rays,
                      [&](const Ray& ray, int) { return scene_.tracePathMIS(ray, *sampler_); });
      case Estimator::kSplit:
        return meanOf(i, j, rays,
                      [&](const Ray& ray, int m) { return split_->radiance(ray, m, *sampler_); });
      default:
        traceAhead(rays, [&](int m) { return rayOfRenderPixel(i, j, m, rays); });
        // A renderPixel that forgets to start its rays is to find the same numbers in any scene.
        if (cameraHits_) sampler_->startPixel(i, j, firstRay);
        return scene_.renderPixel(i, j, camera_, static_cast<int>(rays), *sampler_);
    }
  }

 private:
  // By the framework's own camera rays: what renderPixel calls is tracePath, and nothing else.
  template <class Radiance>
  Colour meanOf(int i, int j, std::uint32_t rays, Radiance radiance) {
    const auto ray = [&](int m) {
      sampler_->startRay(m);
      return cameraRay(camera_, i, j, m, static_cast<int>(rays), sampler_->next2D());
    };
    traceAhead(rays, ray);
    glm::dvec3 sum(0.0);
    for (int m = 0; m < static_cast<int>(rays); ++m) {
      const Ray next = ray(m);
      sum += radiance(next, m);
    }
    return sum / static_cast<double>(rays);
  }

  // The m-th that the coursework's renderPixel will make, if it is as in part 1.
  Ray rayOfRenderPixel(int i, int j, int m, std::uint32_t rays) {
    sampler_->startRay(m);
    const vec2 st = sampler_->next2D();
    const int n = static_cast<int>(std::sqrt(static_cast<double>(rays)));
    return m < n * n ? camera_.StratifiedRandomRay(i, j, m % n, m / n, n, st.x, st.y)
                     : camera_.StratifiedRandomRay(i, j, 0, 0, 1, st.x, st.y);
  }

  template <class RayOf>
  void traceAhead(std::uint32_t rays, RayOf rayOf) {
    if (!cameraHits_) return;
    raysAhead_.clear();
    for (int m = 0; m < static_cast<int>(rays); ++m) raysAhead_.push_back(rayOf(m));
    cameraHits_->trace(raysAhead_);
  }

  // Needs part 0 only.
  Colour warmUp(const Ray& ray) {
    uvec2 seed(sampler_->next2D() * 0x1p24f);
    countRaysOfThisThread(1);
    return get_ray_radiance(ray.origin, ray.direction, Mesh{warmUp_}, seed);
  }

  const SimpleCamera& camera_;
  const RenderJob& job_;
  LitScene scene_;
  std::unique_ptr<PixelSampler> sampler_;
  std::vector<Triangle> warmUp_;
  std::unique_ptr<PathFilter> filter_;    // null: all light is let through
  std::unique_ptr<SplitPaths> split_;     // null: no paths are split
  std::optional<CameraHits> cameraHits_;  // none: camera rays are traced one by one
  std::vector<Ray> raysAhead_;
};

// Adds a pass of a pixel to the film, unless it is no radiance.
void addToFilm(const Colour& mean, std::uint32_t rays, std::uint64_t pixel, FilmPixel& film,
               InvalidPixels& invalid) {
  const bool nan = std::isnan(mean.r) || std::isnan(mean.g) || std::isnan(mean.b);
  const bool infinite = std::isinf(mean.r) || std::isinf(mean.g) || std::isinf(mean.b);
  const bool negative = mean.r < 0.0f || mean.g < 0.0f || mean.b < 0.0f;
  if (nan || infinite || negative) {
    ++(nan ? invalid.nan : infinite ? invalid.infinite : invalid.negative);
    invalid.firstPixel = std::min(invalid.firstPixel, pixel);
    return;
  }
  for (int c = 0; c < 3; ++c) film.sum[c] += static_cast<double>(mean[c]) * rays;
  film.rays += rays;
}

struct Tile {
  int left, top, right, bottom;

  // Of the image, row by row.
  std::size_t index(int imageWidth) const {
    const auto tiles = [](int pixels) { return static_cast<std::size_t>(pixels / kTileSize); };
    return tiles(top) * tiles(imageWidth + kTileSize - 1) + tiles(left);
  }
};

// The tiles of a region, row by row, each given out once.
class Tiles {
 public:
  Tiles(const PixelRegion& region, const SimpleCamera& camera)
      : left_(std::clamp(region.left, 0, camera.width())),
        top_(std::clamp(region.top, 0, camera.height())),
        right_(end(left_, region.left, region.width, camera.width())),
        bottom_(end(top_, region.top, region.height, camera.height())),
        columns_((right_ - left_ + kTileSize - 1) / kTileSize),
        count_(columns_ * ((bottom_ - top_ + kTileSize - 1) / kTileSize)) {}

  bool take(Tile& tile) {
    const int index = next_.fetch_add(1, std::memory_order_relaxed);
    if (index >= count_) return false;
    const int left = left_ + index % columns_ * kTileSize;
    const int top = top_ + index / columns_ * kTileSize;
    tile = {left, top, std::min(left + kTileSize, right_), std::min(top + kTileSize, bottom_)};
    return true;
  }

 private:
  static int end(int clampedStart, int start, int length, int size) {
    const std::int64_t end = std::int64_t{start} + std::max(length, 0);
    return static_cast<int>(std::clamp<std::int64_t>(end, clampedStart, size));
  }

  int left_, top_, right_, bottom_;
  int columns_, count_;
  std::atomic<int> next_{0};
};

// What one thread renders with. Tiles are made of blocks of pixels that are rendered together: of
// one pixel, where pixels share nothing.
class TileRenderer {
 public:
  TileRenderer(const SceneCore& core, const RenderJob& job, const SimpleCamera& camera,
               std::span<FilmPixel> film, const ProgressBoard& board, ThreadSlot& slot)
      : job_(job),
        width_(camera.width()),
        film_(film),
        board_(board),
        slot_(slot),
        pixel_(core, job, camera),
        means_(job.sharing.pixels) {
    if (job.estimator == Estimator::kReuse) reuse_ = std::make_unique<PathReuse>(core, job, camera);
  }

  // So many rays of each pixel. Returns false when the host has asked to stop.
  bool render(const Tile& tile, std::uint64_t rays) {
    const PixelBlock shape = blockOf(job_.sharing.pixels);
    // Blocks lie on the grid of the image; those at the edge of a tile are cut off there.
    for (int j = tile.top / shape.height * shape.height; j < tile.bottom; j += shape.height)
      for (int i = tile.left / shape.width * shape.width; i < tile.right; i += shape.width) {
        const int left = std::max(i, tile.left), top = std::max(j, tile.top);
        const PixelBlock block{left, top, std::min(i + shape.width, tile.right) - left,
                               std::min(j + shape.height, tile.bottom) - top};
        if (!renderPasses(block, rays)) return false;
      }
    return true;
  }

  const InvalidPixels& invalid() const { return invalid_; }

 private:
  bool renderPasses(const PixelBlock& block, std::uint64_t raysOfJob) {
    slot_.column.store(block.left, std::memory_order_relaxed);
    slot_.row.store(block.top, std::memory_order_relaxed);
    for (std::uint64_t done = 0; done < raysOfJob; done += job_.raysPerPass) {
      if (board_.cancel.load(std::memory_order_relaxed) != 0) return false;
      const auto rays =
          static_cast<std::uint32_t>(std::min<std::uint64_t>(job_.raysPerPass, raysOfJob - done));
      if (reuse_)
        reuse_->render(block, job_.firstRay + done, rays, means_, slot_);
      else
        means_[0] = pixel_.render(block.left, block.top, job_.firstRay + done, rays);
      for (std::size_t k = 0; k < block.count(); ++k) {
        const auto pixel =
            static_cast<std::uint64_t>(block.row(k)) * static_cast<std::uint64_t>(width_) +
            static_cast<std::uint64_t>(block.column(k));
        addToFilm(means_[k], rays, pixel, film_[pixel], invalid_);
      }
      slot_.pixelsDone.fetch_add(block.count(), std::memory_order_relaxed);
      slot_.raysTraced.store(raysOfThisThread(), std::memory_order_relaxed);
    }
    return true;
  }

  const RenderJob& job_;
  int width_;
  std::span<FilmPixel> film_;
  const ProgressBoard& board_;
  ThreadSlot& slot_;
  PixelRenderer pixel_;
  std::unique_ptr<PathReuse> reuse_;  // null: pixels share nothing
  std::vector<Colour> means_;         // of a block
  InvalidPixels invalid_;
};

}  // namespace

SimpleCamera cameraOf(const SceneCore& scene, const RenderJob& job) {
  return job.ownCamera != 0 ? makeCamera(job.camera) : scene.camera();
}

RenderResult renderTiles(const SceneCore& scene, const RenderJob& job, std::span<FilmPixel> film,
                         ProgressBoard& board, const std::function<void()>& onThreadStart,
                         std::span<const std::uint64_t> tileRays) {
  const SimpleCamera camera = cameraOf(scene, job);
  const int width = camera.width();
  Tiles tiles(job.region, camera);
  std::vector<InvalidPixels> invalid(job.threads);

  const auto work = [&](std::uint32_t index) {
    flushDenormalsToZero();
    onThreadStart();
    restartRayCount();
    ThreadSlot& slot = board.threads[index];
    slot.threadId.store(static_cast<std::int32_t>(gettid()), std::memory_order_relaxed);
    TileRenderer renderer(scene, job, camera, film, board, slot);
    bool going = true;
    for (Tile tile{}; going && tiles.take(tile);) {
      const std::uint64_t rays =
          job.raysByTile != 0 ? std::min(job.rays, tileRays[tile.index(width)]) : job.rays;
      going = renderer.render(tile, rays);
    }
    invalid[index] = renderer.invalid();
    slot.threadId.store(0, std::memory_order_relaxed);
  };

  {
    std::vector<std::jthread> threads;
    for (std::uint32_t k = 0; k < job.threads; ++k) threads.emplace_back(work, k);
  }

  RenderResult result;
  for (std::uint32_t k = 0; k < job.threads; ++k) {
    result.invalid.add(invalid[k]);
    result.raysTraced += board.threads[k].raysTraced.load(std::memory_order_relaxed);
  }
  return result;
}

}  // namespace pathmark
