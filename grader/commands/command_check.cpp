// pathmark check: is the coursework right, and if not, where to look.
#include "checks/all_checks.h"
#include "checks/runner.h"
#include "commands/commands.h"
#include "commands/progress_line.h"
#include "commands/selection.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/session.h"
#include "report/terminal.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>

#include <unistd.h>

namespace pathmark {

namespace {

struct CheckArguments {
  std::string what;
  std::string with = "student";
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

bool showsColour() { return isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr; }

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

int checkOnce(const CheckArguments& arguments) {
  const std::filesystem::path folder = findCoursework(arguments.with);
  const checks::Selection selection = selectChecks(arguments.what);
  const report::Style style{showsColour(), arguments.with};
  const CourseworkBuild build = buildCoursework(folder, Incomplete::kCompileOnly);
  checks::RunOptions options;
  options.seed = arguments.seed;
  options.threads = arguments.threads;
  options.onText = [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); };
  checks::RunEvents events;
  ProgressLine progress;
  events.onProgress = [&](double fraction, const std::string& id) { progress.show(fraction, id); };
  events.onFunctions = [&](const checks::CourseworkResults& results) {
    progress.clear();
    print(report::headline(results, folder, style) + report::functionLines(results, style));
  };
  const checks::CourseworkResults results = checks::runChecks(build, selection, options, events);
  progress.clear();
  print(report::imageLines(results, style) + report::sceneLines(results, style));
  return results.anythingWrong() ? kCourseworkFault : kSuccess;
}

}  // namespace

void addCheckCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command =
      app.add_subcommand("check", "Say what is right, what is wrong, and where to look");
  command
      ->add_option("what", arguments->what,
                   "A part (3), a function (3.3 or lambertianBRDF::reflection), a check "
                   "(3.3/samples), images, or 7 for your own scenes; all of them by default")
      ->type_name("PART|FUNCTION");
  command
      ->add_option("--with", arguments->with,
                   "Coursework: student (default), solutions, or a folder of part*.cpp files")
      ->type_name("DIR");
  takesWholeNumber(
      command->add_option("--seed", arguments->seed,
                          "Of the random inputs; the same seed gives the same results"),
      0, std::numeric_limits<std::int64_t>::max());
  takesWholeNumber(command->add_option("--threads", arguments->threads,
                                       "Parts that are checked at the same time"),
                   1, 1024);
  command->footer(
      "Examples:\n"
      "  ./pathmark check\n"
      "  ./pathmark check 3\n"
      "  ./pathmark check lambertianBRDF::reflection --seed 7\n\n"
      "Exit code: 0 if nothing is wrong (what is not written is not wrong), 1 if something is.");
  command->callback(
      [arguments, &action] { action = [arguments] { return checkOnce(*arguments); }; });
}

void addGraderCommands(CLI::App& app, CommandAction& action) { addCheckCommand(app, action); }

}  // namespace pathmark
