#include "film/signed_picture.h"

#include "film/image_formats.h"
#include "stats/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark {

namespace {

using Colour8 = std::array<std::uint8_t, 3>;

constexpr Colour8 kMagenta{255, 0, 255};

// From 0 to full colour: ColorBrewer's RdBu (Brewer, colorbrewer2.org), which the colour-blind can
// read too, from pure white.
constexpr std::array<Colour8, 5> kReds{
    {{255, 255, 255}, {253, 219, 199}, {244, 165, 130}, {214, 96, 77}, {103, 0, 31}}};
constexpr std::array<Colour8, 5> kBlues{
    {{255, 255, 255}, {209, 229, 240}, {146, 197, 222}, {67, 147, 195}, {5, 48, 97}}};

float furtherFromZero(float a, float b) { return std::abs(b) > std::abs(a) ? b : a; }

// The difference of two finite values may be infinite.
float finite(float value) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  return std::clamp(value, -kLargest, kLargest);
}

}  // namespace

Image differenceImage(const Image& a, const Image& b) {
  Image difference{a.width, a.height};
  difference.rgb.reserve(a.rgb.size());
  for (std::size_t i = 0; i < a.rgb.size(); ++i) difference.rgb.push_back(a.rgb[i] - b.rgb[i]);
  if (!a.variance.empty() && !b.variance.empty())
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
      difference.variance.push_back(a.variance[i] + b.variance[i]);
  for (const std::vector<std::uint8_t>* marks : {&a.invalid, &b.invalid}) {
    if (marks->empty()) continue;
    difference.invalid.resize(marks->size());
    for (std::size_t i = 0; i < marks->size(); ++i)
      if ((*marks)[i] != 0) difference.invalid[i] = 1;
  }
  return difference;
}

std::vector<float> largestOfChannels(const Image& difference, const UsablePixels& pixels) {
  std::vector<float> values;
  values.reserve(pixels.usable.size());
  for (std::size_t i = 0; i < pixels.usable.size(); ++i) {
    const float* rgb = &difference.rgb[3 * i];
    values.push_back(pixels.usable[i] != 0
                         ? finite(furtherFromZero(furtherFromZero(rgb[0], rgb[1]), rgb[2]))
                         : std::numeric_limits<float>::quiet_NaN());
  }
  return values;
}

double fullColour(std::span<const float> values) {
  constexpr double kQuantile = 0.99;
  std::vector<double> sizes;
  for (const float value : values)
    if (!std::isnan(value)) sizes.push_back(std::abs(static_cast<double>(value)));
  if (sizes.empty()) return 1.0;
  std::sort(sizes.begin(), sizes.end());
  for (const double size : {stats::sampleQuantile(sizes, kQuantile), sizes.back()})
    if (size > 0.0) return size;
  return 1.0;
}

std::array<std::uint8_t, 3> signedColour(double value, double scale) {
  if (std::isnan(value)) return kMagenta;
  const std::array<Colour8, 5>& colours = value < 0.0 ? kBlues : kReds;
  const double position =
      std::min(std::abs(value) / scale, 1.0) * static_cast<double>(colours.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), colours.size() - 2);
  const double fraction = position - static_cast<double>(below);
  Colour8 colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(
        std::lround(std::lerp(colours[below][c], colours[below + 1][c], fraction)));
  return colour;
}

std::string encodeSignedPng(int width, int height, std::span<const float> values, double scale) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * values.size());
  for (const float value : values)
    for (const std::uint8_t c : signedColour(static_cast<double>(value), scale)) bytes.push_back(c);
  return encodePngBytes(width, height, bytes);
}

std::vector<float> tileScores(int width, int height, const Comparison& comparison) {
  const auto row = static_cast<std::size_t>(width);
  std::vector<float> scores(row * static_cast<std::size_t>(height),
                            std::numeric_limits<float>::quiet_NaN());
  for (const RegionResult& tile : comparison.tiles)
    for (int j = tile.region.top; j < tile.region.top + tile.region.height; ++j)
      for (int i = tile.region.left; i < tile.region.left + tile.region.width; ++i) {
        float& score = scores[static_cast<std::size_t>(j) * row + static_cast<std::size_t>(i)];
        const auto z = static_cast<float>(tile.z);
        score = std::isnan(score) ? z : furtherFromZero(score, z);
      }
  return scores;
}

}  // namespace pathmark
