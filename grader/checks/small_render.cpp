#include "checks/small_render.h"

#include "host/render_loop.h"
#include "host/session.h"
#include "sampling/mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <thread>

namespace pathmark::checks {

PlainImage RenderedFilm::image() const {
  PlainImage result{width, height, {}};
  result.rgb.reserve(3 * pixels.size());
  for (const FilmPixel& pixel : pixels)
    for (const double sum : pixel.sum)
      result.rgb.push_back(pixel.rays > 0.0 ? sum / pixel.rays : 0.0);
  return result;
}

SmallRender::SmallRender(CheckRun& run, const FlatScene& scene, std::string name,
                         std::uint64_t raysPerPixel, Estimator estimator)
    : run_(run),
      name_(std::move(name)),
      width_(static_cast<int>(scene.camera.width)),
      height_(static_cast<int>(scene.camera.height)),
      raysPerPixel_(raysPerPixel),
      estimator_(estimator) {
  run.worker.loadScene(scene);
}

RenderedFilm SmallRender::render(std::uint64_t number, unsigned threads) {
  RenderSettings settings;
  settings.width = width_;
  settings.height = height_;
  settings.raysPerPixel = raysPerPixel_;
  settings.estimator = estimator_;
  settings.threads = threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  settings.seed = mix(run_.seed + kGolden * (number + 1));
  ImageRender image(run_.worker, settings);
  while (!image.finished()) image.step([](const RenderStatus&) { return true; });
  RenderState state = image.takeState();
  rays_ += settings.pixels() * settings.raysPerPixel;
  if (!invalid_ && state.invalid.count() > 0) {
    const auto row = state.invalid.firstPixel / static_cast<std::uint64_t>(width_),
               column = state.invalid.firstPixel % static_cast<std::uint64_t>(width_);
    Finding finding;
    finding.status = Status::kFail;
    finding.where = fmt::format("{} in {} x {} pixels, the pixel in column {} and row {} ({})",
                                name_, width_, height_, column + 1, row + 1,
                                placeInWords((static_cast<double>(column) + 0.5) / width_,
                                             (static_cast<double>(row) + 0.5) / height_));
    finding.expected = "radiances: finite, and at least 0";
    finding.got = fmt::format("{} NaN, {} infinite and {} negative values of {}", state.invalid.nan,
                              state.invalid.infinite, state.invalid.negative, settings.pixels());
    invalid_ = finding;
  }
  return {width_, height_, std::move(state.film), state.invalid};
}

std::vector<std::vector<double>> SmallRender::replicates(const ImageFeatures& features,
                                                         std::uint64_t first, std::uint64_t count) {
  std::vector<std::vector<double>> all;
  for (std::uint64_t r = 0; r < count; ++r) {
    all.push_back(features.of(render(first + r).image()));
    if (invalid_) return {};
  }
  return all;
}

PlainImage SmallRender::mean(std::uint64_t first, std::uint64_t count) {
  PlainImage mean{width_, height_, {}};
  mean.rgb.resize(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (std::uint64_t r = 0; r < count; ++r) {
    const PlainImage one = render(first + r).image();
    for (std::size_t v = 0; v < mean.rgb.size(); ++v)
      mean.rgb[v] += one.rgb[v] / static_cast<double>(count);
  }
  return mean;
}

SmallScene loadSmall(const std::string& name) {
  constexpr int kAbout = 32;
  const std::filesystem::path file = shippedSceneFile(name);
  const FlatCamera camera = loadScene(file).flat.camera;
  const int width = static_cast<int>(camera.width), height = static_cast<int>(camera.height);
  // Of the whole numbers that divide both sides, the one that comes nearest.
  int best = 1;
  for (int k = 1; k <= width; ++k) {
    if (width % k != 0 || height % k != 0) continue;
    if (std::abs(width / k - kAbout) < std::abs(width / best - kAbout)) best = k;
  }
  return {loadScene(file, {.size = {{width / best, height / best}}}).flat, best};
}

}  // namespace pathmark::checks
