#include "preview/compare/display.h"

#include "film/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace pathmark::preview {

namespace {

// Equation 4 with L = `luminance`.
double reinhard(double luminance, double white) {
  return luminance * (1.0 + luminance / (white * white)) / (1.0 + luminance);
}

double filmic(double x) { return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14); }

// Of Rec. 709's primaries, which sRGB has.
double luminanceOf(const double* rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

// Neither infinite nor negative, so that no curve makes NaN of it.
double bounded(double x) { return std::clamp(x, 0.0, 1e60); }

struct Clip {
  void operator()(double*) const {}
};

struct Reinhard {
  double white;

  void operator()(double* rgb) const {
    for (int c = 0; c < 3; ++c) rgb[c] = bounded(rgb[c]);
    const double luminance = luminanceOf(rgb);
    const double factor = luminance > 0.0 ? reinhard(luminance, white) / luminance : 1.0;
    for (int c = 0; c < 3; ++c) rgb[c] *= factor;
  }
};

struct Filmic {
  void operator()(double* rgb) const {
    for (int c = 0; c < 3; ++c) rgb[c] = filmic(bounded(rgb[c]));
  }
};

bool isInvalid(const Image& image, std::size_t pixel) {
  const float* rgb = &image.rgb[3 * pixel];
  const bool marked = !image.invalid.empty() && image.invalid[pixel] != 0;
  return marked || std::isnan(rgb[0]) || std::isnan(rgb[1]) || std::isnan(rgb[2]);
}

// Some pixels at a time, whose numbers stay in the nearest cache. Measured on one core with 512x512
// pixels: 2.3 ms, against 3.9 ms one by one.
template <typename Curve>
void display(const Image& image, double exposure, const Curve& curve, std::uint8_t* rgba) {
  constexpr std::size_t kPixels = 256;
  std::array<double, 3 * kPixels> linear{};
  std::array<std::uint8_t, 3 * kPixels> bytes{};
  const std::size_t all = image.rgb.size() / 3;
  for (std::size_t first = 0; first < all; first += kPixels) {
    const std::size_t count = std::min(kPixels, all - first);
    for (std::size_t i = 0; i < 3 * count; ++i)
      linear[i] = static_cast<double>(image.rgb[3 * first + i]) * exposure;
    for (std::size_t i = 0; i < 3 * count; i += 3) curve(&linear[i]);
    SrgbBytes::table().encode(std::span(linear).first(3 * count), bytes.data());
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t* to = rgba + 4 * (first + i);
      const std::uint8_t* from = &bytes[3 * i];
      const bool invalid = isInvalid(image, first + i);
      to[0] = invalid ? 255 : from[0];
      to[1] = invalid ? 0 : from[1];
      to[2] = invalid ? 255 : from[2];
      to[3] = 255;
    }
  }
}

}  // namespace

double toneMapped(double linear, const DisplaySettings& settings) {
  switch (settings.curve) {
    case ToneCurve::kClip:
      return linear;
    case ToneCurve::kReinhard:
      return reinhard(bounded(linear), settings.white);
    case ToneCurve::kFilmic:
      return filmic(bounded(linear));
  }
  return linear;
}

void displayImage(const Image& image, const DisplaySettings& settings,
                  std::vector<std::uint8_t>& rgba) {
  rgba.resize(image.rgb.size() / 3 * 4);
  switch (settings.curve) {
    case ToneCurve::kClip:
      return display(image, settings.exposure, Clip{}, rgba.data());
    case ToneCurve::kReinhard:
      return display(image, settings.exposure, Reinhard{settings.white}, rgba.data());
    case ToneCurve::kFilmic:
      return display(image, settings.exposure, Filmic{}, rgba.data());
  }
}

}  // namespace pathmark::preview
