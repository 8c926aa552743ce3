// Renders of the benchmark's scenes by this program, each as a process of its own.
//
//   BenchScene   one of the scenes, with its reference
//   RenderRuns   makes and measures renders
#pragma once

#include "bench/child_process.h"
#include "bench/image_error.h"
#include "host/session.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::bench {

struct BenchScene {
  std::string key;  // "s1"
  std::string name;
  LoadedScene scene;
  Image reference;

  double pixels() const { return static_cast<double>(reference.width) * reference.height; }
};

// Makes the blob's mesh if it is missing, and says so. Throws UsageError if there is no reference.
BenchScene loadBenchScene(const std::string& key, const std::string& name);

struct RenderRun {
  std::string scene;  // a name or a file
  std::uint64_t raysPerPixel = 64;
  std::uint64_t seed = 0;
  int threads = 1;
  std::string size{};                  // empty: the scene's
  std::vector<std::string> options{};  // more of render's
};

struct RunResult {
  ChildUsage usage;
  Image image;
  double renderSeconds = 0.0;  // of the rendering itself, on the wall's clock
};

class RenderRuns {
 public:
  RenderRuns(const Coursework& coursework, std::filesystem::path folder);

  // All of these throw CourseworkError with what the program said, if it fails.
  RunResult render(const RenderRun& run) const;
  PeakMemory memory(const RenderRun& run) const;

  // Camera, bounce and shadow rays for each camera ray.
  double raysPerPath(const LoadedScene& scene) const;

  const Coursework& coursework() const { return coursework_; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::vector<std::string> words(const RenderRun& run) const;
  void requireSuccess(int exitCode, const RenderRun& run) const;
  std::filesystem::path picture(const RenderRun& run) const;
  std::filesystem::path log() const { return folder_ / "log.txt"; }

  Coursework coursework_;
  std::filesystem::path folder_;
};

}  // namespace pathmark::bench
