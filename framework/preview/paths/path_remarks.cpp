#include "preview/paths/path_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pathmark::preview {

namespace {

constexpr double kClose = 2e-3;

bool close(double a, double b) {
  return std::abs(a - b) <= kClose * std::max(std::abs(a), std::abs(b));
}

bool close(const Colour& a, const Colour& b) {
  const auto size = static_cast<double>(std::max({std::abs(a.r), std::abs(a.g), std::abs(a.b)}));
  for (int c = 0; c < 3; ++c)
    if (!(std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c])) <= kClose * size))
      return false;
  return size > 0.0;
}

// own / expected, if it is one number for all channels.
std::optional<double> commonRatio(const Colour& own, const Colour& expected) {
  std::optional<double> ratio;
  for (int c = 0; c < 3; ++c) {
    if (expected[c] == 0.0f) continue;
    const double r = static_cast<double>(own[c]) / static_cast<double>(expected[c]);
    if (ratio && !close(r, *ratio)) return std::nullopt;
    ratio = r;
  }
  return ratio;
}

// The likeliest reason for a step of the throughput that is not f cos / pdf.
std::string stepReason(const ThroughputStep& step) {
  if (close(step.own, step.before)) return " It has not been changed at all.";
  const std::optional<double> ratio = commonRatio(step.own, step.expected);
  if (!ratio) return "";
  const double cosine = step.scattering.cosine, pdf = step.scattering.pdf;
  struct Reason {
    double ratio;
    const char* text;
  };
  for (const Reason& reason : std::array<Reason, 4>{
           {{1.0 / cosine, " Is the cosine missing?"},
            {pdf, " Is the division by the density missing?"},
            {pdf / cosine, " Are the cosine and the division by the density missing?"},
            {1.0 / static_cast<double>(step.weightBefore),
             " Is the roulette's weight of the vertex before missing?"}}})
    if (close(*ratio, reason.ratio)) return reason.text;
  return "";
}

// The likeliest reason for a sum that does not fit.
std::string sumReason(const Colour& missing, const TracedPath& path, const PathAccount& account) {
  Colour withoutThroughput(0.0f), withoutWeights(0.0f);
  for (std::size_t k = 0; k < path.vertices.size(); ++k) {
    const PathVertex& vertex = path.vertices[k];
    const VertexAccount& v = account.vertices[k];
    if (v.emissionWeight && close(missing, v.throughput * vertex.emission - v.emission))
      return fmt::format(" What vertex {} emits has not been weighted.", k + 1);
    if (v.found) {
      withoutWeights -= v.direct;
      for (const Colour& c : v.shadowRays) withoutWeights += v.throughput * c;
    }
    if (k > 0 && vertex.seenFromFront() && close(missing, v.throughput * vertex.emission))
      return fmt::format(
          " That is what vertex {} emits: direct lighting at the vertex before has counted it.",
          k + 1);
    if (k == 0 && close(missing, -v.emission))
      return " What vertex 1 emits towards the camera is missing.";
    if (close(missing, -v.direct))
      return fmt::format(" The direct light of vertex {} is missing.", k + 1);
    if (k > 0 && close(missing, -v.emission))
      return fmt::format(" What vertex {} emits is missing.", k + 1);
    if (vertex.direct) withoutThroughput += *vertex.direct - v.direct;
    if (v.found) withoutThroughput += *v.found - v.direct;
  }
  if (close(missing, withoutWeights)) return " Light samples have not been weighted.";
  if (close(missing, withoutThroughput))
    return " Direct light has not been multiplied by the throughput.";
  return "";
}

}  // namespace

std::string shortNumber(double value) {
  if (std::isnan(value)) return "nan";
  return fmt::format("{:.3g}", value);
}

std::string shortColour(const Colour& c) {
  if (c.r == c.g && c.g == c.b) return shortNumber(static_cast<double>(c.r));
  return fmt::format("{} {} {}", shortNumber(static_cast<double>(c.r)),
                     shortNumber(static_cast<double>(c.g)), shortNumber(static_cast<double>(c.b)));
}

std::string stepRemark(std::size_t k, const ThroughputStep& step) {
  return fmt::format("Vertex {}: the throughput becomes {}, but {} times f cos / pdf is {}.{}",
                     k + 1, shortColour(step.own), shortColour(step.before),
                     shortColour(step.expected), stepReason(step));
}

std::string directRemark(std::size_t k, const Colour& returned, const Colour& sum) {
  return fmt::format(
      "Vertex {}: directLighting returned {}, but Le f G V / pdf of its shadow rays adds up to {}.",
      k + 1, shortColour(returned), shortColour(sum));
}

std::string sumRemark(const TracedPath& path, const PathAccount& account) {
  return fmt::format("The path returned {}, but its parts add up to {}.{}",
                     shortColour(path.radiance), shortColour(account.explained),
                     sumReason(path.radiance - account.explained, path, account));
}

std::string weightRemark(std::size_t k, std::string_view notAsked) {
  return fmt::format(
      "Vertex {}: {} has not been called, and the weight of what is found cannot do without.",
      k + 1, notAsked);
}

std::string tooLongRemark(int dropped) {
  return fmt::format(
      "This path calls more functions than are recorded: {} calls at its end are left out.",
      dropped);
}

}  // namespace pathmark::preview
