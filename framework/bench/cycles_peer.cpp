#include "bench/cycles_peer.h"

#include "bench/cycles_scene.h"
#include "bench/interrupted_run.h"
#include "film/image_file.h"
#include "host/build_config.h"
#include "host/subprocess.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// What the script prints.
double renderCpuSeconds(const std::string& text) {
  const std::string words = "render CPU seconds:";
  const std::size_t at = text.find(words);
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + words.size()));
}

}  // namespace

std::optional<CyclesPeer> CyclesPeer::find(const fs::path& folder) {
  try {
    const ProcessResult result =
        runProcess({.arguments = {"blender", "--version"}, .input = {}, .folder = {}});
    if (result.exitCode != 0) return std::nullopt;
    return CyclesPeer(folder, result.output.substr(0, result.output.find('\n')));
  } catch (const std::system_error&) {
    return std::nullopt;
  }
}

CyclesResult CyclesPeer::render(const BenchScene& scene, std::uint64_t raysPerPixel,
                                std::uint64_t seed, const CyclesPlace& place) const {
  const CyclesJob job{raysPerPixel, seed, folder_ / fmt::format("cycles_{}.exr", scene.name),
                      place};
  const fs::path file = writeCyclesScene(scene, job, folder_);
  const fs::path script = fs::path(build::kProjectFolder) / "framework/bench/cycles_scene.py";
  const fs::path log = folder_ / "cycles.txt";
  fs::remove(job.output);
  CyclesResult result;
  result.usage = runMeasured({"blender", "--background", "--factory-startup", "--python-exit-code",
                              "1", "--python", script.string(), "--", file.string()},
                             log);
  stopIfInterrupted();
  const std::string said = textOf(log);
  if (result.usage.exitCode != 0 || !fs::exists(job.output))
    throw std::runtime_error(fmt::format("Cycles did not render {}: {}", scene.name, said));
  result.renderCpuSeconds = renderCpuSeconds(said);
  result.image = readImage(job.output).image;
  return result;
}

}  // namespace pathmark::bench
