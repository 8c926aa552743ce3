// ProgressLine: one line on a terminal that says how far a command is; nothing off a terminal.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include <unistd.h>

namespace pathmark {

class ProgressLine {
 public:
  ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double fraction, const std::string& what) {
    if (!terminal_) return;
    constexpr int kWidth = 30;
    const int done = static_cast<int>(fraction * kWidth);
    fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {:3.0f}%  {}", "", done, "", kWidth - done,
               100.0 * fraction, what);
    std::fflush(stderr);
    shown_ = true;
  }

  void clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
    shown_ = false;
  }

 private:
  bool terminal_, shown_ = false;
};

}  // namespace pathmark
