// ProgressBar: one line on a terminal that says how far a command is. Elsewhere, as in the log of a
// long job, a line of its own each minute, so that short commands print none.
#pragma once

#include "host/render_loop.h"

#include <chrono>
#include <string>
#include <string_view>

namespace pathmark {

class ProgressBar {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ProgressBar(std::string title, Clock::duration betweenLines = std::chrono::minutes(1));
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // fraction in [0,1]; `what` stands behind it.
  void show(double fraction, std::string_view what);
  void show(const RenderStatus& status);
  void clear();

  // Text of somebody else on standard error, above the bar; clear() ends its last line.
  void printAbove(std::string_view text);

 private:
  void showLine(double fraction, std::string_view what);

  std::string title_;
  Clock::duration betweenLines_;
  Clock::time_point lastLine_ = Clock::now();
  bool terminal_;
  bool shown_ = false;
  bool lineOpen_ = false;
};

}  // namespace pathmark
