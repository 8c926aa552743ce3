// pathmark check: is the coursework right, and if not, where to look.
#include "commands/check_session.h"
#include "commands/commands.h"
#include "commands/hints.h"
#include "commands/selection.h"
#include "host/coursework_stamp.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/progress_bar.h"
#include "host/session.h"
#include "report/results_json.h"
#include "report/terminal.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include <unistd.h>

namespace pathmark {

namespace {

struct CheckArguments {
  std::string what;
  std::string with = "student";
  std::uint64_t seed = 1;
  unsigned threads = 0;
  bool watch = false;
  bool list = false;
  int hints = 0;
  std::string json;
};

bool showsColour() { return isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr; }

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

// For the function that is to be mended or written next.
void printHints(const checks::CourseworkResults& results, int count) {
  const checks::FunctionResult* next = report::nextFunction(results);
  if (next == nullptr)
    return print(results.anythingWrong()
                     ? "\nHints are for functions: none of those is wrong or missing here.\n"
                     : "\nNo hint is needed: nothing is wrong or missing here.\n");
  print(fmt::format("\nHints for {} {}:\n", next->function.section, next->function.name));
  const std::vector<std::string> hints = hintsFor(next->function);
  const auto shown = std::min(static_cast<std::size_t>(count), hints.size());
  for (std::size_t k = 0; k < shown; ++k)
    print(fmt::format("  {}  {}\n", k + 1, report::wrapped(hints[k], 5)));
  if (shown < hints.size()) print(fmt::format("  (--hint {} says more.)\n", shown + 1));
}

// What the parts' threads show while they are checked.
class Screen {
 public:
  void showProgress(double fraction, const std::string& id) {
    const std::lock_guard lock(mutex_);
    bar_.show(fraction, id);
  }
  void printAbove(std::string_view text) {
    const std::lock_guard lock(mutex_);
    bar_.printAbove(text);
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    bar_.clear();
  }

 private:
  std::mutex mutex_;
  ProgressBar bar_{"check"};
};

bool isWrong(const checks::PartResult& part) {
  return std::any_of(part.functions.begin(), part.functions.end(), [](const auto& function) {
    return function.status == checks::Status::kFail || function.status == checks::Status::kBroken;
  });
}

// The compiler has often seen what the checks have found.
std::string warningsOfWhatIsWrong(const checks::CourseworkResults& results,
                                  const CourseworkBuild& build) {
  std::string text;
  for (const checks::PartResult& part : results.parts)
    if (isWrong(part)) text += build.parts.at(placeOfPart(part.part.part)).warnings();
  return text.empty() ? text : "\nThe compiler warns:" + text;
}

bool hasWrongPicture(const checks::CourseworkResults& results) {
  return std::any_of(results.images.begin(), results.images.end(), [](const auto& picture) {
    return picture.finding.status == checks::Status::kFail ||
           picture.finding.status == checks::Status::kBroken;
  });
}

// Of a whole check whose functions leave nothing to do: that is not all yet.
std::string announcementOfPictures(const checks::CourseworkResults& results,
                                   const CheckArguments& arguments,
                                   const std::filesystem::path& folder) {
  if (!arguments.what.empty() || !report::whatIsNext(results, folder).empty()) return {};
  return "The pictures come last: they show whether the parts fit together.\n";
}

int checkOnce(CheckSession& session, Screen& screen, const CheckArguments& arguments,
              const std::filesystem::path& folder, const std::function<bool()>& goOn) {
  const report::Style style{showsColour(), arguments.with};
  checks::RunEvents events;
  // Those of functions take seconds, and are shown whatever happens.
  bool functionsShown = false;
  events.goOn = [&] { return !functionsShown || goOn(); };
  events.onProgress = [&](double fraction, const std::string& id) {
    screen.showProgress(fraction, id);
  };
  const CourseworkBuild build = buildCoursework(folder, Incomplete::kCompileOnly);
  events.onFunctions = [&](const checks::CourseworkResults& results) {
    screen.clear();
    print(report::headline(results, folder) + announcementOfPictures(results, arguments, folder) +
          report::functionLines(results, style) + warningsOfWhatIsWrong(results, build));
    functionsShown = true;
  };
  const checks::CourseworkResults& results = session.run(build, events);
  screen.clear();
  print(report::imageLines(results, style) + report::sceneLines(results, style));
  // The headline above was made before there were pictures.
  if (hasWrongPicture(results)) print("\n" + report::headline(results, folder));
  if (arguments.hints > 0) printHints(results, arguments.hints);
  if (!arguments.json.empty()) report::writeJson(results, arguments.json);
  if (interrupted() && !arguments.watch) {
    fmt::print(stderr, "Interrupted: not all was checked.\n");
    return kInterrupted;
  }
  return results.anythingWrong() ? kCourseworkFault : kSuccess;
}

// Until Ctrl-C. A save ends what is left of the pictures: they are of another program now.
int watch(CheckSession& session, Screen& screen, const CheckArguments& arguments,
          const std::filesystem::path& folder) {
  std::string checked;
  while (!interrupted()) {
    const std::string now = stampOf(folder);
    if (now == checked) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      continue;
    }
    if (isatty(STDOUT_FILENO) == 1) print("\033[2J\033[3J\033[H");
    checkOnce(session, screen, arguments, folder,
              [&] { return !interrupted() && stampOf(folder) == now; });
    if (stampOf(folder) == now) print("\nWatching for changes; Ctrl-C ends.\n");
    checked = now;
  }
  return kSuccess;
}

int check(const CheckArguments& arguments) {
  if (arguments.list) {
    print(report::listOfChecks(selectChecks(arguments.what)));
    return kSuccess;
  }
  const std::filesystem::path folder = findCoursework(arguments.with);
  checks::RunOptions options;
  options.seed = arguments.seed;
  options.threads = arguments.threads;
  Screen screen;
  options.onText = [&](std::string_view text) { screen.printAbove(text); };
  CheckSession session(selectChecks(arguments.what), options);
  if (arguments.watch) return watch(session, screen, arguments, folder);
  return checkOnce(session, screen, arguments, folder, [] { return !interrupted(); });
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
  command->add_option("--with", arguments->with, "Coursework: " + courseworkChoices("student"))
      ->type_name("DIR");
  takesWholeNumber(
      command->add_option("--seed", arguments->seed,
                          "Of the random inputs; the same seed gives the same results"),
      0, std::numeric_limits<std::int64_t>::max());
  takesWholeNumber(command->add_option("--threads", arguments->threads,
                                       "Parts that are checked at the same time"),
                   1, 1024);
  command->add_flag("--watch", arguments->watch,
                    "Check again whenever a file is saved, until Ctrl-C");
  takesWholeNumber(
      command
          ->add_option("--hint", arguments->hints,
                       "Up to three hints for what comes next, each saying more than the last")
          ->expected(0, 1)
          ->default_str("1"),
      1, kMostHints);
  command->add_flag("--list", arguments->list,
                    "Only list the checks: what is asked, and the smallest error that is found");
  command->add_option("--json", arguments->json, "Also write all results to this file")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark check\n"
      "  ./pathmark check 3\n"
      "  ./pathmark check lambertianBRDF::reflection --seed 7\n"
      "  ./pathmark check --watch\n"
      "  ./pathmark check 2.4 --hint 2\n"
      "  ./pathmark check --list\n\n"
      "Exit code: 0 if nothing is wrong (what is not written is not wrong), 1 if something is; 2 "
      "for a wrong command line; 3 if the machine failed, such as where no compiler can be run; "
      "130 "
      "if interrupted, except by the Ctrl-C that ends --watch.");
  command->callback([arguments, &action] { action = [arguments] { return check(*arguments); }; });
}

}  // namespace pathmark
