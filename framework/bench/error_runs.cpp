#include "bench/error_runs.h"

#include "host/content_hash.h"
#include "host/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>

namespace pathmark::bench {

namespace {

constexpr std::string_view kHead =
    "scene,estimator,sampler,rays_per_pixel,replicate,cpu_seconds,mse,relative_mse,worst_share,"
    "mean_deviation,made";
constexpr std::size_t kColumns = 11;
constexpr char kBetween = '-';  // of hashes

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0;;) {
    const std::size_t comma = line.find(',', at);
    fields.push_back(line.substr(at, comma - at));
    if (comma == std::string_view::npos) return fields;
    at = comma + 1;
  }
}

template <class Number>
bool read(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

bool readRun(std::string_view line, ErrorRun& run) {
  const std::vector<std::string_view> f = fieldsOf(line);
  if (f.size() != kColumns) return false;
  run.point.scene = f[0];
  run.point.estimator = f[1];
  run.point.sampler = f[2];
  run.made = f[10];
  Deviation& d = run.deviation;
  return read(f[3], run.point.raysPerPixel) && read(f[4], run.replicate) &&
         read(f[5], run.cpuSeconds) && read(f[6], d.mse) && read(f[7], d.relativeMse) &&
         read(f[8], d.worstShare) && read(f[9], d.mean);
}

}  // namespace

std::string madeBy(const std::string& measure, const std::string& words) {
  return measure + kBetween + contentHash(words);
}

const ErrorRun* ErrorRuns::find(const ErrorPoint& point, std::uint64_t replicate,
                                const std::string& made) const {
  const auto found = std::find_if(runs_.begin(), runs_.end(), [&](const ErrorRun& run) {
    return run.replicate == replicate && run.point == point && run.made == made;
  });
  return found == runs_.end() ? nullptr : &*found;
}

void ErrorRuns::add(ErrorRun run) {
  const auto same = std::find_if(runs_.begin(), runs_.end(), [&](const ErrorRun& other) {
    return other.replicate == run.replicate && other.point == run.point;
  });
  if (same == runs_.end())
    runs_.push_back(std::move(run));
  else
    *same = std::move(run);
}

void ErrorRuns::keepOnly(const std::string& scene, const std::string& estimator,
                         const std::string& made) {
  std::erase_if(runs_, [&](const ErrorRun& run) {
    return run.point.scene == scene && run.point.estimator == estimator && run.made != made;
  });
}

std::vector<ErrorRun> ErrorRuns::of(const std::string& measure) const {
  std::vector<ErrorRun> found;
  std::ranges::copy_if(runs_, std::back_inserter(found), [&](const ErrorRun& run) {
    return run.made.starts_with(measure + kBetween);
  });
  return found;
}

// Numbers in the shortest form that reads back to the same bits.
std::string csvOf(const std::vector<ErrorRun>& runs) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{}\n", kHead);
  for (const ErrorRun& run : runs) {
    const Deviation& d = run.deviation;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}\n", run.point.scene,
                   run.point.estimator, run.point.sampler, run.point.raysPerPixel, run.replicate,
                   run.cpuSeconds, d.mse, d.relativeMse, d.worstShare, d.mean, run.made);
  }
  return fmt::to_string(text);
}

std::vector<ErrorRun> readCsv(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line != kHead)
    throw UsageError(fmt::format("{} is no file of bench error: its first line would be \"{}\".",
                                 file.string(), kHead));
  std::vector<ErrorRun> runs;
  for (int number = 2; std::getline(in, line); ++number) {
    ErrorRun run;
    if (!readRun(line, run))
      throw UsageError(
          fmt::format("{}:{}: this is no line of bench error; remove it, or name another file.",
                      file.string(), number));
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace pathmark::bench
