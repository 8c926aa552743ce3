// Pictures for marks: of a coursework, beside those of the solutions.
//
//   SolvedPictures   the solutions' pictures and samples of one seed, each made once
//   comparePicture   a coursework's picture of one scene, and how it differs
//   invalidWords     what of a picture is no radiance
#pragma once

#include "host/worker_process.h"
#include "marking/marking_scenes.h"
#include "marking/picture_statistics.h"
#include "record/record.h"
#include "render/render_job.h"

#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace pathmark::marking {

// Four rays of each pixel in a replicate: two strata in each direction. A picture takes about half
// a second on two processors.
inline constexpr std::uint32_t kReplicates = 32;
inline constexpr std::uint64_t kRaysPerPixel = 128;

struct Effort {
  std::uint64_t raysPerPixel = kRaysPerPixel;
  std::uint32_t replicates = kReplicates;
};

// With these seeds for random numbers, so that pictures of the same scene by two courseworks share
// no noise. Throws WorkerError.
Measured renderMeasured(WorkerProcess& worker, const MarkingScene& scene, std::uint64_t seed,
                        unsigned threads, const Effort& effort = {});

struct Solved {
  Measured picture;
  std::vector<double> convergence;  // empty where it was not asked for
};

// Safe to use from several threads: they wait for each other only where they want the same one.
class SolvedPictures {
 public:
  // `start` starts a worker of the solutions.
  SolvedPictures(std::function<std::unique_ptr<WorkerProcess>()> start, std::uint64_t seed)
      : start_(std::move(start)), seed_(seed) {}

  const Solved& of(const MarkingScene& scene, bool withConvergence, unsigned threads);

 private:
  struct Entry {
    std::once_flag made;
    Solved solved;
  };
  std::function<std::unique_ptr<WorkerProcess>()> start_;
  std::uint64_t seed_;
  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

// The files of a picture, as bytes.
struct PictureFiles {
  std::string yours, reference, difference;
};

struct Compared {
  record::PictureRecord record;  // without the names of files
  PictureFiles files;
  Image image{};  // the coursework's; empty where it failed
};

struct CompareOptions {
  std::uint64_t seed = 0;
  unsigned threads = 1;
  bool convergence = false;
};

// What goes wrong in the coursework is said in the record's `failure`; the worker has ended then.
// WorkerStopped passes through.
Compared comparePicture(WorkerProcess& worker, const MarkingScene& scene, SolvedPictures& solved,
                        const CompareOptions& options);

// As PictureRecord has them, of a picture that is made of so many values, a pass of a pixel each.
std::string invalidWords(const InvalidPixels& invalid, double values);

}  // namespace pathmark::marking
