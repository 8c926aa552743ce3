// Progress: the progress bar of a run whose steps are known.
#pragma once

#include "host/progress_bar.h"

#include <string>
#include <string_view>
#include <utility>

namespace pathmark::bench {

class Progress {
 public:
  Progress(std::string title, double steps) : bar_(std::move(title)), steps_(steps) {}

  void show(std::string_view what) { bar_.show(done_ / steps_, what); }
  // While the next `steps` are made, of which this share is done.
  void show(std::string_view what, double share, double steps) {
    bar_.show((done_ + share * steps) / steps_, what);
  }
  void advance(double steps) { done_ += steps; }
  void clear() { bar_.clear(); }

 private:
  ProgressBar bar_;
  double steps_, done_ = 0.0;
};

}  // namespace pathmark::bench
