// Results in words.
//
//   Of a whole coursework, for a terminal or a file:
//   headline       what is right, and what to do next: the first lines
//   functionLines  part by part, function by function, with what was found where something is wrong
//   imageLines     the same of the pictures
//   listOfChecks   what would be asked
//   sceneLines     the coursework's own scenes
//
//   One by one, for those who show them in another way:
//   standing, whatIsNext, blockedWords, fieldsOf, repeatCommand
#pragma once

#include "checks/results.h"
#include "checks/runner.h"
#include "report/field.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::report {

struct Style {
  bool colour = false;
  std::string with;  // the coursework, as the command line names it, for commands that repeat
};

std::string headline(const checks::CourseworkResults& results, const std::filesystem::path& folder);
std::string functionLines(const checks::CourseworkResults& results, const Style& style);
std::string imageLines(const checks::CourseworkResults& results, const Style& style);
std::string sceneLines(const checks::CourseworkResults& results, const Style& style);

// How many functions are right, wrong, not written.
std::string standing(const checks::CourseworkResults& results, const std::filesystem::path& folder);

// "mend ...", "write ..."; empty if nothing is wrong or missing.
std::string whatIsNext(const checks::CourseworkResults& results,
                       const std::filesystem::path& folder);

// Of a function that is blocked: by what.
std::string blockedWords(const checks::FunctionResult& function);

// What was found by a check that did not pass, in the order in which it is told; what is known.
std::vector<Field> fieldsOf(const checks::CheckResult& result);

// "./pathmark check 3.3/samples --seed 1".
std::string repeatCommand(const checks::CheckResult& result, std::uint64_t seed,
                          const std::string& with);

// The function that is to be mended, or else written, next; null if there is none.
const checks::FunctionResult* nextFunction(const checks::CourseworkResults& results);

// Broken into lines that fit a terminal, the following ones indented.
std::string wrapped(std::string_view words, std::size_t indent);

// Every check of a selection with its statement and the smallest error that it finds.
std::string listOfChecks(const checks::Selection& selection);

}  // namespace pathmark::report
