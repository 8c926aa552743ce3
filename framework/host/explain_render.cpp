#include "host/explain_render.h"

#include "host/adaptive_render.h"
#include "light_paths/explain.h"
#include "render/explain_plan.h"
#include "render/pixel_block.h"
#include "scene/normalise.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace pathmark {

namespace {

std::string plural(std::uint64_t n, const char* one) {
  return n == 1 ? fmt::format("1 {}", one) : fmt::format("{} {}s", n, one);
}

PlanLine points(const RenderSettings& settings) {
  const std::uint64_t rays = settings.raysPerReplicate();
  const std::uint64_t passes = (rays + settings.raysPerPass() - 1) / settings.raysPerPass();
  return {"points",
          fmt::format(
              "{}, {} per pixel in {} of {} at most", nameOf(settings.sampler), plural(rays, "ray"),
              passes == 1 ? "1 pass" : fmt::format("{} passes", passes), settings.raysPerPass()),
          fmt::format("seed {}", settings.seed)};
}

PlanLine pathsOfRays(const RenderSettings& settings) {
  return {"camera rays", fmt::format("{} paths each", settings.sharing.pathsPerRay),
          settings.sharing.directLight != 0 ? "they share the first surface and its direct light"
                                            : "they share the first surface"};
}

PlanLine pathsOfBlocks(const PathSharing& sharing) {
  const PixelBlock block = blockOf(sharing.pixels);
  std::string decision = fmt::format("shared in blocks of {}x{}", block.width, block.height);
  if (sharing.directPaths > 1)
    decision += fmt::format(", {} for the direct light of each camera ray", sharing.directPaths);
  return {"paths of pixels", decision, "the errors of their pixels are not independent"};
}

PlanLine replicates(const RenderSettings& settings) {
  if (settings.replicates == 1)
    return {"replicates", "1", "without --replicates no variance is told"};
  return {"replicates", fmt::format("{}, with such points each", settings.replicates),
          "their differences tell the variance of every pixel"};
}

// Of a picture with a stated error.
std::vector<PlanLine> adaptiveLines(const RenderSettings& settings, double relativeError) {
  constexpr std::uint32_t kFilms = AdaptiveRender::kFilms, kPass = AdaptiveRender::kPilotRays;
  const std::uint64_t most = AdaptiveRender::mostRays(settings.raysPerPixel);
  const std::uint64_t passes = most / kFilms / kPass;
  return {{"rays",
           fmt::format("from {} to {} per pixel, as many as each tile needs for an error of {:g} %",
                       kFilms * kPass, most, 100.0 * relativeError),
           "two halves of the picture decide for each other"},
          {"points",
           fmt::format("{}, for each of {} films, in {} of {}", nameOf(settings.sampler), kFilms,
                       passes == 1 ? "1 pass" : fmt::format("1 to {} passes", passes), kPass),
           fmt::format("seed {}", settings.seed)},
          {"replicates", fmt::format("{}, the films", kFilms),
           "their differences tell the variance of every pixel"}};
}

PlanLine threads(const RenderSettings& settings) {
  const auto across = [](int pixels) { return (pixels + kTileSize - 1) / kTileSize; };
  const int tiles = across(settings.width) * across(settings.height);
  return {"threads",
          fmt::format("{}, tiles of {}x{} pixels: {} in {}x{}", settings.threads, kTileSize,
                      kTileSize, tiles, settings.width, settings.height),
          "the picture does not depend on them"};
}

PlanLine coordinates(const LoadedScene& scene) {
  const Normalisation& n = scene.normalisation;
  if (isIdentity(n))
    return {"coordinates", "the file's", "floats are accurate where the scene is, and at its size"};
  std::vector<std::string> changes, reasons;
  if (n.shift != std::array{0.0, 0.0, 0.0}) {
    changes.push_back(
        fmt::format("({:g}, {:g}, {:g}) moved to the origin", n.shift[0], n.shift[1], n.shift[2]));
    reasons.emplace_back("far from the origin for its size");
  }
  if (n.scale != 1.0) {
    changes.push_back(fmt::format("scaled by {:g}", n.scale));
    reasons.emplace_back(n.scale > 1.0 ? "small" : "large");
  }
  return {"coordinates", fmt::format("{}", fmt::join(changes, ", ")),
          fmt::format("the scene is {}: floats are more accurate so", fmt::join(reasons, " and "))};
}

// Part 0 brings its own intersection, and no lights are sampled.
std::vector<PlanLine> warmUpLines(const FlatSceneView& scene) {
  return {
      {"triangles", fmt::format("{}, met by part 0", scene.triangles.size()),
       "--warm-up gives get_ray_radiance all triangles"},
      {"spheres", scene.spheres.empty() ? "none" : fmt::format("{} left out", scene.spheres.size()),
       "part 0 knows triangles only"}};
}

// `rays`: the lines that tell how many there are, and with which points.
std::string explain(const LoadedScene& scene, const RenderSettings& settings,
                    const std::vector<PlanLine>& rays) {
  const FlatSceneView view = viewOf(scene.flat);
  std::vector<PlanLine> lines = settings.estimator == Estimator::kWarmUp
                                    ? warmUpLines(view)
                                    : explainPlan(planFor(view), view);
  if (!settings.paths.empty())
    for (PlanLine& line : explainLightPaths(PathExpression(settings.paths), view))
      lines.push_back(std::move(line));
  if (settings.estimator == Estimator::kSplit) lines.push_back(pathsOfRays(settings));
  if (settings.estimator == Estimator::kReuse) lines.push_back(pathsOfBlocks(settings.sharing));
  lines.insert(lines.end(), rays.begin(), rays.end());
  lines.insert(lines.end(), {threads(settings), coordinates(scene)});
  std::size_t width = 0;
  for (const PlanLine& line : lines) width = std::max(width, line.what.size());
  std::string text;
  for (const PlanLine& line : lines) {
    fmt::format_to(std::back_inserter(text), "{:<{}}  {}", line.what + ":", width + 1,
                   line.decision);
    text += line.why.empty() ? "\n" : fmt::format(" ({})\n", line.why);
  }
  return text;
}

}  // namespace

std::string explainRender(const LoadedScene& scene, const RenderSettings& settings) {
  return explain(scene, settings, {points(settings), replicates(settings)});
}

std::string explainRenderToTarget(const LoadedScene& scene, const RenderSettings& settings,
                                  double relativeError) {
  return explain(scene, settings, adaptiveLines(settings, relativeError));
}

}  // namespace pathmark
