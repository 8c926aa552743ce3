// renderPicture: from a scene to a picture in a file, with checkpoints on the way, and a report of
// it for a person.
#pragma once

#include "host/checkpoint_keeper.h"
#include "host/session.h"

#include <filesystem>

namespace pathmark {

struct PictureRequest {
  std::filesystem::path output;
  RenderOptions options;
  CheckpointOptions checkpoints;
};

// Returns an exit code. Throws UsageError, WorkerError and ImageError.
int renderPicture(const Coursework& coursework, const LoadedScene& scene,
                  const PictureRequest& request);

}  // namespace pathmark
