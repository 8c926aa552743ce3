// How many rays each tile of a picture needs for a stated error, decided without bias.
//
//   TileErrors       the error of each tile of a picture that stores its variance
//   PilotFilms       the same rays of every pixel, twice, with independent random numbers
//   raysForTarget    from a pilot to the rays of each tile
//
// The error of a tile is the root of the mean, over its pixels and channels, of the variance of the
// pixel's value, divided by the tile's brightness: its mean over pixels and channels, or a tenth of
// the picture's where the tile is darker than that.
//
// A rule that looks at the samples of a picture to decide whether they are enough makes the picture
// too dark: where by chance no bright sample is among the first ones, no more are taken (Kirk &
// Arvo, "Unbiased Sampling Techniques for Image Synthesis", SIGGRAPH 1991). Their remedy
// is to decide by a pilot whose samples are then thrown away. Here nothing is: the picture is the
// mean of two halves with independent random numbers, and the pilot of each decides how many rays
// the other gets. Given that number, a half's samples are as if it had been fixed before, and its
// mean is right; so is the mean of both, because each counts as one half, however many rays it has.
#pragma once

#include "film/image.h"
#include "render/render_job.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pathmark {

struct TileErrors {
  std::vector<double> relative;  // row by row; infinite where the variance is

  double median() const;
  double worst() const;
};

// The image must have variances.
TileErrors tileErrors(const Image& image);

struct PilotFilms {
  int width = 1, height = 1;
  std::span<const FilmPixel> first, second;
  std::uint64_t rays = 1;  // of each pixel, in each of the two
};

struct TargetError {
  double relative = 0.01;
  std::uint32_t raysPerPass = 16;  // numbers of rays are multiples of it
  std::uint64_t mostRays = 4096;   // of each of the picture's four films
};

// Rays of each pixel, by tile, in each of the other half's two films, so that the mean of four
// films with as many rays has the wanted error; no fewer than those of the pilot.
std::vector<std::uint64_t> raysForTarget(const PilotFilms& pilot, const TargetError& target);

}  // namespace pathmark
