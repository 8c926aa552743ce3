// What a wrong picture shows beside the correct one: in numbers, and in words.
#pragma once

#include "marking/picture_statistics.h"

#include <array>
#include <string>

namespace pathmark::gallery {

struct Showing {
  record::Estimate bias;         // tile bias
  std::array<double, 3> mean{};  // relative error of the picture's mean, by channel
  double brightest = 0.0;        // of nine fields, the largest relative error ...
  double darkest = 0.0;          // ... and the least
  std::string brightestField;    // "top left", "middle"
  std::string darkestField;
  double noise = 1.0;  // standard error over the correct picture's, at the same number of rays
};

// Both with as many rays per pixel.
Showing whatShows(const marking::Measured& wrong, const marking::Measured& correct);

// Whether a person may see it: a bias of 2 % and more.
bool showsInMeans(const Showing& showing);

// One or two sentences that say what to look for.
std::string lookFor(const Showing& showing);

}  // namespace pathmark::gallery
