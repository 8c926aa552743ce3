#include "host/progress_bar.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace pathmark {

namespace {

std::string timeLeft(const RenderStatus& status) {
  if (status.fraction < 0.01 || status.seconds < 0.3) return "";
  const double left = status.seconds * (1.0 - status.fraction) / status.fraction;
  const auto seconds = static_cast<long>(std::ceil(left));
  if (seconds < 60) return fmt::format("{} s left", seconds);
  if (seconds < 3600) return fmt::format("{} min {:02} s left", seconds / 60, seconds % 60);
  return fmt::format("{} h {:02} min left", seconds / 3600, seconds / 60 % 60);
}

}  // namespace

ProgressBar::ProgressBar(std::string title)
    : title_(std::move(title)), terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const RenderStatus& status) {
  if (!terminal_ || lineOpen_) return;
  constexpr int kWidth = 24;
  const int full = static_cast<int>(std::lround(status.fraction * kWidth));
  const double rate = static_cast<double>(status.raysTraced) / std::max(status.seconds, 1e-9);
  const std::string line = fmt::format("\r\033[K{} [{}{}] {:3.0f}%  {:.1f} Mrays/s  {}", title_,
                                       std::string(full, '#'), std::string(kWidth - full, '.'),
                                       100.0 * status.fraction, rate * 1e-6, timeLeft(status));
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressBar::clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
  if (lineOpen_) std::fputs("\n", stderr);
  shown_ = lineOpen_ = false;
}

void ProgressBar::printAbove(std::string_view text) {
  if (shown_) clear();
  std::fwrite(text.data(), 1, text.size(), stderr);
  lineOpen_ = !text.empty() && text.back() != '\n';
}

}  // namespace pathmark
