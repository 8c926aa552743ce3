// pathmark status: which functions are written, part by part, and what comes next.
#include "host/build_config.h"
#include "host/commands.h"
#include "host/coursework_builder.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/session.h"
#include "host/where_to_look.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

StubReport askWorker(const CourseworkBuild& build) {
  WorkerProcess::Options options;
  options.program = build.worker;
  options.courseworkFolder = build.folder;
  return makeStubReport(WorkerProcess(std::move(options)).stubs());
}

// What is broken comes before what is not there yet.
std::optional<std::string> whatToMend(const CourseworkBuild& build) {
  for (const PartBuild& part : build.parts) {
    if (part.missing) return "put the file back: " + part.failure();
    if (!part.compiled)
      return fmt::format("mend {}, which does not compile:{}", displayPath(part.source),
                         part.messages);
  }
  if (!build.linkMessages.empty()) return "mend this: " + build.failure();
  return std::nullopt;
}

// Prints the line of one part; returns what to write next in it, if anything.
std::optional<std::string> showPart(const PartBuild& part, const StubReport& report) {
  std::vector<FunctionContract> all, missing;
  for (const FunctionContract& f : contract()) {
    if (f.part != part.part.part) continue;
    all.push_back(f);
    if (report.isUnwritten(f.function)) missing.push_back(f);
  }
  const std::string title = fmt::format("Part {}  {:<44}", part.part.part, part.part.title);
  if (part.part.bonus && missing.size() == all.size()) {
    fmt::print("{} bonus, not written yet\n", title);
    return std::nullopt;
  }
  if (!part.compiled) {
    fmt::print("{} {}\n", title, part.problem());
    return std::nullopt;
  }
  fmt::print("{} {}{} of {} written\n", title, part.part.bonus ? "bonus, " : "",
             all.size() - missing.size(), all.size());
  for (const FunctionContract& f : missing) fmt::print("          {}  {}\n", f.section, f.name);
  if (missing.empty()) return std::nullopt;
  return fmt::format(
      "write {} in {}; the task stands above it, the chapter is {}. Its line "
      "PATHMARK_UNIMPLEMENTED(...) is still there: take it away when the function is written.",
      missing.front().name, displayPath(part.source), handoutOf(part.part));
}

// Part 7 is scenes: one counts as written when it has a caption.
std::optional<std::string> showScenes(const fs::path& folder) {
  const fs::path scenes = folder / "scenes";
  std::vector<fs::path> files;
  if (fs::is_directory(scenes))
    for (const auto& entry : fs::directory_iterator(scenes))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int captioned = 0;
  std::string problem;
  for (const fs::path& file : files) {
    try {
      const bool blank = loadScene(file).caption.find_first_not_of(" \t\r\n") == std::string::npos;
      captioned += blank ? 0 : 1;
    } catch (const SceneError& e) {
      problem = e.what();
    }
  }
  fmt::print("Part 7  {:<44} {} of {} scenes have a caption\n", "Your own scenes", captioned,
             files.size());
  if (!problem.empty()) return "mend a scene: " + problem;
  if (captioned > 0) return std::nullopt;
  return fmt::format("write a scene in {}; the chapter is handouts/part7_scenes.md.",
                     displayPath(scenes));
}

int status(const std::string& with) {
  const fs::path folder = findCoursework(with);
  const CourseworkBuild build = buildCoursework(folder, Incomplete::kLeaveThemOut);
  if (build.worker.empty()) throw CourseworkError(build.failure());
  const StubReport report = askWorker(build);
  const std::optional<std::string> broken = whatToMend(build);
  std::optional<std::string> next = broken;
  const auto show = [&](bool bonus) {
    for (const PartBuild& part : build.parts) {
      if (part.part.bonus != bonus) continue;
      const std::optional<std::string> todo = showPart(part, report);
      if (!next) next = todo;
    }
  };
  show(false);
  const std::optional<std::string> scenes = showScenes(folder);
  if (!next) next = scenes;
  show(true);
  fmt::print("\n{}\n", next ? "Next: " + *next : "Everything is written.");
  return broken ? kCourseworkFault : kSuccess;
}

}  // namespace

void addStatusCommand(CLI::App& app, CommandAction& action) {
  const auto with = std::make_shared<std::string>("student");
  CLI::App* command =
      app.add_subcommand("status", "Say which functions are written, and what comes next");
  command->add_option("--with", *with, "Coursework: " + courseworkChoices("student"))
      ->type_name("DIR");
  command->footer(
      "Examples:\n"
      "  ./pathmark status\n"
      "  ./pathmark status --with ../submission\n\n"
      "Exit code: 0 if everything compiles and links, 1 if not.");
  command->callback([with, &action] { action = [with] { return status(*with); }; });
}

}  // namespace pathmark
