// Single renders of bench error, and where they are kept.
//
//   ErrorPoint   what was rendered, and with how many rays
//   ErrorRun     one render of it
//   madeBy       says what a run depends on
//   ErrorRuns    all of them; read from a file and written to it, so that none is made twice
#pragma once

#include "bench/image_error.h"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::bench {

struct ErrorPoint {
  std::string scene;
  std::string estimator;           // the coursework or the lab, or another renderer
  std::string sampler;             // empty for another renderer
  std::uint64_t raysPerPixel = 0;  // 0: not known, of another renderer

  auto operator<=>(const ErrorPoint&) const = default;
};

struct ErrorRun {
  ErrorPoint point;
  std::uint64_t replicate = 0;  // 0, 1, 2, ...: each has a seed of its own
  double cpuSeconds = 0.0;      // of rendering, without the program's start
  Deviation deviation;
  std::string made;  // what it depends on, by madeBy
};

// `measure` is a hash of what runs must have in common to be compared: the scene and its reference.
// `words` tell all else that a run depends on: the program and the seed.
std::string madeBy(const std::string& measure, const std::string& words);

class ErrorRuns {
 public:
  // Nothing if there is no such run that was made of the same.
  const ErrorRun* find(const ErrorPoint& point, std::uint64_t replicate,
                       const std::string& made) const;

  // Takes the place of an older one.
  void add(ErrorRun run);

  // Forgets the runs of a scene and an estimator that were made of something else.
  void keepOnly(const std::string& scene, const std::string& estimator, const std::string& made);

  const std::vector<ErrorRun>& all() const { return runs_; }

  // Those of one measure.
  std::vector<ErrorRun> of(const std::string& measure) const;

 private:
  std::vector<ErrorRun> runs_;
};

// With a head that names the columns; a run is a line.
std::string csvOf(const std::vector<ErrorRun>& runs);

// What csvOf wrote. Throws UsageError with a sentence that names the file and the line.
std::vector<ErrorRun> readCsv(const std::filesystem::path& file);

}  // namespace pathmark::bench
