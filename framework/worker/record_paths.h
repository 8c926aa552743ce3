// recordPaths: renders as renderTiles does, and says what happens on the paths.
#pragma once

#include "render/render_tiles.h"
#include "worker/path_events.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pathmark {

struct RecordedRender {
  RenderResult result;
  std::uint64_t paths = 0;
  std::vector<PathEvent> events;
};

// Of a job for one thread. Null in a worker that does not record.
[[gnu::weak]] RecordedRender recordPaths(const SceneCore& scene, const RenderJob& job,
                                         std::span<FilmPixel> film, ProgressBoard& board,
                                         const std::function<void()>& onThreadStart);

}  // namespace pathmark
