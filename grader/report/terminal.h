// Results in words, for a terminal or a file.
//
//   headline       what is right, and what to do next: the first lines
//   functionLines  part by part, function by function, with what was found where something is wrong
//   imageLines     the same of the pictures
//   listOfChecks   what would be asked
//   sceneLines     the coursework's own scenes
#pragma once

#include "checks/results.h"
#include "checks/runner.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace pathmark::report {

struct Style {
  bool colour = false;
  std::string with;  // the coursework, as the command line names it, for commands that repeat
};

std::string headline(const checks::CourseworkResults& results, const std::filesystem::path& folder);
std::string functionLines(const checks::CourseworkResults& results, const Style& style);
std::string imageLines(const checks::CourseworkResults& results, const Style& style);
std::string sceneLines(const checks::CourseworkResults& results, const Style& style);

// The function that is to be mended, or else written, next; null if there is none.
const checks::FunctionResult* nextFunction(const checks::CourseworkResults& results);

// Broken into lines that fit a terminal, the following ones indented.
std::string wrapped(std::string_view words, std::size_t indent);

// Every check of a selection with its statement and the smallest error that it finds.
std::string listOfChecks(const checks::Selection& selection);

// "handouts/part3_lambertian.md".
std::string handoutOf(const PartContract& part);

}  // namespace pathmark::report
