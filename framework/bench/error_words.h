// How the numbers of bench error are written.
#pragma once

#include "bench/error_statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace pathmark::bench {

// Three significant digits, without an exponent where it can be read that way.
inline std::string threeDigits(double value) {
  if (!std::isfinite(value)) return "-";
  const double size = std::abs(value);
  if (size >= 99.95)
    return size < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.2e}", value);
  if (size < 0.00995 && size > 0.0) return fmt::format("{:.2e}", value);
  return fmt::format("{:#.3g}", value);
}

// The wider half of an interval, in per cent of its value.
inline std::string percentAround(const Interval& i) {
  const double half = std::max(i.high - i.value, i.value - i.low) / std::abs(i.value);
  return std::isfinite(half) ? fmt::format("{:.0f} %", 100.0 * half) : "-";
}

inline std::string slopeWords(const Interval& slope) {
  if (!std::isfinite(slope.value)) return "-";
  if (!std::isfinite(slope.high)) return fmt::format("{:.2f}", slope.value);
  return fmt::format("{:.2f} +- {:.2f}", slope.value, slope.high - slope.value);
}

}  // namespace pathmark::bench
