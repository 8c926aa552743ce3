// What checks are made with.
//
//   RunProgress   tells how far they are, and whether they may go on
//   CheckBench    the worker, started again after it has died
#pragma once

#include "checks/results.h"
#include "checks/runner.h"

#include <filesystem>
#include <memory>
#include <mutex>

namespace pathmark::checks {

// Shared by the threads that check parts.
class RunProgress {
 public:
  RunProgress(std::size_t checks, const RunEvents& events) : total_(checks), events_(events) {}

  bool goesOn();
  void begun(const Check& check);
  void done();  // a check
  void done(const PartResult& part);

 private:
  std::mutex mutex_;
  std::size_t total_, done_ = 0;
  const RunEvents& events_;
};

class CheckBench {
 public:
  // `program` is a worker of this coursework, and runs where that was compiled.
  CheckBench(std::filesystem::path program, const CourseworkBuild& build, const RunOptions& options,
             RunProgress& progress);

  // Started when it is needed, with an empty scene.
  WorkerProcess& worker();

  // The next one begins with a worker that no check before it has touched.
  void forget() { worker_.reset(); }

  // What kills the worker is found broken. Throws WorkerStopped if the checks may not go on.
  Finding make(const Check& check, stats::ErrorBudget& budget);

 private:
  std::filesystem::path program_;
  const CourseworkBuild& build_;
  const RunOptions& options_;
  RunProgress& progress_;
  std::unique_ptr<WorkerProcess> worker_;
};

}  // namespace pathmark::checks
