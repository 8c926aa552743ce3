// pathmark compare: how two images differ, and whether by more than their noise.
#include "film/atomic_file.h"
#include "film/signed_picture.h"
#include "host/commands.h"
#include "host/compare_report.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/session.h"
#include "stats/quantiles.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <limits>
#include <memory>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// As cmp and diff have them, and one more.
enum CompareExit : int { kSame = 0, kDiffer = 1, kTrouble = 2, kUndecided = 3 };

struct CompareArguments {
  std::string a, b;
  std::string difference, zMap;
  std::string within;
  double scale = 0.0;  // 0: by the values
  bool json = false;
  CompareSettings settings;
};

// "1%" or "0.01". Returns whether it is a number from 0 to 1.
bool parseFraction(const std::string& text, double& fraction) {
  const char* end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, fraction);
  const bool percent = error == std::errc{} && next + 1 == end && *next == '%';
  if (percent) fraction /= 100.0;
  return error == std::errc{} && (percent || next == end) && fraction >= 0.0 && fraction <= 1.0;
}

std::string checkFraction(const std::string& text) {
  double fraction = 0.0;
  if (parseFraction(text, fraction)) return {};
  return "found " + text + ", allowed is a fraction such as 1% or 0.01, from 0 to 1";
}

// What can be known before the work begins must not cost it. An input is not to be overwritten.
void refuseOutput(const char* option, const fs::path& file, const CompareArguments& arguments,
                  std::initializer_list<const char*> endings) {
  requireOutput(option, file, endings);
  for (const std::string& input : {arguments.a, arguments.b})
    if (sameFile(file, input))
      throw UsageError(fmt::format("{} {}: this is one of the images that are compared.", option,
                                   file.string()));
}

void writeDifference(const CompareArguments& arguments, CompareReport& report) {
  const fs::path file = arguments.difference;
  const Image difference = differenceImage(report.files[0].image, report.files[1].image);
  if (imageEnding(file) != ".png") {
    writeImage(file, difference, 1.0);
    report.pictures.push_back({.file = file, .what = "a - b in every pixel and channel."});
    return;
  }
  const std::vector<float> values = largestOfChannels(difference, report.comparison.pixels);
  const bool given = arguments.scale > 0.0;
  const double scale = given ? arguments.scale : fullColour(values);
  writeFileAtomically(file, encodeSignedPng(difference.width, difference.height, values, scale));
  report.pictures.push_back(
      {.file = file,
       .what =
           fmt::format("red where A is larger, blue where B is, white where they are equal; full "
                       "colour from {:.4g}{}, of the channel that differs most.",
                       scale, given ? "" : ", which 1 % of the pixels exceed"),
       .fullColour = scale});
}

void writeZMap(const CompareArguments& arguments, CompareReport& report) {
  const Comparison& comparison = report.comparison;
  const Image& a = report.files[0].image;
  // Student's t of many degrees of freedom: the least that any tile needs.
  const double critical =
      comparison.tiles.empty()
          ? 1.0
          : stats::studentCritical(comparison.alphaOfTile, std::numeric_limits<double>::infinity());
  writeFileAtomically(
      arguments.zMap,
      encodeSignedPng(a.width, a.height, tileScores(a.width, a.height, comparison), critical));
  report.pictures.push_back(
      {.file = arguments.zMap,
       .what =
           fmt::format("z of each tile, red where A is larger, blue where B is; full colour from "
                       "{:.3g}, which is significant.",
                       critical),
       .fullColour = critical});
}

int compare(const CompareArguments& arguments) {
  if (!arguments.difference.empty())
    refuseOutput("--difference", arguments.difference, arguments, {".png", ".exr", ".pfm"});
  if (!arguments.zMap.empty()) refuseOutput("--z-map", arguments.zMap, arguments, {".png"});
  if (!arguments.difference.empty() && !arguments.zMap.empty() &&
      sameFile(arguments.difference, arguments.zMap))
    throw UsageError(
        fmt::format("--z-map {}: this is also the file of --difference, and each "
                    "picture needs a file of its own.",
                    arguments.zMap));
  CompareReport report{.names = {arguments.a, arguments.b},
                       .files = {readImage(arguments.a), readImage(arguments.b)},
                       .settings = arguments.settings,
                       .comparison = {}};
  double within = 0.0;
  if (parseFraction(arguments.within, within)) report.settings.within = within;
  report.comparison = compareImages(report.files[0], report.files[1], report.settings);
  if (!arguments.zMap.empty() && !report.comparison.replicates.any())
    throw UsageError("--z-map: neither image has variances, and z needs those.");
  if (!arguments.difference.empty()) writeDifference(arguments, report);
  if (!arguments.zMap.empty()) writeZMap(arguments, report);
  fmt::print("{}", arguments.json ? compareJson(report) : compareTable(report));
  if (report.comparison.undecided) return kUndecided;
  return report.comparison.same ? kSame : kDiffer;
}

// Also what other commands have other codes for, such as a file that cannot be written.
int compareOrComplain(const CompareArguments& arguments) {
  try {
    return compare(arguments);
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return kTrouble;
  }
}

void addOptions(CLI::App* command, const std::shared_ptr<CompareArguments>& arguments) {
  constexpr const char* kImage = ": .exr, .hdr, .pfm or .png";
  command->add_option("A", arguments->a, std::string("An image") + kImage)
      ->required()
      ->type_name("");
  command->add_option("B", arguments->b, std::string("The reference") + kImage)
      ->required()
      ->type_name("");
  CLI::Option* difference =
      command
          ->add_option("--difference", arguments->difference,
                       "Write a - b: .png in red and blue, .exr or .pfm as numbers")
          ->type_name("FILE");
  CLI::Option* scale =
      command->add_option("--scale", arguments->scale,
                          "Difference in full colour (default: what 1 % of the pixels exceed)");
  takesNumber(scale, 1e-30, 1e30, "X");
  scale->needs(difference);
  command
      ->add_option("--z-map", arguments->zMap,
                   "Write a .png of the tiles' differences in standard errors")
      ->type_name("FILE");
  takesWholeNumber(command->add_option("--tile", arguments->settings.tile,
                                       "Pixels per side of a tile (default: 8)"),
                   1, 65536);
  takesNumber(command->add_option(
                  "--alpha", arguments->settings.alpha,
                  "Share of comparisons in which noise alone is called a difference (default: "
                  "0.001)"),
              1e-12, 0.5, "P");
  command
      ->add_option("--within", arguments->within,
                   "Accept means of the image and its tiles that differ by this share, such as 1%; "
                   "in dark tiles of 1 % of the reference's mean")
      ->check(CLI::Validator(checkFraction, ""))
      ->type_name("SHARE");
  command->add_flag("--json", arguments->json, "Print the numbers as JSON");
}

}  // namespace

void addCompareCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", "Say how two images differ");
  addOptions(command, arguments);
  command->footer(
      "Examples:\n"
      "  ./pathmark compare mine.exr reference.exr\n"
      "  ./pathmark compare mine.exr reference.exr --difference d.png --z-map z.png\n"
      "  ./pathmark compare a.pfm b.pfm --within 1%\n"
      "  ./pathmark compare a.exr b.exr --json\n\n"
      "Images with variances (.exr) are the same if nothing but noise tells them apart: the means\n"
      "of all tiles and of the whole image are tested. Others are the same if every value is "
      "equal,\n"
      "or with --within if these means agree. Pixels without a value are left out.\n"
      "Of an image with variances and one without, a difference may be noise that nobody knows:\n"
      "without --within, that is no verdict.\n"
      "Exit code: 0 the same, 1 they differ, 2 they could not be compared, 3 one of them does not\n"
      "say how noisy it is, and it cannot be told.");
  command->callback(
      [arguments, &action] { action = [arguments] { return compareOrComplain(*arguments); }; });
}

}  // namespace pathmark
