#include "worker/record_paths.h"

#include "worker/path_recorder.h"

namespace pathmark {

RecordedRender recordPaths(const SceneCore& scene, const RenderJob& job, std::span<FilmPixel> film,
                           ProgressBoard& board, const std::function<void()>& onThreadStart) {
  PathRecorder recorder(scene, job.paths.filters());
  RecordedRender render;
  render.result = renderTiles(scene, job, film, board, [&] {
    onThreadStart();
    recorder.useForThisThread();
  });
  render.paths = recorder.paths();
  render.events = recorder.takeEvents();
  return render;
}

}  // namespace pathmark
