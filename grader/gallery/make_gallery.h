// Making the mistake gallery: each wrong variant's picture of the scene that shows it best.
//
//   Specimen       one mistake, with its picture
//   CorrectView    the solutions' picture of a scene, with as many rays per pixel
//   Gallery        all of them
//   makeGallery    renders it
#pragma once

#include "gallery/what_shows.h"
#include "variants/variant.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace pathmark::gallery {

// Of pictures whose mean shows the mistake, and of others: there noise may tell. The warm-up's take
// kWarmUpFactor times as many, since it meets lights by chance only.
inline constexpr std::uint64_t kManyRays = 256, kFewRays = 4, kWarmUpFactor = 4;

struct Specimen {
  Variant variant;
  std::string scene;
  double exposure = 1.0;
  std::uint64_t rays = kManyRays;  // of a pixel
  Image picture;                   // empty where the coursework ends before there is one
  std::string failure;             // why, in a word or two
  std::string words;               // what to look for
  Showing showing;
};

struct CorrectView {
  int part = 0;
  std::string scene;
  std::uint64_t rays = kManyRays;
  double exposure = 1.0;
  Image picture;
};

struct Gallery {
  std::vector<Specimen> specimens;  // in the order of the variants
  std::vector<CorrectView> correct;
};

struct GalleryOptions {
  unsigned threads = 0;  // variants at the same time; 0: one for each processor
  std::filesystem::path scratch;
};

// How many variants are done; returns whether to go on. Called from one thread at a time.
using OnProgress = std::function<bool(std::size_t done, const std::string& name)>;

// Fewer specimens where `onProgress` said no. Throws std::runtime_error where the solutions cannot
// be used, or a variant does not compile.
Gallery makeGallery(std::span<const Variant> variants, const GalleryOptions& options,
                    const OnProgress& onProgress);

}  // namespace pathmark::gallery
