#include "preview/compare/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

constexpr double kRounding = 1e-9;  // of a tick that is at the very end

}  // namespace

double LogAxis::place(double value) const { return std::log(value / low) / std::log(high / low); }

std::vector<LogTick> LogAxis::ticks(int most) const {
  const double decades = std::log10(high / low);
  const bool between = 3.0 * decades <= most;
  const int step = std::max(1, static_cast<int>(std::ceil(decades / most)));
  std::vector<LogTick> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(low))); power <= std::log10(high);
       ++power)
    for (int k = 1; k <= 9; ++k) {
      const double value = k * std::pow(10.0, power);
      if (value < low * (1.0 - kRounding) || value > high * (1.0 + kRounding)) continue;
      const bool labelled = k == 1 ? power % step == 0 || between : between && (k == 2 || k == 5);
      if (labelled || step == 1) ticks.push_back({value, labelled ? logLabel(value) : ""});
    }
  return ticks;
}

LogAxis axisFor(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  constexpr double kMargin = 0.04;  // of the length, at each end
  const double middle = 0.5 * (std::log10(*low) + std::log10(*high));
  const double length = std::max(1.0, std::log10(*high / *low)) * (1.0 + 2.0 * kMargin);
  return {std::pow(10.0, middle - 0.5 * length), std::pow(10.0, middle + 0.5 * length)};
}

std::string logLabel(double value) {
  const int power = static_cast<int>(std::floor(std::log10(value) + kRounding));
  if (power >= -3 && power <= 3) return fmt::format("{:.4g}", value);
  return fmt::format("{:.0f}e{}", value / std::pow(10.0, power), power);
}

}  // namespace pathmark::preview
