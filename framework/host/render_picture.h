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

// Throws UsageError, with the nearest numbers of rays that serve, unless the rays of a pixel can be
// parted into so many equal replicates.
void refuseUnequalReplicates(std::uint64_t rays, std::uint64_t replicates);

// Returns an exit code. Throws UsageError, WorkerError and ImageError.
int renderPicture(const Coursework& coursework, const LoadedScene& scene,
                  const PictureRequest& request);

}  // namespace pathmark
