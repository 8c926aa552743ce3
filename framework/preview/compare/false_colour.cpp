#include "preview/compare/false_colour.h"

#include "film/signed_picture.h"
#include "stats/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark::preview {

namespace {

using Colour8 = std::array<std::uint8_t, 3>;

constexpr std::array<Colour8, 9> kViridis{{{68, 1, 84},
                                           {71, 45, 123},
                                           {59, 82, 139},
                                           {44, 114, 142},
                                           {33, 144, 140},
                                           {39, 173, 129},
                                           {93, 200, 99},
                                           {170, 220, 50},
                                           {253, 231, 37}}};

Colour8 viridis(double place) {
  const double position = std::clamp(place, 0.0, 1.0) * static_cast<double>(kViridis.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), kViridis.size() - 2);
  const double fraction = position - static_cast<double>(below);
  Colour8 colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(
        std::lround(std::lerp(kViridis[below][c], kViridis[below + 1][c], fraction)));
  return colour;
}

void paint(FalseColours& colours) {
  colours.rgba.reserve(4 * colours.values.size());
  for (const float value : colours.values) {
    const Colour8 c = colours.scale.colour(static_cast<double>(value));
    colours.rgba.insert(colours.rgba.end(), {c[0], c[1], c[2], 255});
  }
}

FalseColours make(View view, const ColourScale& scale, std::vector<float> values) {
  FalseColours colours{view, scale, {}, std::move(values)};
  paint(colours);
  return colours;
}

}  // namespace

std::array<std::uint8_t, 3> ColourScale::colour(double value) const {
  if (isSigned || std::isnan(value)) return signedColour(value, to);
  return viridis(std::log(std::max(value, from) / from) / std::log(to / from));
}

double ColourScale::valueAt(double place) const {
  return isSigned ? std::lerp(-to, to, place) : from * std::pow(to / from, place);
}

FalseColours errorColours(const Image& picture, const Image& reference,
                          const UsablePixels& pixels) {
  std::vector<float> values = largestOfChannels(differenceImage(picture, reference), pixels);
  const double full = fullColour(values);
  return make(View::kError, {true, -full, full}, std::move(values));
}

FalseColours scoreColours(int width, int height, const Comparison& comparison) {
  // Student's t of many degrees of freedom: the least that any tile needs.
  const double critical =
      comparison.tiles.empty()
          ? 1.0
          : stats::studentCritical(comparison.alphaOfTile, std::numeric_limits<double>::infinity());
  return make(View::kScores, {true, -critical, critical}, tileScores(width, height, comparison));
}

FalseColours noiseColours(const Image& image) {
  std::vector<float> values;
  values.reserve(image.rgb.size() / 3);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    double sum = 0.0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const auto value = static_cast<double>(image.rgb[c]);
      sum += static_cast<double>(image.variance[c]) / (value * value + 0.01);
    }
    const auto noise = static_cast<float>(std::sqrt(sum / 3.0));
    values.push_back(std::isfinite(noise) ? noise : std::numeric_limits<float>::quiet_NaN());
  }
  return make(View::kNoise, {false, 1e-3, 1.0}, std::move(values));
}

}  // namespace pathmark::preview
