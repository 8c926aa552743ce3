#include "bench/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace pathmark::bench {

Progress::Progress(std::string title, double steps)
    : title_(std::move(title)), steps_(steps), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(std::string_view what) {
  if (!terminal_) return;
  constexpr double kWidth = 24.0;
  const double fraction = std::clamp(done_ / steps_, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(fraction * kWidth);
  fmt::print(stderr, "\r\033[K{} [{}{}] {:3.0f}%  {}", title_, std::string(full, '#'),
             std::string(static_cast<std::size_t>(kWidth) - full, '.'), 100.0 * fraction, what);
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace pathmark::bench
