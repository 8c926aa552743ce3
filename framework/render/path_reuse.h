// PathReuse: pixels of a block that share what their paths have found.
//
// Each camera ray has a path of its own. What that finds to come from its second surface y serves
// the other pixels of the block as well: it costs them a shadow ray from their first surface x to
// y, and no path (Bekaert, Sbert & Halton, "Accelerating Path Tracing by Re-Using Paths", EGWR
// 2002). The indirect light of pixel k is then
//
//   sum over i of  f_k(y_i) G_k(y_i) L(y_i) / sum over j of p_j(y_i),
//
// with the BRDF f_k at x_k, G_k the cosines over the squared distance between x_k and y_i, or 0
// where they do not see each other, L(y_i) what comes from y_i by the i-th path, and p_j the
// density per unit area with which the j-th path would have met y_i: the balance heuristic (Veach &
// Guibas, SIGGRAPH 1995) over all paths that can. In the mean that is what a path of its own gives
// to each pixel, but the errors of the pixels of a block are not independent of each other.
//
// What comes from a surface that shines does not come to all pixels alike: such a y is its own
// pixel's only.
#pragma once

#include "render/pixel_block.h"
#include "render/progress_board.h"
#include "render/receivers.h"
#include "render/render_job.h"
#include "render/scene_core.h"
#include "sampling/pixel_sampler.h"

#include <memory>
#include <span>
#include <vector>

namespace pathmark {

class PathReuse {
 public:
  // All must outlive it.
  PathReuse(const SceneCore& core, const RenderJob& job, const SimpleCamera& camera);
  ~PathReuse();

  // Sets the mean radiance of so many camera rays of each pixel of the block, of which earlier
  // passes have made `raysBefore`, and tells the slot which pixel is in work.
  void render(const PixelBlock& block, std::uint64_t raysBefore, std::uint32_t rays,
              std::span<Colour> means, ThreadSlot& slot);

 private:
  struct Path;
  struct Pixel;

  Colour directLight(const Ray& cameraRay, int m, const Hit& first, Pixel& pixel) const;
  void meetFirst(std::span<Pixel> pixels);
  void trace(const Ray& cameraRay, int m, std::size_t k, Pixel& pixel);
  void findSecond(Path& path, Sampler& sampler) const;
  void giveToAll(std::size_t from, std::span<Pixel> pixels);

  const SceneCore& core_;
  const RenderJob& job_;
  const SimpleCamera& camera_;
  LitScene direct_, rest_;       // with one bounce at most, and with those behind the first
  std::vector<Ray> cameraRays_;  // of the pixels of a block
  std::vector<Pixel> pixels_;
  Receivers receivers_;
};

}  // namespace pathmark
