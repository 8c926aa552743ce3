// pathmark demo: a class that is graded, from submissions to a report.
#include "commands/grade.h"
#include "host/build_config.h"
#include "host/commands.h"
#include "host/display_path.h"
#include "sample_class/sample_class.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

int demo() {
  const fs::path folder = fs::path(build::kBuildFolder) / "demo";
  // What an earlier demo has graded must not be taken for this one's work.
  fs::remove_all(folder);
  makeSampleClass(folder / "submissions");
  const std::string command =
      fmt::format("./pathmark grade {} --out {} --seed 1", displayPath(folder / "submissions"),
                  displayPath(folder / "grades"));
  fmt::print("A class of made-up submissions is in {}. Grading it, as\n  {}\n\n",
             displayPath(folder / "submissions"), command);
  std::fflush(stdout);
  GradeArguments arguments;
  arguments.goOnWith = command;  // the demo itself begins anew
  arguments.what = {(folder / "submissions").string()};
  arguments.out = (folder / "grades").string();
  arguments.seed = 1;
  return grade(arguments);
}

}  // namespace

void addDemoCommand(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand(
      "demo", "Install what is missing, build, and grade a small class of made-up submissions");
  command->footer(
      "Examples:\n"
      "  ./pathmark demo\n"
      "  ./pathmark demo --yes                    (install missing packages without asking)");
  command->callback([&action] { action = [] { return demo(); }; });
}

}  // namespace pathmark
