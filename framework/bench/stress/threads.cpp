// Pictures have the same bits for any number of threads and any order of their tiles.
#include "bench/interrupted_run.h"
#include "bench/stress/stress.h"
#include "host/shared_memory.h"
#include "sampling/mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace pathmark::bench {

namespace {

constexpr int kSide = 80;  // five tiles

LoadedScene small(const std::string& name) {
  SceneOverrides overrides;
  overrides.size = {kSide, kSide};
  return loadScene(shippedSceneFile(name), overrides);
}

std::vector<PixelRegion> tilesInRandomOrder(std::uint64_t seed) {
  std::vector<PixelRegion> tiles;
  for (int top = 0; top < kSide; top += kTileSize)
    for (int left = 0; left < kSide; left += kTileSize)
      tiles.push_back({left, top, kTileSize, kTileSize});
  for (std::size_t k = tiles.size(); k > 1; --k) std::swap(tiles[k - 1], tiles[mix(seed + k) % k]);
  return tiles;
}

// The same rays as of a render with these settings, tile by tile.
std::vector<FilmPixel> filmInOrder(StressWorker& worker, const RenderSettings& settings,
                                   std::uint64_t seed) {
  SharedFilm film(settings.width, settings.height);
  for (const PixelRegion& tile : tilesInRandomOrder(seed)) {
    RenderJob job = jobOf(settings, 0);
    job.rays = settings.raysPerPixel;
    job.region = tile;
    worker.process().render(job, film, [](const RenderProgress&) { return !interrupted(); });
    stopIfInterrupted();
  }
  return {film.pixels().begin(), film.pixels().end()};
}

}  // namespace

void stressThreads(Stress& stress) {
  stress.begin({.key = "threads",
                .title = "Threads and tiles: values that differ from those of one thread",
                .columns = {{"scene", "scene"},
                            {"sampler", "sampler"},
                            {"two", "2 threads", 0},
                            {"four", "4", 0},
                            {"seven", "7", 0},
                            {"order", "other order", 0}},
                .rows = {}});
  StressWorker worker(stress);
  double different = 0.0;
  const std::vector<std::string> names{"cornell_box", "cornell_spheres", "many_lights",
                                       "cornell_phong"};
  for (const std::string& name : names)
    for (const SamplerKind kind :
         {SamplerKind::kSobol, SamplerKind::kStratified, SamplerKind::kPcg}) {
      stress.progress.show(fmt::format("{}, {}", name, nameOf(kind)));
      const LoadedScene scene = small(name);
      worker.load(scene.flat);
      RenderOptions options;
      options.raysPerPixel = stress.quick ? 9 : 100;
      options.sampler = kind;
      options.threads = 1;
      const Image one = worker.render(settingsFor(scene, options)).image;
      std::vector<Cell> cells{name, std::string(nameOf(kind))};
      const auto add = [&](const Image& other) {
        const auto values = static_cast<double>(differingValues(one, other));
        different += values;
        cells.emplace_back(values);
      };
      for (const std::uint32_t threads : {2u, 4u, 7u}) {
        options.threads = threads;
        add(worker.render(settingsFor(scene, options)).image);
      }
      options.threads = 3;
      add(imageFromFilm(kSide, kSide, filmInOrder(worker, settingsFor(scene, options), 5)));
      stress.row(std::move(cells));
      stress.progress.advance(15.0 / static_cast<double>(3 * names.size()));
    }
  stress.addFaults("threads", "values that depend on threads or on the order of tiles", different);
}

}  // namespace pathmark::bench
