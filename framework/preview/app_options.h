// What the command line says about the window.
#pragma once

#include "preview/engine.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace pathmark::preview {

enum class Tab { kProgress, kSamples, kPaths, kCompare, kView };
inline constexpr int kTabs = 5;
inline constexpr const char* kTabNames[kTabs] = {"progress", "samples", "paths", "compare", "view"};

struct AppOptions {
  EngineRequest request;
  int part = -1;  // -1: as it was last time
  Tab tab = Tab::kProgress;
  std::optional<std::pair<int, int>> pick{};  // a pixel whose paths are shown
  double exposureStops = 0.0;

  // For scripts: when there are request.mostRays rays in each pixel, writes these, where named, and
  // ends.
  std::filesystem::path screenshot;  // of the window, .png
  std::filesystem::path picture;     // as rendered, .png or .exr
  bool scripted() const { return !screenshot.empty() || !picture.empty(); }
};

}  // namespace pathmark::preview
