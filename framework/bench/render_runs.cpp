#include "bench/render_runs.h"

#include "bench/interrupted_run.h"
#include "film/image_file.h"
#include "host/blob_file.h"
#include "host/display_path.h"
#include "host/reference.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace pathmark::bench {

namespace fs = std::filesystem;

BenchScene loadBenchScene(const std::string& key, const std::string& name) {
  findScene(name);
  const fs::path file = shippedSceneFile(name);
  if (!fs::exists(file))
    throw UsageError(fmt::format("{} is no scene in scenes/: only those have references.", name));
  if (needsShippedBlobFile(file) && makeShippedBlobFile())
    fmt::print(stderr, "Made {}, the mesh of the scene {}.\n", displayPath(shippedBlobFile()),
               name);
  BenchScene scene{key, name, loadScene(file), {}};
  std::optional<ImageFile> reference = readReference(scene.scene);
  if (!reference || reference->image.variance.empty())
    throw UsageError(
        fmt::format("The scene {} has no reference that fits it; ./pathmark reference {} makes it.",
                    name, name));
  scene.reference = std::move(reference->image);
  return scene;
}

RenderRuns::RenderRuns(const Coursework& coursework, fs::path folder)
    : coursework_(coursework), folder_(std::move(folder)) {}

fs::path RenderRuns::picture(const RenderRun& run) const {
  return folder_ / (fs::path(run.scene).stem().string() + ".exr");
}

std::vector<std::string> RenderRuns::words(const RenderRun& run) const {
  std::vector<std::string> words{"/proc/self/exe",
                                 "render",
                                 run.scene,
                                 "--with",
                                 coursework_.folder.string(),
                                 "--rays-per-pixel",
                                 std::to_string(run.raysPerPixel),
                                 "--seed",
                                 std::to_string(run.seed),
                                 "--threads",
                                 std::to_string(run.threads),
                                 "--checkpoint-every",
                                 "0",
                                 "--output",
                                 picture(run).string()};
  if (!run.size.empty()) words.insert(words.end(), {"--size", run.size});
  words.insert(words.end(), run.options.begin(), run.options.end());
  return words;
}

void RenderRuns::requireSuccess(int exitCode, const RenderRun& run) const {
  if (exitCode == 0) return;
  stopIfInterrupted();
  std::ifstream in(log());
  throw CourseworkError(fmt::format("Rendering {} failed: {}", run.scene,
                                    std::string(std::istreambuf_iterator<char>(in), {})));
}

RunResult RenderRuns::render(const RenderRun& run) const {
  RunResult result;
  result.usage = runMeasured(words(run), log());
  requireSuccess(result.usage.exitCode, run);
  ImageFile file = readImage(picture(run));
  result.image = std::move(file.image);
  result.renderSeconds = file.origin.seconds;
  return result;
}

PeakMemory RenderRuns::memory(const RenderRun& run) const {
  const PeakMemory peak = measureMemory(words(run), log());
  requireSuccess(peak.exitCode, run);
  return peak;
}

double RenderRuns::raysPerPath(const LoadedScene& scene) const {
  RenderOptions options;
  options.raysPerPixel = 16;
  const RenderedImage made = renderScene(coursework_, scene, options).rendered;
  stopIfInterrupted();
  const double pixels = static_cast<double>(made.image.width) * made.image.height;
  return static_cast<double>(made.raysTraced) / (pixels * made.raysPerPixel);
}

}  // namespace pathmark::bench
