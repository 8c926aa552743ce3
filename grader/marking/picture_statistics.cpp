#include "marking/picture_statistics.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark::marking {

namespace {

constexpr int kTile = 8;                 // pixels
constexpr double kQuantile = 2.5758293;  // of the normal distribution, for 99 % on both sides
// In every one of a thousand tiles at once, with a probability of error below 1e-5.
constexpr double kEveryTile = 6.0;
constexpr std::size_t kBins = 20;

struct Tile {
  int left, top, right, bottom;
};

std::vector<Tile> tilesOf(const Image& image) {
  std::vector<Tile> tiles;
  for (int top = 0; top < image.height; top += kTile)
    for (int left = 0; left < image.width; left += kTile)
      tiles.push_back(
          {left, top, std::min(left + kTile, image.width), std::min(top + kTile, image.height)});
  return tiles;
}

std::size_t valueAt(const Image& image, int column, int row, int channel) {
  return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(column)) +
         static_cast<std::size_t>(channel);
}

// Calls with each value's place in rgb.
template <class Visit>
void forEachPixel(const Image& image, const Tile& tile, int channel, Visit visit) {
  for (int row = tile.top; row < tile.bottom; ++row)
    for (int column = tile.left; column < tile.right; ++column)
      visit(valueAt(image, column, row, channel));
}

// A pixel whose variance is not known has had no two valid replicates: its noise is as large as
// itself.
double varianceAt(const Image& image, std::size_t value) {
  const double variance = image.variance.empty() ? 0.0 : double{image.variance[value]};
  const double size = double{image.rgb[value]};
  return std::isfinite(variance) ? variance : size * size;
}

struct Difference {
  double mean = 0.0, variance = 0.0;
};

Difference differenceIn(const Image& a, const Image& b, const Tile& tile, int channel) {
  Difference sum;
  double pixels = 0.0;
  forEachPixel(a, tile, channel, [&](std::size_t v) {
    sum.mean += double{a.rgb[v]} - double{b.rgb[v]};
    sum.variance += varianceAt(a, v) + varianceAt(b, v);
    ++pixels;
  });
  return {sum.mean / pixels, sum.variance / (pixels * pixels)};
}

double meanIn(const Image& image, const Tile& tile, int channel) {
  double sum = 0.0, pixels = 0.0;
  forEachPixel(image, tile, channel, [&](std::size_t v) {
    sum += double{image.rgb[v]};
    ++pixels;
  });
  return sum / pixels;
}

double meanOf(const Image& image, int channel) {
  return meanIn(image, {0, 0, image.width, image.height}, channel);
}

// What lies in the middle of the values that are not black.
double medianOf(const Image& image, int channel) {
  std::vector<float> values;
  for (std::size_t v = static_cast<std::size_t>(channel); v < image.rgb.size(); v += 3)
    if (image.rgb[v] > 0.0f) values.push_back(image.rgb[v]);
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return double{*middle};
}

// The factor by which a pixel counts, so that nothing in or beside it is brighter than white: eyes
// and screens see no more of a lamp. It comes from the reference alone, and so favours nothing.
class Whiteness {
 public:
  Whiteness(const Image& reference, int channel)
      : image_(&reference), channel_(channel), white_(kWhite * medianOf(reference, channel)) {}

  double weight(int column, int row) const {
    double brightest = white_;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, image_->height - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, image_->width - 1); ++x)
        brightest = std::max(brightest, double{image_->rgb[valueAt(*image_, x, y, channel_)]});
    return brightest > 0.0 ? white_ / brightest : 1.0;
  }

 private:
  static constexpr double kWhite = 4.0;  // times what is in the middle

  const Image* image_;
  int channel_;
  double white_;
};

// Both pictures as eyes see them: white where they are brighter.
void dimLamps(Image& a, Image& b) {
  const Image reference = b;
  for (int channel = 0; channel < 3; ++channel) {
    const Whiteness whiteness(reference, channel);
    for (int row = 0; row < b.height; ++row)
      for (int column = 0; column < b.width; ++column) {
        const auto weight = static_cast<float>(whiteness.weight(column, row));
        const std::size_t v = valueAt(b, column, row, channel);
        for (Image* image : {&a, &b}) {
          image->rgb[v] *= weight;
          if (!image->variance.empty()) image->variance[v] *= weight * weight;
        }
      }
  }
}

double rootOf(double square) { return std::sqrt(std::max(square, 0.0)); }

}  // namespace

record::Estimate tileBias(const Image& picture, const Image& reference) {
  Image a = picture, b = reference;
  dimLamps(a, b);
  const std::array<double, 3> brightnesses{meanOf(b, 0), meanOf(b, 1), meanOf(b, 2)};
  double sum = 0.0, variance = 0.0, certain = 0.0, whole = 0.0;
  for (const Tile& tile : tilesOf(b)) {
    // The three channels come from the same paths, so that their noise may be the same: standard
    // deviations add, and not variances. No dependence has a larger sum.
    double deviation = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
      const double brightness = brightnesses[static_cast<std::size_t>(channel)];
      if (brightness <= 0.0) continue;
      const double own = meanIn(b, tile, channel), size = std::max(own, brightness);
      const Difference d = differenceIn(a, b, tile, channel);
      const double noise = d.variance / (size * size);
      const double square = d.mean * d.mean / (size * size) - noise;
      sum += square;
      // Of a squared normal variable with this noise around its mean.
      deviation += std::sqrt(2.0 * noise * noise + 4.0 * std::max(square, 0.0) * noise);
      // One wild tile makes the variance useless; the others show what they show all the same.
      const double least = std::abs(d.mean) / size - kEveryTile * std::sqrt(noise);
      certain += least > 0.0 ? least * least : 0.0;
      whole += own * own / (size * size);
    }
    variance += deviation * deviation;
  }
  if (whole == 0.0) return {};
  const double square = sum / whole, error = kQuantile * std::sqrt(variance) / whole;
  const double least = std::max(square - error, certain / whole);
  return {rootOf(std::max(square, least)), rootOf(least), rootOf(square + error)};
}

std::array<record::Estimate, 3> meanErrors(const Image& a, const Image& b) {
  std::array<record::Estimate, 3> errors;
  for (int channel = 0; channel < 3; ++channel) {
    const double brightness = meanOf(b, channel);
    if (brightness <= 0.0) continue;
    const Difference d = differenceIn(a, b, {0, 0, b.width, b.height}, channel);
    const double value = d.mean / brightness,
                 error = kQuantile * std::sqrt(d.variance) / brightness;
    errors[static_cast<std::size_t>(channel)] = {value, value - error, value + error};
  }
  return errors;
}

record::Estimate efficiencyOver(const Measured& a, const Measured& b) {
  // Darker values than this share of the mean count as that.
  constexpr double kDarkest = 0.1;
  // A picture without any noise is a million times better at most.
  constexpr double kFloor = 1e-6;
  const std::vector<Tile> tiles = tilesOf(b.image);
  std::vector<double> ofA(tiles.size(), 0.0), ofB(tiles.size(), 0.0);
  double sumA = 0.0, sumB = 0.0;
  for (int channel = 0; channel < 3; ++channel) {
    const double dark = kDarkest * meanOf(b.image, channel);
    if (dark <= 0.0) continue;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
      // Of the tile and not of the pixel, whose variance depends on the same noise as its value.
      const double size = std::max(meanIn(b.image, tiles[t], channel), dark);
      forEachPixel(b.image, tiles[t], channel, [&](std::size_t v) {
        ofA[t] += varianceAt(a.image, v) / (size * size);
        ofB[t] += varianceAt(b.image, v) / (size * size);
      });
    }
  }
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    sumA += ofA[t];
    sumB += ofB[t];
  }
  if (sumB <= 0.0 || a.rays <= 0.0 || b.rays <= 0.0) return {1.0, 0.0, HUGE_VAL};
  const auto logRatio = [&](double noiseA, double noiseB) {
    return std::log(std::max(noiseB, 0.0)) - std::log(std::max(noiseA, kFloor * noiseB));
  };
  const auto count = static_cast<double>(tiles.size());
  double mean = 0.0, squares = 0.0;
  std::vector<double> without(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    without[t] = logRatio(sumA - ofA[t], sumB - ofB[t]);
    mean += without[t] / count;
  }
  for (const double w : without) squares += (w - mean) * (w - mean);
  const double error = kQuantile * std::sqrt(squares * (count - 1.0) / count);
  const double value = logRatio(sumA, sumB) + std::log(b.rays / a.rays);
  return {std::exp(value), std::exp(value - error), std::exp(value + error)};
}

std::vector<std::uint32_t> pValueHistogram(const Measured& a, const Measured& b) {
  std::vector<std::uint32_t> bins(kBins, 0);
  for (std::size_t v = 0; v < a.image.rgb.size(); ++v) {
    const double va = varianceAt(a.image, v), vb = varianceAt(b.image, v);
    if (va + vb <= 0.0) continue;
    // Welch, "The generalization of Student's problem", Biometrika 34, 1947.
    const double degrees =
        (va + vb) * (va + vb) / (va * va / (a.replicates - 1.0) + vb * vb / (b.replicates - 1.0));
    const double t = std::abs(double{a.image.rgb[v]} - double{b.image.rgb[v]}) / std::sqrt(va + vb);
    const double p =
        2.0 * boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), t));
    ++bins[std::min(static_cast<std::size_t>(p * static_cast<double>(kBins)), kBins - 1)];
  }
  return bins;
}

}  // namespace pathmark::marking
