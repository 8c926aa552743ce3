#include "preview/paths/path_colour.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

// From Oklab to linear sRGB: Ottosson, "A perceptual color space for image processing", 2020.
glm::dvec3 linearFromOklab(double lightness, double a, double b) {
  const double l = lightness + 0.3963377774 * a + 0.2158037573 * b;
  const double m = lightness - 0.1055613458 * a - 0.0638541728 * b;
  const double s = lightness - 0.0894841775 * a - 1.2914855480 * b;
  const glm::dvec3 cone(l * l * l, m * m * m, s * s * s);
  return {4.0767416621 * cone.x - 3.3077115913 * cone.y + 0.2309699292 * cone.z,
          -1.2684380046 * cone.x + 2.6097574011 * cone.y - 0.3413193965 * cone.z,
          -0.0041960863 * cone.x - 0.7034186147 * cone.y + 1.7076147010 * cone.z};
}

std::uint8_t encode(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

}  // namespace

double placeOfThroughput(double luminance) {
  if (!(luminance > kDarkestThroughput)) return 0.0;
  return std::min(std::log(luminance / kDarkestThroughput) /
                      std::log(kBrightestThroughput / kDarkestThroughput),
                  1.0);
}

// Both ends lie inside sRGB, and so does all that is between them.
Rgb8 colourAt(double place) {
  struct Oklab {
    double lightness, a, b;
  };
  constexpr Oklab kBlue{0.42, -0.01, -0.16}, kYellow{0.93, -0.03, 0.17};
  const glm::dvec3 c =
      linearFromOklab(std::lerp(kBlue.lightness, kYellow.lightness, place),
                      std::lerp(kBlue.a, kYellow.a, place), std::lerp(kBlue.b, kYellow.b, place));
  return {encode(c.r), encode(c.g), encode(c.b)};
}

}  // namespace pathmark::preview
