#include "preview/series.h"

#include <algorithm>

namespace pathmark::preview {

namespace {

constexpr std::uint32_t kReplicates = 8, kReplicatesOfLargePictures = 2;
constexpr std::uint64_t kLargePicture = std::uint64_t{1} << 20;  // pixels

void add(std::vector<FilmPixel>& sums, std::span<const FilmPixel> film) {
  sums.resize(film.size());
  for (std::size_t i = 0; i < film.size(); ++i) {
    for (int c = 0; c < 3; ++c) sums[i].sum[c] += film[i].sum[c];
    sums[i].rays += film[i].rays;
  }
}

void subtract(std::vector<FilmPixel>& sums, std::span<const FilmPixel> film) {
  for (std::size_t i = 0; i < film.size(); ++i) {
    for (int c = 0; c < 3; ++c) sums[i].sum[c] -= film[i].sum[c];
    sums[i].rays -= film[i].rays;
  }
}

}  // namespace

Series::Series(WorkerProcess& worker, const RenderSettings& settings) : settings_(settings) {
  const std::uint32_t count =
      settings.pixels() > kLargePicture ? kReplicatesOfLargePictures : kReplicates;
  for (std::uint32_t k = 0; k < count; ++k) {
    RenderSettings own = settings;
    own.seed = replicateSeed(settings.seed, k);
    replicates_.push_back(std::make_unique<ImageRender>(worker, own));
  }
}

bool Series::finished() const { return replicates_.back()->finished(); }

bool Series::step(double seconds, const std::function<bool()>& goOn) {
  ImageRender& replicate = *replicates_[current_];
  const std::uint64_t before = replicate.state().firstRay;
  if (!replicate.step([&](const RenderStatus&) { return goOn(); }, {seconds, 1.0})) return false;
  if (replicate.state().firstRay == before) return true;
  ++wholePasses_;
  current_ = (current_ + 1) % replicates_.size();
  takeRound();
  return true;
}

// In the first round, those replicates that have their first pass; later only whole rounds.
void Series::takeRound() {
  const std::uint64_t count = replicates_.size();
  if (wholePasses_ < 2 || (wholePasses_ > count && wholePasses_ % count != 0)) return;
  inRound_ = static_cast<std::uint32_t>(std::min(wholePasses_, count));
  round_ = {};
  for (std::uint32_t k = 0; k < inRound_; ++k) addReplicate(round_, replicates_[k]->state().film);
}

Series::Made Series::made() const {
  Made made;
  std::vector<FilmPixel> sums;
  for (const auto& replicate : replicates_) {
    const RenderState& state = replicate->state();
    if (!state.begun()) continue;
    add(sums, state.film);
    made.invalid.add(state.invalid);
    made.seconds += state.seconds;
    made.raysTraced += state.raysTraced;
  }
  if (sums.empty()) sums.resize(settings_.pixels());
  double rays = static_cast<double>(made.invalid.count()) * settings_.raysPerPass();
  for (const FilmPixel& pixel : sums) rays += pixel.rays;
  made.raysPerPixel = rays / static_cast<double>(settings_.pixels());
  if (inRound_ > 0) subtract(sums, round_.film);
  made.image = imageFromReplicates(settings_.width, settings_.height, round_, sums);
  made.replicates = made.image.variance.empty() ? 0 : inRound_;
  return made;
}

}  // namespace pathmark::preview
