#include "grading/mistake_pictures.h"

#include "host/worker_process.h"
#include "host/workshop.h"
#include "sampling/mix.h"
#include "variants/variant.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace pathmark::grading {

const std::optional<Image>& MistakePictures::of(const std::string& mistake,
                                                const marking::MarkingScene& scene,
                                                unsigned threads) {
  Entry* entry = nullptr;
  {
    const std::lock_guard lock(mutex_);
    auto& place = entries_[{mistake, scene.name}];
    if (!place) place = std::make_unique<Entry>();
    entry = place.get();
  }
  std::call_once(entry->made, [&] { entry->picture = make(mistake, scene, threads); });
  return entry->picture;
}

// A variant is ours as the solutions are: it needs no sandbox.
std::optional<Image> MistakePictures::make(const std::string& mistake,
                                           const marking::MarkingScene& scene,
                                           unsigned threads) const {
  const std::vector<Variant> all = allVariants();
  const auto variant =
      std::find_if(all.begin(), all.end(), [&](const Variant& v) { return v.name == mistake; });
  if (variant == all.end()) return {};
  const ScratchFolder folder(nullptr);
  applyVariant(*variant, folder.path());
  const CourseworkBuild build =
      buildCoursework(folder.path(), Incomplete::kCompileOnly, {}, threads);
  if (!build.parts[placeOfPart(variant->part)].compiled) return {};
  WorkerProcess::Options options;
  options.courseworkFolder = folder.path();
  options.program = linkWithOthers(build, std::array{variant->part}, solutions_).worker;
  if (options.program.empty()) return {};
  try {
    WorkerProcess worker(std::move(options));
    return marking::renderMeasured(worker, scene, mix(seed_ - kGolden), threads).image;
  } catch (const WorkerError&) {
    return {};
  }
}

}  // namespace pathmark::grading
