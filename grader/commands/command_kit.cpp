// pathmark kit: a folder that can be given to students.
#include "commands/commands.h"
#include "host/build_config.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/shell_word.h"
#include "kit/kit_plan.h"
#include "kit/write_kit.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace pathmark {

namespace {

struct KitArguments {
  std::string folder;
  int releasedThrough = kit::kNothingReleased;
};

std::string whatIsSolved(int releasedThrough) {
  if (releasedThrough == kit::kNothingReleased) return "No part is solved.";
  if (releasedThrough == 0) return "Part 0 is solved, the others are stubs.";
  if (releasedThrough == kit::kLastPart) return "All parts are solved.";
  return fmt::format("Parts 0 to {} are solved, the others are stubs.", releasedThrough);
}

void complainOf(const kit::Inspection& inspection) {
  constexpr std::size_t kMostLines = 20;
  const std::vector<std::string>& findings = inspection.findings;
  for (std::size_t k = 0; k < findings.size() && k < kMostLines; ++k)
    fmt::print(stderr, "{}\n", findings[k]);
  if (findings.size() > kMostLines)
    fmt::print(stderr, "and {} more.\n", findings.size() - kMostLines);
  fmt::print(stderr, "No kit was written.\n");
}

int runKitCommand(const KitArguments& arguments) {
  const kit::KitPlan plan = kit::planKit(build::kProjectFolder, arguments.releasedThrough);
  const kit::WrittenKit written =
      kit::writeKit(plan, arguments.folder, [] { return !interrupted(); });
  const kit::Inspection& inspection = written.inspection;
  switch (written.outcome) {
    case kit::KitOutcome::kStopped:
      fmt::print(stderr, "Interrupted; no kit was written.\n");
      return kInterrupted;
    case kit::KitOutcome::kRefused:
      complainOf(inspection);
      return kCourseworkFault;
    case kit::KitOutcome::kWritten:
      break;
  }
  fmt::print("{} files are in {}. {}\n", inspection.files, displayPath(arguments.folder),
             whatIsSolved(arguments.releasedThrough));
  fmt::print(
      "Nothing of the {} hidden files is among their {:.1f} MB, neither copied nor "
      "quoted.\n",
      inspection.hiddenFiles, static_cast<double>(inspection.bytes) * 1e-6);
  fmt::print("Try it as a student would: cd {} && ./pathmark demo\n",
             shellWord(displayPath(arguments.folder)));
  return kSuccess;
}

}  // namespace

void addKitCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<KitArguments>();
  CLI::App* command =
      app.add_subcommand("kit", "Make a folder for students, without anything that is hidden");
  command->add_option("DIR", arguments->folder, "Where; a new folder, or an empty one")
      ->type_name("")
      ->required();
  takesWholeNumber(
      command->add_option("--release-through", arguments->releasedThrough,
                          "Solve the parts up to this one: 0 to 6, 7 for the scene of part 7 "
                          "too, 8 or 9 for the bonus parts (default: none)"),
      0, kit::kLastPart);
  command->footer(
      "Examples:\n"
      "  ./pathmark kit ../pathmark-kit                         (the first week: stubs only)\n"
      "  ./pathmark kit ../week4 --release-through 2            (with the answers of parts 0 to "
      "2)\n\n"
      "What is in a kit is listed in grader/kit/contents.txt; handouts/instructors.md tells more.\n"
      "The kit is searched before it gets its name, pictures included.\n\n"
      "Exit code: 0 if the kit is written; 1 if it would hold what is hidden, 2 for a folder that "
      "cannot be used, 3 if the machine failed, such as where the disk is full, 130 if "
      "interrupted; "
      "then there is no kit.");
  command->callback(
      [arguments, &action] { action = [arguments] { return runKitCommand(*arguments); }; });
}

}  // namespace pathmark
