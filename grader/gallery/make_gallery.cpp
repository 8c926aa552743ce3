#include "gallery/make_gallery.h"

#include "gallery/gallery_scenes.h"
#include "host/coursework_builder.h"
#include "marking/pictures.h"
#include "sampling/mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

namespace pathmark::gallery {

namespace {

using marking::MarkingScene;
using marking::Measured;

// To choose the scene: enough for what shows at all.
constexpr std::uint64_t kTryRays = 32;
constexpr std::uint32_t kTryReplicates = 8, kReplicates = 16;

struct View {
  std::uint64_t rays;
  std::uint32_t replicates;
  std::uint64_t seed;
};

Measured render(WorkerProcess& worker, const MarkingScene& scene, const View& view) {
  return marking::renderMeasured(worker, scene, view.seed, 1, {view.rays, view.replicates});
}

std::unique_ptr<WorkerProcess> start(const std::filesystem::path& program) {
  WorkerProcess::Options options;
  options.program = program;
  options.courseworkFolder = courseworkFolder("solutions");  // crashes are told with their files
  return std::make_unique<WorkerProcess>(std::move(options));
}

std::string wordsOf(const WorkerError& e) {
  switch (e.fault()) {
    case WorkerFault::kCrashed:
      return "it crashes";
    case WorkerFault::kTimeLimit:
      return "it never ends";
    default:
      return "it ends without a picture";
  }
}

// What all variants of a part share: the scenes and their correct pictures, made once.
class PartRoom {
 public:
  PartRoom(int part, std::filesystem::path solutions)
      : scenes_(scenesOf(part)), solutions_(std::move(solutions)) {}

  const std::vector<MarkingScene>& scenes() const { return scenes_; }

  std::uint64_t raysFrom(std::uint64_t rays) const {
    return scenes_.front().estimator == Estimator::kWarmUp ? kWarmUpFactor * rays : rays;
  }

  // Of other random numbers than the variants' pictures.
  Measured correct(std::size_t scene, const View& view) {
    Entry* entry = nullptr;
    {
      const std::lock_guard lock(mutex_);
      entry = &entries_[{scene, view.rays}];
    }
    std::call_once(entry->made, [&] {
      entry->picture = render(*start(solutions_), scenes_[scene],
                              {view.rays, view.replicates, mix(view.seed + kGolden)});
    });
    return entry->picture;
  }

 private:
  struct Entry {
    std::once_flag made;
    Measured picture;
  };
  std::vector<MarkingScene> scenes_;
  std::filesystem::path solutions_;
  std::mutex mutex_;
  std::map<std::pair<std::size_t, std::uint64_t>, Entry> entries_;
};

class Maker {
 public:
  Maker(const GalleryOptions& options)
      : options_(options), solutions_(buildCoursework(courseworkFolder("solutions"))) {
    if (!solutions_.complete()) throw std::runtime_error(solutions_.failure());
  }

  PartRoom& room(int part) {
    const std::lock_guard lock(mutex_);
    auto& room = rooms_[part];
    if (!room) room = std::make_unique<PartRoom>(part, solutions_.worker);
    return *room;
  }

  Specimen make(const Variant& variant) {
    Specimen specimen;
    specimen.variant = variant;
    PartRoom& place = room(variant.part);
    const std::filesystem::path program = programOf(variant);
    try {
      const std::size_t scene = choose(program, place);
      show(program, place, scene, specimen);
    } catch (const WorkerError& e) {
      specimen.failure = wordsOf(e);
      specimen.words = fmt::format("There is no picture: {}.", specimen.failure);
      specimen.scene = place.scenes().front().name;
      specimen.exposure = place.scenes().front().exposure;
      specimen.rays = place.raysFrom(kManyRays);
      place.correct(0, {specimen.rays, kReplicates, 1});
    }
    return specimen;
  }

  CorrectView correctView(int part, const std::string& scene, std::uint64_t rays) {
    PartRoom& place = room(part);
    const auto& scenes = place.scenes();
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const MarkingScene& s) { return s.name == scene; });
    const auto index = static_cast<std::size_t>(found - scenes.begin());
    const std::uint32_t replicates = rays == place.raysFrom(kFewRays) ? 1 : kReplicates;
    return {part, scene, rays, found->exposure, place.correct(index, {rays, replicates, 1}).image};
  }

 private:
  std::filesystem::path programOf(const Variant& variant) {
    const std::filesystem::path folder = options_.scratch / variant.name;
    applyVariant(variant, folder);
    CourseworkBuild build = solutions_;
    PartBuild& part = build.parts[placeOfPart(variant.part)];
    part = compilePart(folder, variant.part);
    if (!part.compiled)
      throw std::runtime_error(fmt::format("{} does not compile: {}", variant.name, part.messages));
    const LinkedWorker linked = linkWithOthers(build, std::array{variant.part}, solutions_);
    if (linked.worker.empty()) throw std::runtime_error(variant.name + ": " + linked.failure);
    return linked.worker;
  }

  // The scene with the largest bias. A worker that ends in one scene may serve in another.
  static std::size_t choose(const std::filesystem::path& program, PartRoom& place) {
    std::optional<std::size_t> best;
    double largest = -1.0;
    std::exception_ptr failure;
    for (std::size_t k = 0; k < place.scenes().size(); ++k) {
      const View view{place.raysFrom(kTryRays), kTryReplicates, 2};
      try {
        const Measured tried = render(*start(program), place.scenes()[k], view);
        const record::Estimate bias = marking::tileBias(tried.image, place.correct(k, view).image);
        if (bias.low > largest || !best) best = k;
        largest = std::max(largest, bias.low);
      } catch (const WorkerError&) {
        failure = std::current_exception();
      }
    }
    if (!best) std::rethrow_exception(failure);
    return *best;
  }

  static void show(const std::filesystem::path& program, PartRoom& place, std::size_t scene,
                   Specimen& specimen) {
    const MarkingScene& chosen = place.scenes()[scene];
    const View view{place.raysFrom(kManyRays), kReplicates, 3};
    const Measured wrong = render(*start(program), chosen, view);
    specimen.showing = whatShows(wrong, place.correct(scene, view));
    specimen.words = lookFor(specimen.showing);
    specimen.scene = chosen.name;
    specimen.exposure = chosen.exposure;
    specimen.picture = wrong.image;
    specimen.rays = view.rays;
    if (showsInMeans(specimen.showing)) return;
    specimen.rays = place.raysFrom(kFewRays);
    specimen.picture = render(*start(program), chosen, {specimen.rays, 1, 3}).image;
  }

  const GalleryOptions& options_;
  CourseworkBuild solutions_;
  std::mutex mutex_;
  std::map<int, std::unique_ptr<PartRoom>> rooms_;
};

}  // namespace

Gallery makeGallery(std::span<const Variant> variants, const GalleryOptions& options,
                    const OnProgress& onProgress) {
  Maker maker(options);
  std::vector<std::optional<Specimen>> made(variants.size());
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stopped{false};
  std::size_t done = 0;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t k = 0; !stopped && (k = next++) < variants.size();) {
      made[k] = maker.make(variants[k]);
      const std::lock_guard lock(telling);
      if (!onProgress(++done, variants[k].name)) stopped = true;
    }
  };
  const unsigned threads =
      options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::future<void>> others;
  for (unsigned k = 1; k < threads; ++k) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();

  Gallery gallery;
  for (auto& specimen : made)
    if (specimen) gallery.specimens.push_back(std::move(*specimen));
  for (const Specimen& s : gallery.specimens) {
    const auto known = [&](const CorrectView& c) {
      return c.part == s.variant.part && c.scene == s.scene && c.rays == s.rays;
    };
    if (std::none_of(gallery.correct.begin(), gallery.correct.end(), known))
      gallery.correct.push_back(maker.correctView(s.variant.part, s.scene, s.rays));
  }
  return gallery;
}

}  // namespace pathmark::gallery
