#include "preview/compare/reference_choice.h"

#include "film/image_file.h"
#include "film/printable.h"
#include "host/display_path.h"
#include "preview/compare/known_noise.h"
#include "preview/same_camera.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark::preview {

namespace fs = std::filesystem;

namespace {

constexpr const char* kKeepInstead = "Keep a picture as the reference instead.";

FoundReference none(std::string why) { return {nullptr, std::move(why), {}}; }

std::string sizeOf(const Image& image) { return fmt::format("{}x{}", image.width, image.height); }

std::string lightOf(const std::string& paths) {
  return paths.empty() ? "all light" : fmt::format("the light paths {}", printable(paths));
}

bool sameSize(const Image& a, const Image& b) { return a.width == b.width && a.height == b.height; }

// Shipped references are made by tracePathMIS. Light that paths which sample lights alone hardly
// ever meet is missing in their pictures, and in the variances of these too.
std::string mirrorNote(const PreviewScene& scene) {
  constexpr float kNearlyAMirror = 1000.0f;
  float exponent = 0.0f;
  for (const FlatMaterial& material : scene.loaded.flat.materials)
    if (material.kind == FlatMaterialKind::kPhong) exponent = std::max(exponent, material.exponent);
  if (exponent < kNearlyAMirror) return {};
  return fmt::format(
      "Surfaces of the exponent {:g} are nearly mirrors: tracePath, which samples points on lights "
      "only, meets some of the light in them so rarely that its own noise does not tell of it, "
      "however right it is. The reference has that light, and part 8 finds it.",
      exponent);
}

// With variances from a file that does not say of how many replicates: the fewest.
FoundReference found(ImageFile file, std::string name, std::uint64_t id) {
  const auto image = std::make_shared<const Image>(std::move(file.image));
  const std::uint32_t replicates =
      image->variance.empty() ? 0 : std::max(file.origin.replicates, 2u);
  return {std::make_shared<const Reference>(Reference{image, replicates, std::move(name), 0, id}),
          {},
          {}};
}

}  // namespace

FoundReference ReferenceFinder::find(const ReferenceWish& wish,
                                     const std::shared_ptr<const Picture>& picture) {
  switch (wish.source) {
    case ReferenceSource::kShipped:
      return findShipped(*picture);
    case ReferenceSource::kKept:
      return findKept(wish, *picture);
    case ReferenceSource::kFile:
      return findFile(wish, *picture);
  }
  return {};
}

FoundReference ReferenceFinder::findShipped(const Picture& picture) {
  if (picture.made.estimator == Estimator::kWarmUp)
    return none(
        fmt::format("The warm-up's lights shine from both sides, and those of the "
                    "reference from the front only. {}",
                    kKeepInstead));
  if (!picture.paths.empty())
    return none(
        fmt::format("The reference has all light, and this picture that of the light paths {} "
                    "only. {}",
                    picture.paths, kKeepInstead));
  if (!picture.fileCamera)
    return none(
        fmt::format("The camera has moved away from that of the reference: press C to put "
                    "it back. Or keep this picture as the reference."));
  if (shippedFor_ != picture.scene) {
    shipped_ = readShipped(*picture.scene);
    shippedFor_ = picture.scene;
  }
  if (!shipped_.reference) return shipped_;
  if (!sameSize(*shipped_.reference->image, picture.image))
    return none(fmt::format("The reference has {} pixels, and this picture {}. {}",
                            sizeOf(*shipped_.reference->image), sizeOf(picture.image),
                            kKeepInstead));
  FoundReference result = shipped_;
  if (picture.made.estimator != Estimator::kMis) result.note = mirrorNote(*picture.scene);
  return result;
}

FoundReference ReferenceFinder::readShipped(const PreviewScene& scene) {
  const std::string& name = scene.loaded.name;
  const fs::path file = shippedFile_(name);
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    return none(
        fmt::format("There is no reference for {}: only Pathmark's own scenes have one. "
                    "{}",
                    name, kKeepInstead));
  try {
    ImageFile read = readImage(file);
    if (read.origin.sceneHash != scene.hash)
      return none(
          fmt::format("The reference of {} is of another version of the scene: its file, "
                      "size or number of bounces has changed. {}",
                      name, kKeepInstead));
    return found(std::move(read), fmt::format("the reference of {}", name), ++newestId_);
  } catch (const std::exception& e) {
    return none(
        fmt::format("The reference cannot be used: {} Get the file again, or keep a "
                    "picture as the reference.",
                    e.what()));
  }
}

FoundReference ReferenceFinder::findKept(const ReferenceWish& wish, const Picture& picture) {
  if (!wish.kept) return none("No picture has been kept yet.");
  const Picture& kept = *wish.kept;
  if (kept.scene->hash != picture.scene->hash || !sameSize(kept.image, picture.image))
    return none(
        fmt::format("The picture that you kept is of {} ({}), and this one of {} ({}), or "
                    "the scene has changed. Keep this picture, or open the other scene.",
                    kept.scene->loaded.name, sizeOf(kept.image), picture.scene->loaded.name,
                    sizeOf(picture.image)));
  if (kept.paths != picture.paths)
    return none(
        fmt::format("The picture that you kept has {}, and this one {}. Keep this one, or type the "
                    "other light paths.",
                    lightOf(kept.paths), lightOf(picture.paths)));
  if (!sameCamera(kept.camera, picture.camera))
    return none(
        "The picture that you kept was made with another camera. Keep this one, or put "
        "the camera back (C is the scene file's).");
  if (keptFor_ != wish.kept) {
    keptFor_ = wish.kept;
    const std::shared_ptr<const Image> image = imageWithKnownNoise(wish.kept);
    kept_ = none(
        "The picture was kept too early: its noise is not known yet. Keep it again when "
        "it has more rays.");
    if (image)
      kept_ = {std::make_shared<const Reference>(
                   Reference{image, kept.replicates,
                             fmt::format("the kept picture ({}, {:.4g} rays per pixel)",
                                         kept.coursework, kept.raysPerPixel),
                             kept.series, ++newestId_}),
               {},
               "Pictures of the same seed share some of their noise, which can hide small "
               "differences: for a fair test give them different seeds."};
  }
  return kept_;
}

FoundReference ReferenceFinder::findFile(const ReferenceWish& wish, const Picture& picture) {
  if (wish.file.empty()) return none("Type the name of an .exr, .pfm or .hdr file.");
  if (loads_ != wish.loads) {
    loads_ = wish.loads;
    fileScene_.clear();
    filePaths_.clear();
    try {
      if (imageEnding(wish.file) == ".png")
        throw ImageError(displayPath(wish.file) +
                         ": a PNG file holds what was seen, and no radiance; .exr, .pfm and .hdr "
                         "files do.");
      ImageFile read = readImage(wish.file);
      fileScene_ = read.origin.sceneHash;
      filePaths_ = read.origin.paths;
      file_ = found(std::move(read), displayPath(wish.file), ++newestId_);
    } catch (const std::exception& e) {
      file_ = none(e.what());
    }
  }
  if (!file_.reference) return file_;
  const Image& image = *file_.reference->image;
  if (!sameSize(image, picture.image))
    return none(
        fmt::format("{} has {} pixels, and this picture {}: only images of the same size "
                    "can be compared.",
                    file_.reference->name, sizeOf(image), sizeOf(picture.image)));
  FoundReference result = file_;
  if (image.variance.empty()) result.note = "It does not say how noisy it is: it counts as exact.";
  if (!fileScene_.empty() && fileScene_ != picture.scene->hash)
    result.note = "It is of another scene, or another version of this one. " + result.note;
  if (filePaths_ != picture.paths)
    result.note = fmt::format("It has {}, and this picture {}. {}", lightOf(filePaths_),
                              lightOf(picture.paths), result.note);
  return result;
}

}  // namespace pathmark::preview
