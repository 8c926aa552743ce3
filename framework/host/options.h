// What several commands' options have in common.
#pragma once

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

namespace pathmark {

// Accepts a whole number of this range, and says so of anything else. Shown as N in --help.
inline void takesWholeNumber(CLI::Option* option, std::int64_t low, std::int64_t high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    if (whole && value >= low && value <= high) return {};
    return "found " + text + ", allowed is a whole number from " + std::to_string(low) + " to " +
           std::to_string(high);
  };
  option->check(CLI::Validator(check, ""))->type_name("N");
}

// Accepts a number of this range, and says so of anything else; `what` is "a number", or one of
// something.
inline void takesNumber(CLI::Option* option, double low, double high, const char* typeName,
                        const char* what = "a number") {
  const auto check = [low, high, what](const std::string& text) -> std::string {
    // People write +1 for exposures; from_chars does not read it.
    const bool plus = text.starts_with('+') && !text.starts_with("+-");
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text.data() + (plus ? 1 : 0), text.data() + text.size(), value);
    const bool number = error == std::errc{} && end == text.data() + text.size();
    if (number && value >= low && value <= high) return {};
    return fmt::format("found {}, allowed is {} from {} to {}", text, what, low, high);
  };
  option->check(CLI::Validator(check, ""))->type_name(typeName);
}

// Accepts a number of seconds of this range. Shown as SECONDS in --help.
inline void takesSeconds(CLI::Option* option, double low, double high) {
  takesNumber(option, low, high, "SECONDS", "a number of seconds");
}

// Accepts any text but an empty one, as a shell makes it of a variable that is not set: it would be
// taken for an option that is not there.
inline void takesText(CLI::Option* option, const char* typeName, const std::string& allowed) {
  const auto check = [allowed](const std::string& text) -> std::string {
    return text.empty() ? "found nothing, allowed is " + allowed : "";
  };
  option->check(CLI::Validator(check, ""))->type_name(typeName);
}

// --sampler NAME, for findSampler.
inline void addSamplerOption(CLI::App& command, std::string& name) {
  command
      .add_option("--sampler", name,
                  "Kind of random numbers: sobol (default), stratified or pcg; handouts/README.md "
                  "tells the "
                  "difference")
      ->type_name("NAME");
}

// --paths EXPRESSION, for findPaths. `more` ends its description.
inline void addPathsOption(CLI::App& command, std::optional<std::string>& expression,
                           const std::string& more = {}) {
  command
      .add_option(
          "--paths", expression,
          "Only light that came along paths of this light path expression, such as "
          "'L(S|D)*E' for all: L the light, S and D specular and diffuse reflections, . "
          "either, E the eye; * + ? | and ( ) as usual. handouts/light_paths.md tells more" +
              more)
      ->type_name("EXPR");
}

}  // namespace pathmark
