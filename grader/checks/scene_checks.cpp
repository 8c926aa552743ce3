#include "checks/scene_checks.h"

#include "checks/small_render.h"
#include "scene/load_scene.h"
#include "scene/utf8.h"
#include "stats/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks {

namespace {

namespace fs = std::filesystem;

constexpr int kLongestSide = 40;
constexpr int kMostRays = 64;  // of a pixel
// Where those have found nothing: light may come on few paths only.
constexpr int kRaysInTheDark = 512;
constexpr std::uint64_t kReplicates = 8;
constexpr int kTiles = 8;  // in each direction

std::vector<fs::path> sceneFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The same picture with fewer pixels.
FlatScene loadShrunk(const fs::path& file, const LoadedScene& scene) {
  const double width = scene.flat.camera.width, height = scene.flat.camera.height;
  const double factor = std::min(kLongestSide / std::max(width, height), 1.0);
  const auto side = [&](double full) {
    return std::max(static_cast<int>(std::lround(full * factor)), 1);
  };
  return loadScene(file, {.size = {{side(width), side(height)}}}).flat;
}

struct TileNoise {
  double x, y;       // its middle, as shares of the picture
  double deviation;  // of a pixel's values relative to them, root mean square
};

std::vector<TileNoise> tileNoise(const std::vector<PlainImage>& replicates) {
  const int width = replicates[0].width, height = replicates[0].height;
  std::vector<stats::RunningMoments> values(replicates[0].rgb.size());
  for (const PlainImage& image : replicates)
    for (std::size_t v = 0; v < values.size(); ++v) values[v].add(image.rgb[v]);
  double dark = 0.0;  // a tenth of the picture's mean: what is darker is not blown up
  for (const stats::RunningMoments& value : values)
    dark += 0.1 * value.mean() / static_cast<double>(values.size());
  std::vector<TileNoise> tiles;
  for (int row = 0; row < kTiles; ++row)
    for (int column = 0; column < kTiles; ++column) {
      const int left = column * width / kTiles, right = (column + 1) * width / kTiles,
                top = row * height / kTiles, bottom = (row + 1) * height / kTiles;
      double sum = 0.0, count = 0.0;
      for (int j = top; j < bottom; ++j) {
        const auto line = values.begin() + std::ptrdiff_t{3} * width * j;
        for (int k = 3 * left; k < 3 * right; ++k) {
          const stats::RunningMoments& value = line[k];
          const double size = std::max({value.mean(), dark, 1e-30});
          sum += value.variance() / (size * size);
          ++count;
        }
      }
      if (count == 0.0) continue;
      tiles.push_back(
          {0.5 * (left + right) / width, 0.5 * (top + bottom) / height, std::sqrt(sum / count)});
    }
  return tiles;
}

bool isBlack(const PlainImage& image) {
  return std::all_of(image.rgb.begin(), image.rgb.end(), [](double v) { return v == 0.0; });
}

std::string percent(double share) {
  const double value = 100.0 * share;
  return value < 9.5 ? fmt::format("{:.1g}%", value) : fmt::format("{:.0f}%", value);
}

std::string noiseInWords(std::vector<TileNoise> tiles, int rays) {
  std::sort(tiles.begin(), tiles.end(),
            [](const TileNoise& a, const TileNoise& b) { return a.deviation > b.deviation; });
  const TileNoise& worst = tiles.front();
  if (worst.deviation == 0.0) return "there is none";
  const double median = tiles[tiles.size() / 2].deviation;
  return fmt::format(
      "most of it is in the {}: with {} rays a pixel there is off by about {}, and {}",
      placeInWords(worst.x, worst.y), rays, percent(worst.deviation),
      median == 0.0 ? "half of the picture has none"
                    : fmt::format("in half of the picture by less than {}", percent(median)));
}

struct Rendered {
  std::vector<PlainImage> replicates;
  std::optional<Finding> invalid;

  bool black() const { return std::all_of(replicates.begin(), replicates.end(), isBlack); }
};

Rendered renderReplicates(const SceneFinding& finding, const LoadedScene& scene, CheckRun& run,
                          int rays) {
  SmallRender small(run, loadShrunk(finding.file, scene), scene.name,
                    static_cast<std::uint64_t>(rays));
  Rendered rendered;
  for (std::uint64_t k = 0; k < kReplicates && !small.invalid(); ++k)
    rendered.replicates.push_back(small.render(k).image());
  rendered.invalid = small.invalid();
  return rendered;
}

void render(SceneFinding& finding, const LoadedScene& scene, WorkerProcess& worker,
            std::uint64_t seed) {
  stats::ErrorBudget unused;
  CheckRun run{worker, seed, unused};
  int rays = std::min(scene.raysPerPixel, kMostRays);
  Rendered rendered = renderReplicates(finding, scene, run, rays);
  if (!rendered.invalid && rendered.black()) {
    rays = kRaysInTheDark;
    rendered = renderReplicates(finding, scene, run, rays);
  }
  if (rendered.invalid) {
    finding.status = Status::kFail;
    finding.message = fmt::format("{}: {}", rendered.invalid->where, rendered.invalid->got);
  } else if (rendered.black()) {
    finding.status = Status::kFail;
    finding.message = "the picture is black: no light of the scene reaches what the camera sees";
  } else {
    finding.noise = noiseInWords(tileNoise(rendered.replicates), rays);
  }
}

SceneFinding checkScene(const fs::path& file, const WholeWorker& worker, std::uint64_t seed) {
  SceneFinding finding{file, Status::kPass, {}, {}, {}};
  try {
    const LoadedScene scene = loadScene(file);
    if (isBlank(scene.caption)) {
      finding.status = Status::kNotWritten;
      finding.message = "its caption is empty: what does the picture show, where, and why?";
    } else if (!worker.blocker.empty()) {
      finding.status = Status::kBlocked;
      finding.message = worker.blocker;
    } else {
      render(finding, scene, worker.get(), seed);
    }
  } catch (const SceneError& e) {
    finding.status = Status::kFail;
    finding.message = e.what();
  } catch (const WorkerError& e) {
    worker.forget();
    finding.status = Status::kBroken;
    finding.message = e.what();
    finding.fault = e.fault();
  }
  return finding;
}

}  // namespace

std::vector<SceneFinding> checkScenes(const fs::path& coursework, const WholeWorker& worker,
                                      std::uint64_t seed) {
  std::vector<SceneFinding> findings;
  try {
    for (const fs::path& file : sceneFiles(coursework / "scenes")) {
      if (!worker.goOn()) break;
      findings.push_back(checkScene(file, worker, seed));
    }
  } catch (const WorkerStopped&) {
    // In the middle of a scene, of which there is nothing to say.
  }
  return findings;
}

}  // namespace pathmark::checks
