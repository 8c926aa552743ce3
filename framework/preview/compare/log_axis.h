// LogAxis: a logarithmic axis, and where its ticks are.
#pragma once

#include <string>
#include <vector>

namespace pathmark::preview {

struct LogTick {
  double value = 1.0;
  std::string label;  // empty of a small tick
};

struct LogAxis {
  double low = 0.1, high = 1.0;  // positive, low < high

  // From 0 to 1.
  double place(double value) const;

  // At most about `most` labels, at powers of ten, or at 1, 2 and 5 times those where these are
  // few.
  std::vector<LogTick> ticks(int most) const;
};

// One that these numbers are on, with a margin, and at least a decade long. Numbers must be
// positive; without any, from 0.1 to 1.
LogAxis axisFor(const std::vector<double>& values);

// "0.01", "20", "1e-6".
std::string logLabel(double value);

}  // namespace pathmark::preview
