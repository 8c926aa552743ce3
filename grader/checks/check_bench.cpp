#include "checks/check_bench.h"

#include "checks/scenes.h"
#include "sampling/mix.h"

#include <utility>

namespace pathmark::checks {

namespace {

// Different checks see different numbers, and a check sees the same with or without the others.
std::uint64_t seedOf(const Check& check, std::uint64_t seed) {
  std::uint64_t hash = mix(seed + kGolden);
  for (const char c : idOf(check)) hash = mix(hash + static_cast<unsigned char>(c) + kGolden);
  return hash;
}

}  // namespace

bool RunProgress::goesOn() {
  const std::lock_guard lock(mutex_);
  return !events_.goOn || events_.goOn();
}

void RunProgress::begun(const Check& check) {
  const std::lock_guard lock(mutex_);
  if (events_.onProgress)
    events_.onProgress(static_cast<double>(done_) / static_cast<double>(total_), idOf(check));
}

void RunProgress::done() {
  const std::lock_guard lock(mutex_);
  ++done_;
}

void RunProgress::done(const PartResult& part) {
  const std::lock_guard lock(mutex_);
  if (events_.onPart) events_.onPart(part);
}

CheckBench::CheckBench(std::filesystem::path program, const CourseworkBuild& build,
                       const RunOptions& options, RunProgress& progress)
    : program_(std::move(program)), build_(build), options_(options), progress_(progress) {}

WorkerProcess& CheckBench::worker() {
  if (!worker_) {
    WorkerProcess::Options options;
    options.program = program_;
    options.courseworkFolder = build_.folder;
    options.confinement = build_.confinement;
    options.limits.secondsWithoutAnswer = options_.secondsWithoutAnswer;
    options.limits.memoryBytes = options_.memoryBytes;
    options.onText = options_.onText;
    options.goOn = [this] { return progress_.goesOn(); };
    worker_ = std::make_unique<WorkerProcess>(std::move(options));
    worker_->loadScene(emptyRoom());
  }
  return *worker_;
}

Finding CheckBench::make(const Check& check, stats::ErrorBudget& budget) {
  try {
    CheckRun run{worker(), seedOf(check, options_.seed), budget, check.function};
    return check.run(run);
  } catch (const WorkerError& e) {
    forget();
    Finding finding;
    finding.status = Status::kBroken;
    finding.got = e.what();
    finding.fault = e.fault();
    return finding;
  }
}

}  // namespace pathmark::checks
