// Every shipped scene in other units and at other places, through the reader of scenes, against the
// scene as it is. The random numbers are the same, so that pictures differ by rounding alone.
#include "bench/stress/block_difference.h"
#include "bench/stress/coarse_blob.h"
#include "bench/stress/moved_scene.h"
#include "bench/stress/stress.h"
#include "host/blob_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pathmark::bench {

namespace {

constexpr int kSide = 32;
constexpr double kSimilaritySteps = 360.0;
constexpr std::array kTolerances{0.001, 0.01, 0.05};

// As far as pictures must stay the same, and as far as they are meant to.
constexpr Similarity kMust{1e6, 1e4}, kAim{1e30, 1e9};

bool within(const Similarity& similarity, const Similarity& range) {
  return std::abs(std::log10(similarity.scale)) < std::log10(range.scale) + 0.5 &&
         std::abs(similarity.shift) < 1.5 * range.shift;
}

struct Difference : BlockDifference {
  Similarity similarity;
};

// Where pictures must stay the same, and are meant to.
std::vector<Similarity> askedPlaces(bool quick) {
  if (quick) return {{1e-6, 1e4}, {1e6, -1e4}, {1e-30, 0.0}, {1e30, -1e9}};
  return {{1e-6, 1e4}, {1e6, -1e4}, {1e-30, 1e9}, {1e30, -1e9}};
}

// Farther and farther, until they do not.
std::vector<Similarity> fartherPlaces() {
  std::vector<Similarity> all;
  for (const double k : {1., 2., 3., 6., 10., 20., 30., 60., 100.})
    for (const double sign : {-1.0, 1.0}) all.push_back({std::pow(10.0, sign * k), 0.0});
  for (const double k : {1., 2., 4., 6., 9., 10., 11., 12., 13., 14.})
    all.push_back({1.0, std::pow(10.0, k)});
  return all;
}

// The shipped scenes, of which the blob has fewer triangles in a short run.
class Scenes {
 public:
  explicit Scenes(bool quick) {
    constexpr int kFewSubdivisions = 40;
    if (quick)
      coarse_.emplace(kFewSubdivisions);
    else
      makeShippedBlobFile();
  }

  LoadedScene load(const std::string& name, const Similarity& similarity) const {
    const std::filesystem::path file = shippedSceneFile(name);
    SceneOverrides overrides;
    overrides.size = {kSide, kSide};
    const bool coarse = coarse_ && needsShippedBlobFile(file);
    return loadScene(
        SceneSource{coarse ? coarse_->sceneFile() : file, movedScene(file, similarity)}, overrides);
  }

 private:
  std::optional<CoarseBlob> coarse_;
};

std::string power(double value) {
  return value == 1.0 ? "1" : fmt::format("1e{:.0f}", std::log10(value));
}

// From the smallest to the largest scale up to which, from 1 on, all that were tried hold.
std::string rangeOfScales(const std::vector<Difference>& all, double BlockDifference::*error,
                          double tolerance) {
  double low = 1.0, high = 1.0, failedLow = 0.0, failedHigh = INFINITY;
  const auto only = [](const Difference& d) { return d.similarity.shift == 0.0; };
  for (const Difference& d : all)
    if (only(d) && !(d.*error <= tolerance)) {
      double& failed = d.similarity.scale < 1.0 ? failedLow : failedHigh;
      failed = d.similarity.scale < 1.0 ? std::max(failed, d.similarity.scale)
                                        : std::min(failed, d.similarity.scale);
    }
  for (const Difference& d : all)
    if (only(d) && d.similarity.scale > failedLow && d.similarity.scale < failedHigh) {
      low = std::min(low, d.similarity.scale);
      high = std::max(high, d.similarity.scale);
    }
  return fmt::format("{}..{}", power(low), power(high));
}

std::string rangeOfShifts(const std::vector<Difference>& all, double BlockDifference::*error,
                          double tolerance) {
  double failed = INFINITY, reached = 0.0;
  const auto only = [](const Difference& d) { return d.similarity.scale == 1.0; };
  for (const Difference& d : all)
    if (only(d) && !(d.*error <= tolerance)) failed = std::min(failed, d.similarity.shift);
  for (const Difference& d : all)
    if (only(d) && d.similarity.shift < failed) reached = std::max(reached, d.similarity.shift);
  return reached == 0.0 ? "0" : power(reached);
}

double worstWithin(const std::vector<Difference>& all, const Similarity& range,
                   double BlockDifference::*error) {
  double worst = 0.0;
  for (const Difference& d : all)
    if (within(d.similarity, range)) worst = std::max(worst, d.*error);
  return worst;
}

void addRows(Stress& stress, const std::string& scene, const std::vector<Difference>& asked,
             const std::vector<Difference>& farther) {
  for (const auto& [of, error] :
       {std::pair{"mean", &BlockDifference::mean}, std::pair{"blocks", &BlockDifference::block}}) {
    std::vector<Cell> cells{scene, std::string(of), 100.0 * worstWithin(asked, kMust, error),
                            100.0 * worstWithin(asked, kAim, error)};
    for (const double tolerance : kTolerances)
      cells.emplace_back(farther.empty() ? "" : rangeOfScales(farther, error, tolerance));
    for (const double tolerance : kTolerances)
      cells.emplace_back(farther.empty() ? "" : rangeOfShifts(farther, error, tolerance));
    stress.row(std::move(cells));
  }
}

class SimilarityRun {
 public:
  explicit SimilarityRun(Stress& stress)
      : stress_(stress), scenes_(stress.quick), worker_(stress) {}

  // Of all these places against the scene as it is.
  std::vector<Difference> differences(const std::string& name,
                                      const std::vector<Similarity>& places, std::uint64_t rays,
                                      double steps) {
    std::vector<Difference> all;
    if (places.empty()) return all;
    const double step = steps / static_cast<double>(places.size() + 1);
    const std::vector<double> original = sumsAt(name, {}, rays, step);
    for (const Similarity& place : places) {
      try {
        all.push_back({blockDifference(sumsAt(name, place, rays, step), original), place});
      } catch (const SceneError&) {
        all.push_back({{INFINITY, INFINITY}, place});  // beyond what a scene may hold
      }
    }
    return all;
  }

 private:
  std::vector<double> sumsAt(const std::string& name, const Similarity& place, std::uint64_t rays,
                             double step) {
    stress_.progress.show(
        fmt::format("{}, scale {:g}, moved by {:g} sizes", name, place.scale, place.shift));
    const LoadedScene scene = scenes_.load(name, place);
    RenderOptions options;
    options.raysPerPixel = rays;
    worker_.load(scene.flat);
    const RenderedImage image = worker_.render(settingsFor(scene, options));
    stress_.progress.advance(step);
    return blockSums(image.image);
  }

  Stress& stress_;
  Scenes scenes_;
  StressWorker worker_;
};

}  // namespace

void stressSimilarity(Stress& stress) {
  constexpr std::uint64_t kFewRays = 256;
  const std::uint64_t rays = stress.quick ? kFewRays : 4096;
  stress.begin(
      {.key = "similarity",
       .title = fmt::format("Similarity: {0}x{0} pixels; largest differences in % with {1} "
                            "rays per pixel; where 0.1, 1 and 5 % hold, with {2}",
                            kSide, rays, kFewRays),
       .columns = {{"scene", "scene"},
                   {"of", "of"},
                   {"must", "1e+-6, 1e4 sizes", 4},
                   {"aim", "1e+-30, 1e9 sizes", 4},
                   {"scales0.1", "scales: 0.1 %"},
                   {"scales1", "1 %"},
                   {"scales5", "5 %"},
                   {"shifts0.1", "sizes: 0.1 %"},
                   {"shifts1", "1 %"},
                   {"shifts5", "5 %"}},
       .rows = {}});
  SimilarityRun run(stress);
  BlockDifference must, aim;
  const auto include = [](BlockDifference& worst, const std::vector<Difference>& all,
                          const Similarity& range) {
    worst.mean = std::max(worst.mean, worstWithin(all, range, &BlockDifference::mean));
    worst.block = std::max(worst.block, worstWithin(all, range, &BlockDifference::block));
  };
  const std::vector<std::string> names = shippedSceneNames();
  const double steps = kSimilaritySteps / static_cast<double>(names.size());
  for (const std::string& name : names) {
    const auto asked = run.differences(name, askedPlaces(stress.quick), rays, 0.7 * steps);
    const auto farther = run.differences(
        name, stress.quick ? std::vector<Similarity>{} : fartherPlaces(), kFewRays, 0.3 * steps);
    addRows(stress, name, asked, farther);
    include(must, asked, kMust);
    include(aim, asked, kAim);
  }
  constexpr double kSame = 0.001, kFarSame = 0.01;
  stress.addError("similarMean", "picture's mean, scales 1e+-6, moved by 1e4 sizes", must.mean,
                  kSame, kSame);
  stress.addError("similarBlocks", "each block of 8x8 pixels, the same", must.block, kSame, kSame);
  stress.addError("similarMeanFar", "picture's mean, scales 1e+-30, moved by 1e9 sizes", aim.mean,
                  kFarSame, kSame);
  stress.addError("similarBlocksFar", "each block, the same", aim.block, kFarSame, kSame);
}

}  // namespace pathmark::bench
