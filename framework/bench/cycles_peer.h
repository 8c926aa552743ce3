// Cycles, Blender's path tracer, on the same scenes: the peer that a Debian system can install.
//
//   CyclesPeer   renders a scene with it, as a process of its own
#pragma once

#include "bench/cycles_scene.h"
#include "bench/render_runs.h"

#include <optional>

namespace pathmark::bench {

struct CyclesResult {
  ChildUsage usage;               // of the whole process
  double renderCpuSeconds = 0.0;  // without Blender's start and the making of the scene
  Image image;
};

class CyclesPeer {
 public:
  // Nothing if there is no program blender.
  static std::optional<CyclesPeer> find(const std::filesystem::path& folder);

  const std::string& version() const { return version_; }

  // One thread. Throws std::runtime_error with what Blender said, if it fails.
  CyclesResult render(const BenchScene& scene, std::uint64_t raysPerPixel, std::uint64_t seed,
                      const CyclesPlace& place = {}) const;

 private:
  explicit CyclesPeer(std::filesystem::path folder, std::string version)
      : folder_(std::move(folder)), version_(std::move(version)) {}

  std::filesystem::path folder_;
  std::string version_;
};

}  // namespace pathmark::bench
