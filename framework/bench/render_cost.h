// What renders cost, over the number of rays and of pixels.
//
//   CostPlan, CostPoint, CostSweep   what is varied, and what was found
//   measureCost                      runs whole processes, in turns
//   microsecondsPerRay               of the camera
//   costSlope                        of log(CPU seconds) against log(rays or pixels): 1 if in
//                                    proportion
#pragma once

#include "bench/error_statistics.h"
#include "bench/progress.h"
#include "bench/render_runs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pathmark::bench {

struct CostPlan {
  std::string scene;
  std::vector<std::uint64_t> raysPerPixel{1, 4, 16, 64, 256};  // in the scene's size
  std::vector<int> sides{32, 64, 128, 256, 512};               // of square images
  std::uint64_t raysOfSides = 16;
  int repeats = 5;
};

struct CostPoint {
  double amount = 0.0;             // rays per pixel, or pixels
  double cameraRays = 0.0;         // of the whole picture
  std::vector<double> cpuSeconds;  // of rendering: those of the process, less those of its start
  std::vector<double> megabytes;   // resident at most, host and worker
};

struct CostSweep {
  std::vector<CostPoint> points;
};

struct Cost {
  CostSweep rays, pixels;
};

// The start is what a render of one pixel with one ray takes. Throws CourseworkError, Interrupted.
Cost measureCost(const CostPlan& plan, const RenderRuns& runs, Progress& progress);

// Of the mean run, for each camera ray.
double microsecondsPerRay(const CostPoint& point);

Interval costSlope(const CostSweep& sweep);

}  // namespace pathmark::bench
