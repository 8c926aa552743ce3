// Progress: one line on a terminal that says how far a run is; nothing off a terminal.
#pragma once

#include <string>
#include <string_view>

namespace pathmark::bench {

class Progress {
 public:
  Progress(std::string title, double steps);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::string_view what);
  void advance(double steps) { done_ += steps; }
  void clear();

 private:
  std::string title_;
  double steps_, done_ = 0.0;
  bool terminal_;
  bool shown_ = false;
};

}  // namespace pathmark::bench
