// Results in words, for a terminal or a file.
//
//   headline       what is right, and what to do next: the first lines
//   functionLines  part by part, function by function, with what was found where something is wrong
//   imageLines     the same of the pictures
//   sceneLines     the coursework's own scenes
#pragma once

#include "checks/results.h"

#include <filesystem>
#include <string>

namespace pathmark::report {

struct Style {
  bool colour = false;
  std::string with;  // the coursework, as the command line names it, for commands that repeat
};

std::string headline(const checks::CourseworkResults& results, const std::filesystem::path& folder,
                     const Style& style);
std::string functionLines(const checks::CourseworkResults& results, const Style& style);
std::string imageLines(const checks::CourseworkResults& results, const Style& style);
std::string sceneLines(const checks::CourseworkResults& results, const Style& style);

// "handouts/part3_lambertian.md".
std::string handoutOf(const PartContract& part);

}  // namespace pathmark::report
