// ProgressBar: one line on a terminal that says how far a command is. Elsewhere, as in the log of a
// long job, a line of its own each minute, so that short commands print none; a command that runs
// others reads those.
#pragma once

#include "host/render_loop.h"

#include <chrono>
#include <optional>
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

// What the last line of a ProgressBar says, in the log of a command.
struct LoggedProgress {
  double fraction;
  std::string what;
};

std::optional<LoggedProgress> lastProgressIn(std::string_view log);

}  // namespace pathmark
