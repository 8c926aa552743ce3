#include "bench/alternate.h"

#include <algorithm>
#include <ctime>

namespace pathmark::bench {

namespace {

constexpr int kRounds = 5;

double rateOf(const Work& work, double seconds) {
  const double started = cpuSeconds();
  double done = 0.0, spent = 0.0;
  do {
    done += static_cast<double>(work());
    spent = cpuSeconds() - started;
  } while (spent < seconds);
  return done / spent;
}

}  // namespace

double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::vector<double> alternate(std::span<const Work> ways, double seconds) {
  std::vector<std::vector<double>> rates(ways.size());
  for (const Work& work : ways) work();  // memory and code into the caches
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t k = 0; k < ways.size(); ++k)
      rates[k].push_back(rateOf(ways[k], seconds / kRounds));
  std::vector<double> medians;
  medians.reserve(rates.size());
  for (std::vector<double>& r : rates) medians.push_back(median(std::move(r)));
  return medians;
}

}  // namespace pathmark::bench
