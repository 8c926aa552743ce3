// pathmark build: compiles coursework to a worker.
#include "host/build_config.h"
#include "host/commands.h"
#include "host/exit_code.h"
#include "host/session.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace pathmark {

namespace {

int buildAll(const std::vector<std::string>& folders) {
  int code = kSuccess;
  for (const std::string& with : folders) {
    try {
      const Coursework coursework = prepareCoursework(with);
      fmt::print("{}: compiled\n", coursework.name);
    } catch (const CourseworkError& e) {
      fmt::print(stderr, "{}\n", e.what());
      code = kCourseworkFault;
    }
  }
  return code;
}

}  // namespace

void addBuildCommand(CLI::App& app, CommandAction& action) {
  const auto folders = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      app.add_subcommand("build", "Build the program, and compile coursework with it");
  command
      ->add_option("--with", *folders,
                   solvedCoursework() == "solutions"
                       ? "Coursework to compile: student, solutions, or folders (default: both)"
                       : "Coursework to compile: student (default), or folders")
      ->type_name("DIR");
  command->footer(
      "Examples:\n"
      "  ./pathmark build\n"
      "  ./pathmark build --with student");
  command->callback([folders, &action] {
    action = [folders] {
      if (folders->empty()) {
        folders->push_back("student");
        if (solvedCoursework() != "student") folders->push_back(solvedCoursework());
      }
      return buildAll(*folders);
    };
  });
}

}  // namespace pathmark
