// What a worker says of the paths that it has recorded, looked at before anybody believes it.
#pragma once

#include "worker/path_events.h"
#include "worker/protocol.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pathmark {

struct RecordedPaths {
  RecordPathsReply counts;
  std::vector<PathEvent> events;  // whole paths, one after another
};

// Nothing if the bytes are no record: each path has a beginning and an end and is no longer than
// allowed, and all kinds and counts are possible. Numbers that the coursework has given may be of
// any value, NaN and infinity too.
std::optional<RecordedPaths> readRecordedPaths(std::span<const std::byte> reply);

}  // namespace pathmark
