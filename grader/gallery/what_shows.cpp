#include "gallery/what_shows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::gallery {

namespace {

constexpr double kSeen = 0.02;     // relative: less is not seen
constexpr double kNoisier = 1.15;  // ratio of standard errors, likewise
constexpr int kFields = 3;         // along each side
constexpr double kDark = 0.1;      // fields darker than this share of the mean are compared with it

constexpr const char* kRows[kFields] = {"top", "", "bottom"};
constexpr const char* kColumns[kFields] = {"left", "", "right"};

std::string nameOfField(int row, int column) {
  const std::string r = kRows[row], c = kColumns[column];
  if (r.empty() && c.empty()) return "in the middle";
  return fmt::format("at the {}{}{}", r, r.empty() || c.empty() ? "" : " ", c);
}

double sumIn(const Image& image, int row, int column) {
  double sum = 0.0;
  for (int j = row * image.height / kFields; j < (row + 1) * image.height / kFields; ++j)
    for (int i = column * image.width / kFields; i < (column + 1) * image.width / kFields; ++i)
      for (const float x : image.pixel(i, j)) sum += double{x};
  return sum;
}

void findFields(const Image& wrong, const Image& correct, Showing& showing) {
  double all = 0.0;
  for (const float x : correct.rgb) all += double{x};
  const double least = std::max(kDark * all / (kFields * kFields), 1e-30);
  showing.brightest = -HUGE_VAL;
  showing.darkest = HUGE_VAL;
  for (int row = 0; row < kFields; ++row)
    for (int column = 0; column < kFields; ++column) {
      const double b = sumIn(correct, row, column);
      const double error = (sumIn(wrong, row, column) - b) / std::max(b, least);
      if (error > showing.brightest) {
        showing.brightest = error;
        showing.brightestField = nameOfField(row, column);
      }
      if (error < showing.darkest) {
        showing.darkest = error;
        showing.darkestField = nameOfField(row, column);
      }
    }
}

// Relative to the correct picture's, pixel by pixel the median: a few bright dots do not decide.
double noiseRatio(const Image& wrong, const Image& correct) {
  std::vector<double> ratios;
  if (wrong.variance.empty() || correct.variance.empty()) return 1.0;
  for (std::size_t v = 0; v < correct.rgb.size(); ++v) {
    const double a = double{wrong.variance[v]}, b = double{correct.variance[v]};
    if (std::isfinite(a) && b > 0.0) ratios.push_back(std::sqrt(a / b));
  }
  if (ratios.empty()) return 1.0;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

std::string amount(double relative) {
  if (relative > 9.0) return "more than 10 times as bright";
  if (relative > 1.0) return fmt::format("{:.1f} times as bright", 1.0 + relative);
  return fmt::format("{:.0f} % {}", 100.0 * std::abs(relative),
                     relative > 0.0 ? "brighter" : "darker");
}

// "12 % brighter at the top left, 5 % darker in the middle".
std::string places(const Showing& s) {
  if (s.darkest >= -kSeen)
    return fmt::format("{} {}, {} {}", amount(s.brightest), s.brightestField,
                       s.darkest > kSeen ? amount(s.darkest) : "hardly different", s.darkestField);
  if (s.brightest <= kSeen)
    return fmt::format("{} {}, {} {}", amount(s.darkest), s.darkestField,
                       s.brightest < -kSeen ? amount(s.brightest) : "hardly different",
                       s.brightestField);
  return fmt::format("{} {}, {} {}", amount(s.brightest), s.brightestField, amount(s.darkest),
                     s.darkestField);
}

std::string meanWords(const Showing& s) {
  static constexpr const char* kChannels[] = {"red", "green", "blue"};
  const double mean = (s.mean[0] + s.mean[1] + s.mean[2]) / 3.0;
  const auto [least, most] = std::minmax_element(s.mean.begin(), s.mean.end());
  std::string text;
  if (mean < -0.97) return "All but black.";
  if (std::abs(mean) < kSeen)
    text = "As bright as it should be on the whole";
  else
    text = fmt::format("On the whole {}", amount(mean));
  const double spread = *most - *least;
  if (spread > std::max(0.05, 0.3 * std::abs(mean)))
    text += fmt::format(
        ", most of it in {}",
        kChannels[(std::abs(*most) > std::abs(*least) ? most : least) - s.mean.begin()]);
  const double range = s.brightest - s.darkest;
  if (std::abs(mean) < kSeen && range < 2.0 * kSeen)
    return "As bright as it should be on the whole and in its larger parts: look along edges.";
  if (range < std::max(0.04, 0.15 * std::abs(mean))) return text + ", everywhere alike.";
  return fmt::format("{}: {}.", text, places(s));
}

}  // namespace

Showing whatShows(const marking::Measured& wrong, const marking::Measured& correct) {
  Showing showing;
  showing.bias = marking::tileBias(wrong.image, correct.image);
  const auto errors = marking::meanErrors(wrong.image, correct.image);
  for (std::size_t c = 0; c < 3; ++c) showing.mean[c] = errors[c].value;
  findFields(wrong.image, correct.image, showing);
  showing.noise = noiseRatio(wrong.image, correct.image);
  return showing;
}

bool showsInMeans(const Showing& showing) { return showing.bias.low > kSeen; }

std::string lookFor(const Showing& s) {
  const std::string noise =
      s.noise > kNoisier ? fmt::format("The noise is {:.1f} times the correct picture's.", s.noise)
                         : std::string();
  if (showsInMeans(s)) return meanWords(s);
  if (!noise.empty()) return "Right in the mean, and noisier. " + noise;
  if (s.bias.low > 0.0)
    return fmt::format(
        "Off by about {:.1f} %, hardly more than its noise: the picture alone does not show this.",
        100.0 * s.bias.value);
  return "The picture alone does not show this.";
}

}  // namespace pathmark::gallery
