// renderTiles: renders passes of a scene into a film, with many threads.
//
// A film pixel is the work of one thread at a time, and its passes are added in their order: the
// image has the same bits for any number of threads.
#pragma once

#include "render/progress_board.h"
#include "render/render_job.h"
#include "render/scene_core.h"

#include <functional>
#include <span>

namespace pathmark {

// The camera that the job is seen by.
SimpleCamera cameraOf(const SceneCore& scene, const RenderJob& job);

// Adds the job's rays to the film (row by row from the top, camera width x height). `tileRays` is
// for jobs with raysByTile. `onThreadStart` is called by each render thread before its first pixel.
RenderResult renderTiles(const SceneCore& scene, const RenderJob& job, std::span<FilmPixel> film,
                         ProgressBoard& board, const std::function<void()>& onThreadStart,
                         std::span<const std::uint64_t> tileRays = {});

}  // namespace pathmark
