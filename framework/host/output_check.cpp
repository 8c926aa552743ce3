#include "host/output_check.h"

#include "film/atomic_file.h"
#include "film/image_file.h"
#include "host/output_file.h"
#include "host/session.h"

#include <fmt/format.h>

#include <string>

#include <sys/statvfs.h>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// What the picture takes at the very least: nothing is known yet of how well it can be compressed.
std::uint64_t fewestBytes(const fs::path& output, std::uint64_t pixels) {
  const bool uncompressed = imageEnding(output) == ".pfm";
  return uncompressed ? pixels * 12 : pixels;
}

std::string size(std::uint64_t bytes) {
  return bytes < (1u << 20) ? fmt::format("{} KiB", bytes >> 10)
                            : fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20));
}

void refuseFullFileSystem(const fs::path& output, const fs::path& folder, std::uint64_t needed) {
  struct statvfs system = {};
  // File systems without blocks do not know how much they hold.
  if (statvfs(folder.c_str(), &system) != 0 || system.f_blocks == 0) return;
  const std::uint64_t free = std::uint64_t{system.f_bavail} * system.f_frsize;
  if (free < needed)
    throw ImageError(fmt::format("{} cannot be written: it takes at least {}, and {} are free.",
                                 output.string(), size(needed), size(free)));
}

}  // namespace

void refuseOutput(const fs::path& output, std::uint64_t pixels) {
  std::string why;
  if (!imageFormatKnown(output, why)) throw UsageError(why);
  requirePlaceForFile("--output", output);
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  refuseFullFileSystem(output, folder, fewestBytes(output, pixels));
  tryToWriteBeside(output);
}

}  // namespace pathmark
