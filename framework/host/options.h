// What several commands' options have in common.
#pragma once

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
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

}  // namespace pathmark
