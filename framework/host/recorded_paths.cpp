#include "host/recorded_paths.h"

#include <cstring>

namespace pathmark {

namespace {

bool isPossible(const PathEvent& event) {
  const bool known = event.kind >= PathEventKind::kPath && event.kind <= PathEventKind::kLightPdf;
  if (!known || event.flag > 1) return false;
  if (event.kind == PathEventKind::kHit) return event.integer >= -1;
  return event.kind != PathEventKind::kRadiance || event.integer >= 0;
}

// The number of paths, or nothing if something lies outside of one or is missing in it.
std::optional<std::size_t> countPaths(std::span<const PathEvent> events) {
  std::size_t paths = 0, begin = 0;
  bool inside = false;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool begins = events[i].kind == PathEventKind::kPath;
    if (!isPossible(events[i]) || begins == inside) return std::nullopt;
    if (begins) {
      begin = i;
      ++paths;
    }
    inside = events[i].kind != PathEventKind::kRadiance;
    if (i - begin >= kMostEventsOfAPath) return std::nullopt;
  }
  return inside ? std::nullopt : std::optional(paths);
}

}  // namespace

std::optional<RecordedPaths> readRecordedPaths(std::span<const std::byte> reply) {
  if (reply.size() < sizeof(RecordPathsReply) ||
      (reply.size() - sizeof(RecordPathsReply)) % sizeof(PathEvent) != 0)
    return std::nullopt;
  RecordedPaths paths;
  std::memcpy(&paths.counts, reply.data(), sizeof paths.counts);
  const auto rest = reply.subspan(sizeof paths.counts);
  paths.events.resize(rest.size() / sizeof(PathEvent));
  if (!rest.empty()) std::memcpy(paths.events.data(), rest.data(), rest.size());
  const auto count = countPaths(paths.events);
  if (!count || *count > paths.counts.paths) return std::nullopt;
  return paths;
}

}  // namespace pathmark
