// Playback: samples that appear one by one.
#pragma once

#include <algorithm>
#include <cstddef>

namespace pathmark::preview {

class Playback {
 public:
  // Times in seconds, of any clock.
  void start(double now) {
    playing_ = true;
    started_ = now;
  }
  void stop() { playing_ = false; }

  bool playing() const { return playing_; }

  // How many of so many are to be seen; ends by itself when all are.
  std::size_t shown(std::size_t count, double now) {
    if (!playing_) return count;
    constexpr double kLongest = 12.0, kSlowest = 8.0;  // seconds; samples per second
    const double rate = std::max(static_cast<double>(count) / kLongest, kSlowest);
    const double seen = 1.0 + rate * std::max(now - started_, 0.0);
    if (seen >= static_cast<double>(count)) {
      playing_ = false;
      return count;
    }
    return static_cast<std::size_t>(seen);
  }

 private:
  bool playing_ = false;
  double started_ = 0.0;
};

}  // namespace pathmark::preview
