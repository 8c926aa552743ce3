// SmallRender: pictures of a scene by the whole coursework, small and many.
//
//   RenderedFilm    sums of radiances, and what was no radiance
//   render          one picture
//   replicates      the features of independent ones
#pragma once

#include "checks/image_features.h"
#include "render/render_job.h"
#include "scene/flat_scene.h"

#include <optional>
#include <string>
#include <vector>

namespace pathmark::checks {

struct RenderedFilm {
  int width = 0, height = 0;
  std::vector<FilmPixel> pixels;
  InvalidPixels invalid;

  PlainImage image() const;
};

class SmallRender {
 public:
  // Hands the scene to the worker; `name` is for messages.
  SmallRender(CheckRun& run, const FlatScene& scene, std::string name,
              std::uint64_t raysPerPixel = 4, Estimator estimator = Estimator::kPath);

  // The same bits for the same number, with any number of threads; 0: one for each processor.
  RenderedFilm render(std::uint64_t number, unsigned threads = 0);

  // Pictures number `first` and following. Empty where a value was no radiance: see invalid().
  std::vector<std::vector<double>> replicates(const ImageFeatures& features, std::uint64_t first,
                                              std::uint64_t count);

  MakeReplicates replicatesOf(const ImageFeatures& features) {
    return [&](std::uint64_t first, std::uint64_t count) {
      return replicates(features, first, count);
    };
  }

  // The mean of such pictures.
  PlainImage mean(std::uint64_t first, std::uint64_t count);

  // What is wrong with the first picture that had an invalid value.
  const std::optional<Finding>& invalid() const { return invalid_; }

  std::uint64_t rays() const { return rays_; }  // camera rays
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  CheckRun& run_;
  std::string name_;
  int width_, height_;
  std::uint64_t raysPerPixel_;
  Estimator estimator_;
  std::optional<Finding> invalid_;
  std::uint64_t rays_ = 0;
};

// The scene of scenes/NAME.json for pictures of about 32 x 32 pixels: its size over a whole number.
struct SmallScene {
  FlatScene flat;
  int shrink = 1;
};
SmallScene loadSmall(const std::string& name);

}  // namespace pathmark::checks
