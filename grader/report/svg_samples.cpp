#include "report/svg_samples.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::report {

namespace {

using record::SampleDomain;
using record::SampleRecord;

constexpr std::size_t kMostPoints = 2000;
constexpr double kUnit = 100.0;  // of drawings, for 1

struct Place {
  double x = 0.0, y = 0.0;
  bool inside = true;
};

struct Places {
  std::vector<Place> upper, lower;  // of directions; places in the plane are all in `upper`
  std::size_t outside = 0, notFinite = 0;

  void add(std::vector<Place>& to, const Place& place) {
    outside += place.inside ? 0u : 1u;
    if (to.size() < kMostPoints) to.push_back(place);
  }
};

struct Direction {
  double x = 0.0, y = 0.0, z = 0.0;
};

std::optional<Direction> directionOf(const std::array<float, 3>& v) {
  const double length =
      std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  if (!std::isfinite(length) || length == 0.0) return std::nullopt;
  return Direction{v[0] / length, v[1] / length, v[2] / length};
}

// The equator has radius 1, the opposite pole radius sqrt(2); at that pole the direction on the
// disc does not exist, and any will do.
Place projected(const Direction& d, bool inside) {
  const double radius = std::hypot(d.x, d.z), scale = 1.0 / std::sqrt(std::max(1.0 + d.y, 0.0));
  if (!std::isfinite(scale) || radius == 0.0)
    return {d.y < 0.0 ? std::sqrt(2.0) : 0.0, 0.0, inside};
  return {d.x * scale, d.z * scale, inside};
}

Places placesOf(const SampleRecord& samples) {
  constexpr double kMargin = 0.1;
  Places places;
  for (const std::array<float, 3>& v : samples.yours) {
    if (samples.domain == SampleDomain::kPlane) {
      const double x = v[0], z = v[2];
      if (!std::isfinite(x) || !std::isfinite(z)) {
        ++places.notFinite;
        continue;
      }
      const bool inside = x >= 0.0 && x <= 1.0 && z >= 0.0 && z <= 1.0;
      places.add(places.upper, {std::clamp(x, -kMargin, 1.0 + kMargin),
                                std::clamp(z, -kMargin, 1.0 + kMargin), inside});
      continue;
    }
    const std::optional<Direction> d = directionOf(v);
    if (!d)
      ++places.notFinite;
    else if (samples.domain == SampleDomain::kHemisphere)
      places.add(places.upper, projected(*d, d->y >= 0.0));
    else if (d->y >= 0.0)
      places.add(places.upper, projected(*d, true));
    else
      places.add(places.lower, projected({d->x, -d->y, d->z}, true));
  }
  return places;
}

// Dots are lines of no length with round ends: the shortest way to draw thousands.
Markup points(const std::vector<Place>& places) {
  std::string dots, crosses;
  for (const Place& p : places) {
    const double x = kUnit * p.x, y = 0.0 - kUnit * p.y;
    if (p.inside)
      dots += fmt::format("M{:.1f} {:.1f}h0", x, y);
    else
      crosses += fmt::format("M{:.1f} {:.1f}l4 4m-4 0l4 -4", x - 2.0, y - 2.0);
  }
  Markup drawn = markup("<path class=\"dots\" d=\"{}\"/>", dots);
  if (!crosses.empty()) drawn += markup("<path class=\"crosses\" d=\"{}\"/>", crosses);
  return drawn;
}

// Four rings of equal solid angle: cos(theta) = 3/4, 1/2, 1/4, 0.
Markup rings() {
  Markup drawn;
  for (const double cosine : {0.75, 0.5, 0.25})
    drawn += markup("<circle class=\"grid\" r=\"{:.1f}\"/>", kUnit * std::sqrt(1.0 - cosine));
  drawn += Markup{"<path class=\"grid\" d=\"M-100 0H100M0 -100V100\"/>"};
  drawn += markup("<circle class=\"rim\" r=\"{:.0f}\"/>", kUnit);
  return drawn;
}

Markup disc(const std::vector<Place>& places, const char* name, bool below) {
  const double half = kUnit * (below ? 1.48 : 1.06);
  return markup(
      "<figure class=\"disc\"><svg viewBox=\"{0:.0f} {0:.0f} {1:.0f} {1:.0f}\" role=\"img\" "
      "aria-label=\"{2}\">{3}{4}</svg><figcaption>{2}</figcaption></figure>",
      -half, 2.0 * half, name, rings(), points(places));
}

Markup square(const std::vector<Place>& places, bool beyond) {
  const double margin = kUnit * (beyond ? 0.14 : 0.03);
  return markup(
      "<figure class=\"disc\"><svg viewBox=\"{0:.0f} {1:.0f} {2:.0f} {2:.0f}\" role=\"img\" "
      "aria-label=\"samples in the unit square\">"
      "<path class=\"grid\" d=\"M25 -100V0M50 -100V0M75 -100V0M0 -25H100M0 -50H100M0 -75H100\"/>"
      "<rect class=\"rim\" y=\"-100\" width=\"100\" height=\"100\"/>{3}</svg></figure>",
      -margin, -kUnit - margin, kUnit + 2.0 * margin, points(places));
}

Markup drawingOf(SampleDomain domain, const Places& places) {
  switch (domain) {
    case SampleDomain::kPlane:
      return square(places.upper, places.outside > 0);
    case SampleDomain::kHemisphere:
      return disc(places.upper, "seen along the normal", places.outside > 0);
    case SampleDomain::kSphere:
      break;
  }
  Markup both = disc(places.upper, "upper half", false);
  both += disc(places.lower, "lower half", false);
  return both;
}

}  // namespace

Markup samplePlot(const SampleRecord& samples) {
  if (samples.yours.empty()) return {};
  const Places places = placesOf(samples);
  std::string words = fmt::format("{} samples", samples.yours.size());
  if (!samples.inputs.empty()) words += fmt::format(", {}", samples.inputs);
  if (places.outside > 0)
    words += fmt::format(
        "; {} {}, drawn as crosses", places.outside,
        samples.domain == SampleDomain::kHemisphere ? "below the horizon" : "outside of the shape");
  if (places.notFinite > 0) words += fmt::format("; {} without a direction", places.notFinite);
  const char* rings =
      samples.domain == SampleDomain::kPlane ? "" : ". Equal areas are equal solid angles.";
  return markup(
      "<figure class=\"samples\"><div class=\"discs\">{}</div><figcaption>{}{}</figcaption>"
      "</figure>\n",
      drawingOf(samples.domain, places), words, rings);
}

}  // namespace pathmark::report
