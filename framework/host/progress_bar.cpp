#include "host/progress_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace pathmark {

namespace {

// From the pace of this run, which may have other threads and company than earlier ones; shown as
// soon as the pace is known by some of the work or for some time.
std::string timeLeft(const RenderStatus& status) {
  const double made = status.fraction - status.fractionBefore;
  const double spent = status.seconds - status.secondsBefore;
  if (spent < 0.3 || made <= 0.0 || (made < 0.01 && spent < 5.0)) return "";
  const double left = std::ceil(spent * (1.0 - status.fraction) / made);
  if (left > 365.0 * 86400.0) return "more than a year left";
  const auto seconds = static_cast<long>(left);
  if (seconds < 60) return fmt::format("{} s left", seconds);
  if (seconds < 3600) return fmt::format("{} min {:02} s left", seconds / 60, seconds % 60);
  if (seconds < 48L * 3600)
    return fmt::format("{} h {:02} min left", seconds / 3600, seconds / 60 % 60);
  return fmt::format("{} days {} h left", seconds / 86400, seconds / 3600 % 24);
}

}  // namespace

ProgressBar::ProgressBar(std::string title, Clock::duration betweenLines)
    : title_(std::move(title)),
      betweenLines_(betweenLines),
      terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const RenderStatus& status) {
  const double rate = static_cast<double>(status.raysTraced) / std::max(status.seconds, 1e-9);
  show(status.fraction, fmt::format("{:.1f} Mrays/s  {}", rate * 1e-6, timeLeft(status)));
}

void ProgressBar::show(double fraction, std::string_view what) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (lineOpen_) return;
  if (!terminal_) return showLine(fraction, what);
  constexpr int kWidth = 24;
  const int full = static_cast<int>(std::lround(fraction * kWidth));
  const std::string line =
      fmt::format("\r\033[K{} [{}{}] {:3.0f}%  {}", title_, std::string(full, '#'),
                  std::string(kWidth - full, '.'), 100.0 * fraction, what);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressBar::showLine(double fraction, std::string_view what) {
  const Clock::time_point now = Clock::now();
  if (now - lastLine_ < betweenLines_) return;
  lastLine_ = now;
  fmt::print(stderr, "{}: {:.0f}%{}{}\n", title_, 100.0 * fraction, what.empty() ? "" : ", ", what);
  std::fflush(stderr);
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

std::optional<LoggedProgress> lastProgressIn(std::string_view log) {
  std::optional<LoggedProgress> last;
  while (!log.empty()) {
    const std::string_view line = log.substr(0, log.find('\n'));
    log.remove_prefix(std::min(line.size() + 1, log.size()));
    const std::size_t colon = line.find(": "), percent = line.find('%');
    if (colon == std::string_view::npos || percent == std::string_view::npos) continue;
    int whole = 0;
    const char* const end = line.data() + percent;
    const auto [stopped, error] = std::from_chars(line.data() + colon + 2, end, whole);
    if (error != std::errc{} || stopped != end || whole < 0 || whole > 100) continue;
    std::string_view what = line.substr(percent + 1);
    if (what.starts_with(", ")) what.remove_prefix(2);
    last = {0.01 * whole, std::string(what)};
  }
  return last;
}

}  // namespace pathmark
