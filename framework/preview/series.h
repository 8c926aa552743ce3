// Series: a picture that gets better, pass after pass.
//
// Its rays are made in eight independent replicates in turn, as `pathmark render --replicates 8`
// makes them one after the other: the same numbers, and a variance from early on. A very large
// picture has two replicates, for its memory.
#pragma once

#include "host/render_loop.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace pathmark::preview {

class Series {
 public:
  struct Made {
    Image image;
    std::uint32_t replicates = 0;  // that its variance comes from; 0: it has none
    InvalidPixels invalid;
    double raysPerPixel = 0.0;
    double seconds = 0.0;
    std::uint64_t raysTraced = 0;
  };

  // The settings' rays per pixel are what a replicate is to have in the end. The worker must
  // outlive this object. Throws std::system_error.
  Series(WorkerProcess& worker, const RenderSettings& settings);

  bool finished() const;
  bool anyWholePass() const { return wholePasses_ > 0; }

  // About so many seconds of work. Returns false if `goOn` has ended it before: that work is lost.
  // Throws WorkerError.
  bool step(double seconds, const std::function<bool()>& goOn);

  // What there is now.
  Made made() const;

 private:
  void takeRound();

  RenderSettings settings_;
  std::vector<std::unique_ptr<ImageRender>> replicates_;
  std::size_t current_ = 0;
  std::uint64_t wholePasses_ = 0;  // of all replicates together
  ReplicateSums round_;            // when all of them had the same number of passes
  std::uint32_t inRound_ = 0;
};

}  // namespace pathmark::preview
