#include "bench/targets/own_command.h"

#include "bench/interrupted_run.h"
#include "host/exit_code.h"
#include "host/session.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <fstream>
#include <iterator>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

std::string contentsOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Seconds until the file has these words, or the process has ended.
double untilSaid(const fs::path& file, std::string_view words, const std::stop_token& ended) {
  const auto started = Clock::now();
  while (!ended.stop_requested() && contentsOf(file).find(words) == std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return std::chrono::duration<double>(Clock::now() - started).count();
}

// Each second, until it is to end.
void relayProgress(const fs::path& log, const std::function<void(const LoggedProgress&)>& show,
                   const std::stop_token& ended) {
  std::mutex mutex;
  std::condition_variable_any ending;
  std::unique_lock lock(mutex);
  while (!ending.wait_for(lock, ended, std::chrono::seconds(1),
                          [&] { return ended.stop_requested(); }))
    if (const auto progress = lastProgressIn(contentsOf(log))) show(*progress);
}

[[noreturn]] void fail(const std::vector<std::string>& arguments, const OwnRun& run,
                       const fs::path& log) {
  throw CourseworkError(fmt::format("{} ended with exit code {}: {}", fmt::join(arguments, " "),
                                    run.usage.exitCode, contentsOf(log)));
}

}  // namespace

OwnRun runOwn(const std::vector<std::string>& arguments, const fs::path& log,
              std::string_view words) {
  std::vector<std::string> line = arguments;
  line.insert(line.begin(), "/proc/self/exe");
  fs::remove(log);
  OwnRun run;
  std::jthread watch(
      [&](const std::stop_token& ended) { run.saidSeconds = untilSaid(log, words, ended); });
  run.usage = runMeasured(line, log);
  watch.request_stop();
  watch.join();
  stopIfInterrupted();
  if (run.usage.exitCode != kSuccess && run.usage.exitCode != kCourseworkFault)
    fail(arguments, run, log);
  return run;
}

nlohmann::ordered_json ownReport(std::vector<std::string> arguments, const fs::path& scratch,
                                 const std::function<void(const LoggedProgress&)>& show) {
  const fs::path file = scratch / "report.json";
  arguments.insert(arguments.begin(), "bench");
  arguments.insert(arguments.end(), {"--json", file.string()});
  const fs::path log = scratch / "log.txt";
  const OwnRun run = [&] {
    const std::jthread relay(
        [&](const std::stop_token& ended) { relayProgress(log, show, ended); });
    return runOwn(arguments, log);
  }();
  if (run.usage.exitCode != kSuccess) fail(arguments, run, log);
  return nlohmann::ordered_json::parse(contentsOf(file));
}

}  // namespace pathmark::bench
