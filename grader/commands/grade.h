// What `grade` does, for other commands too.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pathmark {

struct GradeArguments {
  std::vector<std::string> what;
  std::string out;
  std::optional<std::uint64_t> seed;
  unsigned jobs = 0;
  std::string rubric;
  std::string only;
  std::string sandbox;
  double secondsAtMost = 600.0;
  bool unsafe = false;
  std::string goOnWith = "the same command";  // what a person types after an interrupt
};

// Returns an exit code; see the command's help for what it says.
int grade(const GradeArguments& arguments);

}  // namespace pathmark
