// Pictures for tests of the preview, without a renderer.
//
//   testScene      an empty scene of some size
//   NoisySeries    a picture whose passes have known means and noise
#pragma once

#include "preview/compare/known_noise.h"
#include "preview/picture.h"
#include "stats/moments.h"
#include "tests/support/uniforms.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pathmark::test {

inline std::shared_ptr<const preview::PreviewScene> testScene(int width, int height,
                                                              const std::string& name = "test") {
  const auto scene = std::make_shared<preview::PreviewScene>();
  scene->loaded.name = name;
  scene->loaded.flat.camera.width = static_cast<std::uint32_t>(width);
  scene->loaded.flat.camera.height = static_cast<std::uint32_t>(height);
  scene->hash = name + "'s hash";
  return scene;
}

// Of the scene, with this image, as the first of its series.
inline preview::Picture pictureOf(std::shared_ptr<const preview::PreviewScene> scene, Image image,
                                  std::uint32_t replicates = 8) {
  preview::Picture picture;
  picture.camera = scene->loaded.flat.camera;
  picture.scene = std::move(scene);
  picture.coursework = "student";
  picture.image = std::move(image);
  picture.replicates = replicates;
  picture.raysPerPixel = 1024.0;
  picture.seconds = 1.0;
  picture.series = picture.version = 1;
  return picture;
}

// Passes have exponential noise: a standard deviation as large as the mean, and skewness 2.
class NoisySeries {
 public:
  static constexpr double kRaysOfPass = preview::kRaysOfReplicate;

  using Mean = std::function<double(int column, int row)>;

  NoisySeries(std::shared_ptr<const preview::PreviewScene> scene, std::uint64_t number,
              testing::Uniforms& random, Mean mean, std::uint32_t replicates = 8)
      : scene_(std::move(scene)),
        number_(number),
        random_(random),
        replicates_(replicates),
        width_(static_cast<int>(scene_->loaded.flat.camera.width)),
        height_(static_cast<int>(scene_->loaded.flat.camera.height)) {
    for (int row = 0; row < height_; ++row)
      for (int column = 0; column < width_; ++column)
        means_.insert(means_.end(), 3, mean(column, row));
    sums_.resize(means_.size() * replicates_);
  }

  // In each replicate.
  void addPasses(int count) {
    for (std::size_t i = 0; i < sums_.size(); ++i)
      for (int k = 0; k < count; ++k)
        sums_[i] -= means_[i / replicates_] * std::log1p(-random_.nextDouble());
    passes_ += count;
  }

  std::shared_ptr<const preview::Picture> picture() {
    Image image{width_, height_};
    for (std::size_t i = 0; i < means_.size(); ++i) {
      stats::RunningMoments moments;
      for (std::size_t r = 0; r < replicates_; ++r)
        moments.add(sums_[i * replicates_ + r] / passes_);
      image.rgb.push_back(static_cast<float>(moments.mean()));
      image.variance.push_back(static_cast<float>(moments.variance() / replicates_));
    }
    preview::Picture picture = pictureOf(scene_, std::move(image), replicates_);
    picture.raysPerPixel = kRaysOfPass * passes_ * replicates_;
    picture.seconds = 0.001 * picture.raysPerPixel;
    picture.series = number_;
    picture.version = (number_ << 32) + ++made_;
    return std::make_shared<const preview::Picture>(std::move(picture));
  }

 private:
  std::shared_ptr<const preview::PreviewScene> scene_;
  std::uint64_t number_, made_ = 0;
  testing::Uniforms& random_;
  std::uint32_t replicates_;
  int width_, height_;
  std::vector<double> means_, sums_;  // of values, and of the replicates of each
  int passes_ = 0;
};

}  // namespace pathmark::test
