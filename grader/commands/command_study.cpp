// pathmark study: do the checks accept what is right and find what is wrong, under many seeds?
#include "commands/commands.h"
#include "host/build_config.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/progress_bar.h"
#include "host/session.h"
#include "study/study.h"
#include "study/study_report.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct StudyArguments {
  std::vector<std::string> what;
  int seeds = 20;
  unsigned threads = 0;
  bool images = false;
  bool functionOnly = false;
  std::string log = (fs::path(build::kBuildFolder) / "study/records.jsonl").string();
};

// Errors of half a per cent or one: the smallest that the checks promise to find.
constexpr const char* kSlight = "slight";

bool isSlight(const Variant& variant) { return variant.name.find("_slight_") != std::string::npos; }

std::string sectionOf(const std::string& function) {
  for (const FunctionContract& f : contract())
    if (f.name == function) return std::string(f.section);
  throw std::logic_error(function + " is no function of the contract");
}

std::vector<study::StudySubject> subjectsOf(const StudyArguments& arguments) {
  const auto asked = [&](const std::string& name) {
    return arguments.what.empty() ||
           std::find(arguments.what.begin(), arguments.what.end(), name) != arguments.what.end();
  };
  const fs::path scratch = fs::path(build::kBuildFolder) / "study/variants";
  std::vector<study::StudySubject> subjects;
  if (asked("solutions")) subjects.push_back(study::solutionsSubject(arguments.images));
  std::vector<std::string> known{"solutions", "correct", "wrong", kSlight};
  for (const Variant& variant : allVariants()) {
    known.push_back(variant.name);
    const bool wanted = asked(variant.wrong ? "wrong" : "correct") || asked(variant.name) ||
                        (isSlight(variant) && asked(kSlight));
    if (!wanted) continue;
    if (arguments.images && variant.wrong) continue;
    subjects.push_back(study::variantSubject(variant, arguments.images, scratch));
    if (arguments.functionOnly && variant.wrong)
      subjects.back().selection.only = sectionOf(variant.function);
  }
  for (const std::string& word : arguments.what)
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw UsageError(
          fmt::format("There is no {} to study: it is solutions, correct, wrong, slight, or the "
                      "name of a patch in "
                      "grader/variants/ without .patch.",
                      word));
  return subjects;
}

int runStudyCommand(const StudyArguments& arguments) {
  const std::vector<study::StudySubject> subjects = subjectsOf(arguments);
  study::StudyLog log(arguments.log);
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  ProgressBar progress("study");
  const auto goOn = [&](const study::StudyProgress& p) {
    progress.show(
        static_cast<double>(p.done) / static_cast<double>(std::max<std::size_t>(p.all, 1)),
        fmt::format("{} of {} runs, {:.0f} min left", p.done, p.all, p.secondsLeft / 60.0));
    return !interrupted();
  };
  const std::vector<study::StudyRecord> records =
      study::runStudy(subjects, arguments.seeds,
                      arguments.threads != 0 ? arguments.threads : processors, log, goOn);
  progress.clear();
  const study::StudyReport report = study::reportStudy(subjects, records);
  fmt::print("{}", report.text);
  if (interrupted()) {
    fmt::print(stderr, "Interrupted; the same command goes on from here.\n");
    return kInterrupted;
  }
  return report.asItMustBe ? kSuccess : kCourseworkFault;
}

}  // namespace

void addStudyCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand(
      "study", "Try the checks on what is known to be right or wrong, under many seeds");
  command
      ->add_option("what", arguments->what,
                   "solutions, correct, wrong, slight (errors of 1 % and less), or names of "
                   "variants; all by default")
      ->type_name("SUBJECT");
  takesWholeNumber(command->add_option("--seeds", arguments->seeds, "Seeds for each (20)"), 1,
                   1000000);
  takesWholeNumber(command->add_option("--threads", arguments->threads,
                                       "Runs at the same time; one for each processor by default"),
                   1, 1024);
  command->add_flag("--images", arguments->images, "The checks of pictures, of what is right");
  command->add_flag("--function-only", arguments->functionOnly,
                    "Of what is wrong, only the checks of the function that has the mistake");
  command
      ->add_option("--log", arguments->log,
                   "Where records are kept; what is there already is not run again")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark study                             (20 seeds of everything)\n"
      "  ./pathmark study solutions --seeds 1000      (go on with Ctrl-C and the same command)\n"
      "  ./pathmark study solutions --images --seeds 200\n"
      "  ./pathmark study wrong --seeds 1\n"
      "  ./pathmark study slight --function-only --seeds 1000\n"
      "                                               (how often errors of 1 % are found)\n\n"
      "Exit code: 0 if all that is right passed and all that is wrong was found, 1 if not, 130 if "
      "interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return runStudyCommand(*arguments); }; });
}

}  // namespace pathmark
