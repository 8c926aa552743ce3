// renderToTarget: from a scene to a picture with a stated error in a file, and a report of it.
#pragma once

#include "host/session.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace pathmark {

struct AdaptiveRequest {
  std::filesystem::path output;
  RenderOptions options;  // raysPerPixel is the most of any pixel
  double targetError = 0.01;
  std::filesystem::path rayMap;  // where to write how many rays each tile got; empty: nowhere
};

// "1%" or "0.01"; throws UsageError.
double parseTargetError(const std::string& text);

// Throws UsageError if the error cannot be estimated with so few.
void refuseFewRays(std::uint64_t raysPerPixel);

// Returns an exit code. Throws UsageError, WorkerError and ImageError.
int renderToTarget(const Coursework& coursework, const LoadedScene& scene,
                   const AdaptiveRequest& request);

}  // namespace pathmark
