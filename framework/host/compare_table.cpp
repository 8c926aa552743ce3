#include "film/printable.h"
#include "host/compare_report.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

namespace pathmark {

namespace {

using Text = std::back_insert_iterator<std::string>;

std::string originOf(const ImageOrigin& origin) {
  std::vector<std::string> parts;
  if (!origin.scene.empty()) parts.push_back(printable(origin.scene));
  if (!origin.coursework.empty()) parts.push_back(printable(origin.coursework));
  if (origin.raysPerPixel > 0.0)
    parts.push_back(fmt::format("{:.6g} rays per pixel in {} replicate{}, seed {}",
                                origin.raysPerPixel, origin.replicates,
                                origin.replicates == 1 ? "" : "s", origin.seed));
  if (origin.pixelsPerBlock > 1)
    parts.push_back(fmt::format("paths shared by {} pixels", origin.pixelsPerBlock));
  if (!origin.sampler.empty())
    parts.push_back(fmt::format("sampler {}", printable(origin.sampler)));
  if (!origin.paths.empty())
    parts.push_back(fmt::format("light paths {}", printable(origin.paths)));
  return parts.empty() ? "" : fmt::format("; {}", fmt::join(parts, ", "));
}

// An unknown error is a dash.
std::string error(double value, bool known) {
  return known ? fmt::format("{:.2g}", value) : std::string("-");
}

// Of black to black, or of anything to black, there is none.
std::string ratio(const RegionResult& r) {
  const double value = r.a / r.b;
  return std::isfinite(value) ? fmt::format("{:.5f}", value) : std::string("-");
}

void addNumbers(Text out, const RegionResult& r, const Comparison& comparison) {
  const Replicates& replicates = comparison.replicates;
  if (!replicates.any())
    fmt::format_to(out, "{:>12.6g} {:>12.6g} {:>9}", r.a, r.b, ratio(r));
  else
    fmt::format_to(out, "{:>12.6g} {:>9} {:>12.6g} {:>9} {:>9} {:>+9.2f} {:>9.2g}", r.a,
                   error(r.errorA, replicates.a > 0), r.b, error(r.errorB, replicates.b > 0),
                   ratio(r), r.z, r.pValue);
  fmt::format_to(out, "{}\n", r.differs && !comparison.undecided ? "  differs" : "");
}

void addHead(Text out, const char* first, const Replicates& replicates) {
  fmt::format_to(out, "{:<21} ", first);
  if (!replicates.any())
    fmt::format_to(out, "{:>12} {:>12} {:>9}\n", "mean A", "mean B", "A/B");
  else
    fmt::format_to(out, "{:>12} {:>9} {:>12} {:>9} {:>9} {:>9} {:>9}\n", "mean A", "error",
                   "mean B", "error", "A/B", "z", "p");
}

void addTiles(Text out, const CompareReport& report) {
  const Replicates& replicates = report.comparison.replicates;
  const std::vector<RegionResult> tiles = furthestTiles(report.comparison);
  if (tiles.empty()) return;
  fmt::format_to(out, "\nTiles of {0}x{0} pixels that are furthest apart, by their first pixel:\n",
                 report.settings.tile);
  addHead(out, "column    row channel", replicates);
  for (const RegionResult& r : tiles) {
    fmt::format_to(out, "{:>6} {:>6} {:<8}", r.region.left, r.region.top,
                   kChannelNames[static_cast<std::size_t>(r.channel)]);
    addNumbers(out, r, report.comparison);
  }
}

void addMeaningOfNumbers(Text out, const CompareReport& report) {
  const Comparison& comparison = report.comparison;
  const Replicates& replicates = comparison.replicates;
  if (comparison.undecided)
    fmt::format_to(out,
                   "\nz = (A - B) / error of {0}; p = probability of such a z if only the noise of "
                   "{0} differs.\n",
                   replicates.a > 0 ? 'A' : 'B');
  else if (replicates.any())
    fmt::format_to(
        out,
        "\nz = (A - B) / error; p = probability of such a z{} if only noise differs. A mean "
        "of the image\ndiffers from p = {:.2g} on, one of a tile from {:.2g} on: images "
        "that are the same are said to\ndiffer in {:.3g} of all comparisons.\n",
        report.settings.within ? ", less what --within accepts," : "", comparison.alphaOfWhole,
        comparison.alphaOfTile, report.settings.alpha);
}

}  // namespace

std::string compareTable(const CompareReport& report) {
  const Comparison& comparison = report.comparison;
  const Replicates& replicates = comparison.replicates;
  std::string text = verdictSentence(report) + "\n\n";
  const Text out = std::back_inserter(text);
  for (std::size_t i = 0; i < 2; ++i)
    fmt::format_to(out, "{}  {}: {}x{}{}\n", i == 0 ? 'A' : 'B', report.names[i].string(),
                   report.files[i].image.width, report.files[i].image.height,
                   originOf(report.files[i].origin));
  for (const std::string& note : compareNotes(report)) fmt::format_to(out, "{}\n", note);
  fmt::format_to(out,
                 "\nMSE     {:<12.6g} mean of (a - b)^2\n"
                 "relMSE  {:<12.6g} mean of (a - b)^2 / (b^2 + 0.01)\n\n",
                 comparison.mse, comparison.relativeMse);
  addHead(out, "image, channel", replicates);
  for (const RegionResult& r : comparison.whole) {
    fmt::format_to(out, "{:<22}", kChannelNames[static_cast<std::size_t>(r.channel)]);
    addNumbers(out, r, comparison);
  }
  addTiles(out, report);
  addMeaningOfNumbers(out, report);
  if (!report.pictures.empty()) text += '\n';
  for (const ComparePicture& picture : report.pictures)
    fmt::format_to(out, "{}: {}\n", picture.file.string(), picture.what);
  return text;
}

}  // namespace pathmark
