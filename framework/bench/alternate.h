// Measuring several ways of doing the same against each other.
//
//   cpuSeconds   time that this thread has had on a processor
//   alternate    the rate of each way, all in turn
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pathmark::bench {

// Other programs that share the processor do not count.
double cpuSeconds();

// Does some work, about a tenth of a millisecond, and returns how much it was.
using Work = std::function<std::uint64_t()>;

// Of each way the median rate per CPU second. A slow phase of the machine meets all of them alike:
// they take turns, each with `seconds` in all.
std::vector<double> alternate(std::span<const Work> ways, double seconds);

double median(std::vector<double> values);

}  // namespace pathmark::bench
