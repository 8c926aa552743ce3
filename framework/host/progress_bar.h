// ProgressBar: one line on a terminal that says how far a command is; nothing off a terminal.
#pragma once

#include "host/render_loop.h"

#include <string>
#include <string_view>

namespace pathmark {

class ProgressBar {
 public:
  explicit ProgressBar(std::string title);
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
  std::string title_;
  bool terminal_;
  bool shown_ = false;
  bool lineOpen_ = false;
};

}  // namespace pathmark
