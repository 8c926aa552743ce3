// pathmark gallery: what each known mistake does to a picture.
#include "commands/commands.h"
#include "film/atomic_file.h"
#include "gallery/gallery_chapter.h"
#include "gallery/gallery_sheet.h"
#include "gallery/make_gallery.h"
#include "host/build_config.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/progress_bar.h"
#include "host/session.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct GalleryArguments {
  std::vector<int> parts;
  unsigned threads = 0;
  std::string output = (fs::path(build::kProjectFolder) / "handouts/mistakes_gallery.md").string();
};

std::vector<Variant> mistakesOf(const std::vector<int>& parts) {
  std::vector<Variant> mistakes;
  for (Variant& variant : allVariants())
    if (variant.wrong &&
        (parts.empty() || std::find(parts.begin(), parts.end(), variant.part) != parts.end()))
      mistakes.push_back(std::move(variant));
  return mistakes;
}

void writeGallery(const gallery::Gallery& made, const fs::path& chapter) {
  const fs::path figures = chapter.parent_path() / "figures";
  fs::create_directories(figures);
  for (const PartContract& part : parts()) {
    const std::vector<gallery::Group> groups = gallery::groupsOf(made, part.part);
    if (groups.empty()) continue;
    const std::string png = gallery::sheetPng(groups);
    writeFileAtomically(figures / gallery::sheetName(part.part), png);
    fmt::print("{}: {} kB\n", gallery::sheetName(part.part), png.size() / 1000);
  }
  std::ifstream in(chapter, std::ios::binary);
  const std::string before{std::istreambuf_iterator<char>(in), {}};
  writeFileAtomically(chapter, gallery::galleryChapter(made, before));
}

int runGallery(const GalleryArguments& arguments) {
  requirePlaceForFile("--output", arguments.output);
  const std::vector<Variant> mistakes = mistakesOf(arguments.parts);
  ProgressBar progress("gallery");
  const gallery::Gallery made = gallery::makeGallery(
      mistakes, {arguments.threads, fs::path(build::kBuildFolder) / "gallery"},
      [&](std::size_t done, const std::string& name) {
        progress.show(static_cast<double>(done) / static_cast<double>(mistakes.size()),
                      fmt::format("{} of {}, {}", done, mistakes.size(), name));
        return !interrupted();
      });
  progress.clear();
  for (const gallery::Specimen& s : made.specimens)
    fmt::print("{:<44} {:<15} {}\n", s.variant.name, s.scene, s.words);
  if (made.specimens.size() < mistakes.size()) {
    fmt::print(stderr, "Interrupted: nothing was written. What was compiled is kept.\n");
    return kInterrupted;
  }
  writeGallery(made, arguments.output);
  return kSuccess;
}

}  // namespace

void addGalleryCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<GalleryArguments>();
  CLI::App* command = app.add_subcommand(
      "gallery", "Render what each known mistake does to a picture, as a chapter of the handouts");
  command->add_option("--part", arguments->parts, "Mistakes of these parts only; all by default")
      ->check(CLI::Range(0, 9))
      ->type_name("PART");
  takesWholeNumber(command->add_option("--threads", arguments->threads,
                                       "Mistakes at the same time; one for each processor by "
                                       "default"),
                   1, 1024);
  command
      ->add_option("--output", arguments->output,
                   "The Markdown file to write, its pictures go to figures/ beside it (default: "
                   "handouts/mistakes_gallery.md)")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark gallery\n"
      "  ./pathmark gallery --part 3 --output /tmp/gallery/part3.md\n\n"
      "What stands above the first part in the chapter is kept; the rest is made anew. "
      "For each mistake the scene is taken in which its picture is furthest from the correct one. "
      "Those that do not show in the mean are shown with few rays per pixel.\n"
      "Exit code: 0 done, 2 the command line is at fault, 3 the machine is, 130 interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return runGallery(*arguments); }; });
}

}  // namespace pathmark
