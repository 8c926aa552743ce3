// What the parts of bench stress share.
//
//   Stress         the coursework that is stressed, and where the findings go
//   StressWorker   a worker of it
//   StressPart     one of the parts; stressParts lists them in the order of a run
//
// A figure that must be reached fails the command if it is not. Bounds are those of the solutions:
// what is right but noisier, or less careful at the far ends, can miss some of them.
#pragma once

#include "bench/progress.h"
#include "bench/report.h"
#include "host/render_loop.h"
#include "host/session.h"
#include "host/worker_process.h"

#include <cstdint>
#include <span>
#include <string>

namespace pathmark::bench {

struct Stress {
  Coursework coursework;
  bool quick = false;
  Progress progress;
  Report report;

  // Of all renders: what was no radiance, and passes of pixels in all.
  InvalidPixels invalid{};
  double passes = 0.0;

  void begin(Table table);
  void row(std::vector<Cell> cells);
  void add(Figure figure) { report.figures.push_back(std::move(figure)); }

  // A number of faults, which must be 0.
  void addFaults(std::string key, std::string name, double faults, std::string note = {});

  // An error that may be so large at most.
  void addError(std::string key, std::string name, double error, double must, double aim,
                std::string note = {});
};

class StressWorker {
 public:
  // Throws WorkerError.
  explicit StressWorker(Stress& stress);

  // Throw Interrupted on Ctrl-C, WorkerError if the coursework fails.
  void load(const FlatScene& scene);
  RenderedImage render(const RenderSettings& settings, RenderState state = {});
  std::vector<std::uint32_t> call(CourseworkFunction function,
                                  std::span<const std::uint32_t> object,
                                  std::span<const std::uint32_t> inputs);
  std::vector<Estimate> estimate(const EstimateRequest& request,
                                 std::span<const std::uint32_t> inputs);

  // For what has no name here. Counts nothing.
  WorkerProcess& process() { return process_; }

 private:
  Stress& stress_;
  WorkerProcess process_;
};

// Throws SceneError.
LoadedScene sceneOf(const std::string& name, const std::string& json);

// Two pictures of the same scene: values of which the bits differ.
std::size_t differingValues(const Image& a, const Image& b);

struct StressPart {
  const char* name;  // of --only, in JSON
  const char* what;
  double steps;  // of the progress, about seconds
  void (*run)(Stress&);
};

std::span<const StressPart> stressParts();

// One file each.
void stressSimilarity(Stress& stress);
void stressLights(Stress& stress);
void stressMaterials(Stress& stress);
void stressInput(Stress& stress);
void stressLongRuns(Stress& stress);
void stressThreads(Stress& stress);
void stressDegenerate(Stress& stress);

// Another renderer's similarity; throws UsageError if it is not there.
inline constexpr double kStepsOfPeer = 104.0;
void stressPeer(Stress& stress);

}  // namespace pathmark::bench
