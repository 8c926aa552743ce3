// Numbers that describe an image: its mean, low-frequency modes and tiles.
//
//   ImageFeatures   of all images of one size
//   PlainImage      radiance in double
//   judgeFeatures   replicates of them against what they must be
//   placeInWords    "upper left"
//
// A mode is the mean of the image times cos(pi a x) cos(pi b y), x and y from 0 to 1 over it: it
// finds what is too bright on one side and too dark on the other. A tile is the mean of an eighth
// of the width by an eighth of the height.
#pragma once

#include "checks/check.h"

#include <functional>
#include <string>
#include <vector>

namespace pathmark::checks {

struct PlainImage {
  int width = 0, height = 0;
  std::vector<double> rgb;  // row by row from the top
};

class ImageFeatures {
 public:
  // `like`: about the right image. Each pixel counts relative to its value there (or to a tenth of
  // the channel's mean, where it is darker), so that the mean and the tiles of a right image are 1
  // and dark parts of a picture count as much as the lamp in it.
  explicit ImageFeatures(const PlainImage& like);

  // Of three channels each: feature k is of the channel k % 3. The first three are the means.
  std::size_t count() const { return 3 * features_.size(); }
  std::vector<double> of(const PlainImage& image) const;

  // The standard errors, from the variances of the pixels' values, which are independent.
  std::vector<double> errors(const PlainImage& variances) const;

  bool isMean(std::size_t k) const { return k < 3; }
  bool isTile(std::size_t k) const { return features_[k / 3].tile; }
  std::string name(std::size_t k) const { return features_[k / 3].name; }

 private:
  struct Feature {
    std::string name;
    bool tile;
    std::vector<std::size_t> pixels;
    std::vector<double> weights;  // three for each of the pixels
  };

  std::vector<Feature> features_;
};

struct FeatureTarget {
  std::vector<double> expected, errors;  // errors: standard errors of `expected`; empty: none
  double delta = 0.02;                   // the smallest error of the mean that is found
};

// Features of independent images of the scene, so many from number `first` on; fewer only where one
// of them is no image.
using MakeReplicates =
    std::function<std::vector<std::vector<double>>(std::uint64_t first, std::uint64_t count)>;

// Looks at 256 of them, and at 768 if the mean is undecided. Fails where any feature is wrong; is
// undecided where nothing can be said of the mean.
Finding judgeFeatures(CheckRun& run, const ImageFeatures& features, const FeatureTarget& target,
                      const MakeReplicates& make, const std::string& where);

// Of a point at these shares of width and height, from the upper left.
std::string placeInWords(double x, double y);

}  // namespace pathmark::checks
