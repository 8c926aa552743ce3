// pathmark pairs: mistakes that hide each other in the picture, part by part.
#include "commands/commands.h"
#include "film/atomic_file.h"
#include "host/build_config.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/output_file.h"
#include "host/progress_bar.h"
#include "host/session.h"
#include "pairs/pair_table.h"
#include "scene/limits.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct PairsArguments {
  std::vector<std::string> names;
  std::uint64_t seed = 1;
  unsigned threads = 0;
  std::string output;
};

std::vector<Pair> pairsAsked(const std::vector<std::string>& names) {
  std::vector<Pair> all = allPairs(), asked;
  if (names.empty()) return all;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Pair& p) { return p.name == name; });
    if (found == all.end())
      throw UsageError(fmt::format(
          "There is no pair {}: the names are those in grader/variants/pairs/pairs.json.", name));
    asked.push_back(*found);
  }
  return asked;
}

int runPairs(const PairsArguments& arguments) {
  if (!arguments.output.empty()) requirePlaceForFile("--output", arguments.output);
  const std::vector<Pair> asked = pairsAsked(arguments.names);
  pairs::PairStudy study(
      {arguments.seed, arguments.threads, fs::path(build::kBuildFolder) / "pairs"});
  std::vector<pairs::StudiedPair> studied;
  ProgressBar progress("pairs");
  bool good = true;
  for (const Pair& pair : asked) {
    if (interrupted()) return kInterrupted;
    progress.show(static_cast<double>(studied.size()) / static_cast<double>(asked.size()),
                  pair.name);
    studied.push_back({pair, study.of(pair)});
    progress.clear();
    fmt::print("{}", pairs::pairLine(studied.back()));
    std::fflush(stdout);
    good =
        good && pairs::hides(studied.back().finding) && pairs::caught(pair, studied.back().finding);
  }
  if (!arguments.output.empty())
    writeFileAtomically(arguments.output, pairs::pairChapter(studied, arguments.seed));
  return good ? kSuccess : kCourseworkFault;
}

}  // namespace

void addPairsCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<PairsArguments>();
  CLI::App* command =
      app.add_subcommand("pairs", "Try the checks on mistakes that hide each other in the picture");
  command->add_option("names", arguments->names, "Pairs; all by default")->type_name("PAIR");
  takesWholeNumber(command->add_option("--seed", arguments->seed, "Of pictures and checks (1)"), 0,
                   kMostRaysPerPixel);
  takesWholeNumber(
      command->add_option("--threads", arguments->threads, "One for each processor by default"), 1,
      1024);
  command->add_option("--output", arguments->output, "A Markdown file to write, with all numbers")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark pairs\n"
      "  ./pathmark pairs pi_in_the_loop --seed 7\n"
      "  ./pathmark pairs --output handouts/compensating_mistakes.md\n\n"
      "For each pair, the bias of its picture against the solutions', the least bias of one of its "
      "mistakes alone, and the functions that fail.\n"
      "Exit code: 0 if all hide in the picture and all are caught part by part, 1 if not, 130 if "
      "interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return runPairs(*arguments); }; });
}

}  // namespace pathmark
