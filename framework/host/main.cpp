// pathmark: the command line of the host.
#include "film/image.h"
#include "host/commands.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/session.h"
#include "scene/load_scene.h"
#include "scene/spelling.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

namespace pathmark {

namespace {

// What the front-door script does before it hands over; listed here for --help.
void addScriptCommand(CLI::App& app, const char* name, const char* what, const char* footer) {
  CLI::App* command = app.add_subcommand(name, what);
  command->footer(footer);
  command->callback([name] {
    throw UsageError(
        fmt::format("Run ./pathmark {}: the script does this, not the program.", name));
  });
}

// A word that no option of the command takes.
int complainOfExtras(const CLI::App& app) {
  const CLI::App* command = &app;
  std::string words = app.get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().back();
    words += " " + command->get_name();
  }
  const std::vector<std::string> extras = command->remaining();
  // The library hands them over from the last to the first.
  auto word = std::find_if(extras.rbegin(), extras.rend(),
                           [](const std::string& w) { return w.starts_with("-"); });
  if (word == extras.rend()) word = extras.rbegin();
  if (word == extras.rend()) return kUsageFault;
  std::vector<std::string> names;
  for (const CLI::Option* option : command->get_options()) names.push_back(option->get_name());
  const std::vector<std::string_view> views(names.begin(), names.end());
  fmt::print(stderr, "{} was not expected; {} --help lists what is.{}\n", *word, words,
             didYouMean(*word, views));
  return kUsageFault;
}

int complain(const char* sentence, int code) {
  fmt::print(stderr, "{}\n", sentence);
  return code;
}

// A name that no file can have is the command line's fault.
int complainOfFile(const std::filesystem::filesystem_error& e) {
  const bool impossibleName = e.code() == std::errc::filename_too_long ||
                              e.code() == std::errc::too_many_symbolic_link_levels;
  const std::string sentence = fmt::format("{}: {}.", e.path1().string(), e.code().message());
  return complain(sentence.c_str(), impossibleName ? kUsageFault : kMachineFault);
}

int run(int argc, char** argv) {
  CLI::App app{"Pathmark: a Monte Carlo path tracing coursework that marks itself"};
  app.name("./pathmark");
  app.require_subcommand(1);
  app.get_formatter()->column_width(30);
  CommandAction action;
  addDemoCommand(app, action);
  addScriptCommand(app, "test", "Build everything and run all tests",
                   "Examples:\n"
                   "  ./pathmark test\n"
                   "  ./pathmark test --preset asan            (with the sanitizers)\n"
                   "  ./pathmark test -R Sphere                (further words go to ctest)");
  addStatusCommand(app, action);
  addGraderCommands(app, action);
  addRenderCommand(app, action);
#ifdef PATHMARK_PREVIEW
  addPreviewCommand(app, action);
#endif
  addCompareCommand(app, action);
  addContactSheetCommand(app, action);
  addExportCommand(app, action);
  addMeshCommand(app, action);
  addReferenceCommand(app, action);
  addBenchCommand(app, action);
  addBuildCommand(app, action);
  addScriptCommand(app, "clean", "Remove the build folder",
                   "Examples:\n"
                   "  ./pathmark clean");
  app.footer(
      "Examples:\n"
      "  ./pathmark demo\n"
      "  ./pathmark status\n"
      "  ./pathmark render cornell_box --rays-per-pixel 256\n\n"
      "./pathmark COMMAND --help says more about a command. Coursework: student/, chapters: "
      "handouts/.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return complainOfExtras(app);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kSuccess : kUsageFault;
  }
  watchForInterrupt();
  // A limit on the size of files (ulimit -f) is then an error of write, which has a sentence.
  std::signal(SIGXFSZ, SIG_IGN);
  return action();
}

}  // namespace

}  // namespace pathmark

int main(int argc, char** argv) {
  using namespace pathmark;
  try {
    return run(argc, argv);
  } catch (const Interrupted&) {
    return complain("Interrupted.", kInterrupted);
  } catch (const CourseworkError& e) {
    return complain(e.what(), kCourseworkFault);
  } catch (const WorkerError& e) {
    return complain(e.what(), kCourseworkFault);
  } catch (const UsageError& e) {
    return complain(e.what(), kUsageFault);
  } catch (const SceneError& e) {
    return complain(e.what(), kUsageFault);
  } catch (const std::filesystem::filesystem_error& e) {
    return complainOfFile(e);
  } catch (const std::system_error& e) {
    return complain(fmt::format("This machine could not do it: {}.", e.what()).c_str(),
                    kMachineFault);
  } catch (const std::bad_alloc&) {
    return complain(
        "This takes more memory than there is, or than is allowed (ulimit -v); a smaller picture "
        "takes less.",
        kMachineFault);
  } catch (const std::exception& e) {
    return complain(e.what(), kMachineFault);
  }
}
