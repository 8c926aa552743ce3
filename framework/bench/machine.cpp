#include "bench/machine.h"

#include "host/build_config.h"

#include <fmt/format.h>

#if PATHMARK_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

namespace pathmark::bench {

namespace {

// The text after the colon of the first line that begins so.
std::string valueOf(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with(key) || colon == std::string::npos) continue;
    const std::size_t start = line.find_first_not_of(" \t", colon + 1);
    return start == std::string::npos ? "" : line.substr(start);
  }
  return "";
}

constexpr const char* compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

constexpr const char* vectors() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__SSE2__)
  return "SSE2";
#else
  return "no known vector instructions";
#endif
}

}  // namespace

std::string machineLine() {
  const std::string model = valueOf("/proc/cpuinfo", "model name");
  return fmt::format(
      "{}, {} processors, compiled for {}; {}, {}{}; Embree {}",
      model.empty() ? "Unknown processor" : model, std::thread::hardware_concurrency(), vectors(),
      compiler(), build::kBuildType,
      build::kSanitized ? fmt::format(" with -fsanitize={}", build::kSanitizers) : "",
      RTC_VERSION_STRING);
}

std::uint64_t availableMemory() {
  std::uint64_t kilobytes = 0;
  if (!(std::istringstream(valueOf("/proc/meminfo", "MemAvailable")) >> kilobytes))
    return std::numeric_limits<std::uint64_t>::max();
  return kilobytes << 10;
}

}  // namespace pathmark::bench
