#include "host/compiler_words.h"

#include <fmt/format.h>

#include <sstream>

namespace pathmark {

namespace {

constexpr const char* kFloatHint =
    "  Colours and vectors are of float: a number such as 3.14 is a double, and 3.14f is none.\n";
constexpr const char* kHeaderHint =
    "  A header of your own is not handed in: helpers stand in an unnamed namespace of each file "
    "that uses them.\n";

bool has(const std::string& line, const char* words) {
  return line.find(words) != std::string::npos;
}

bool beginsDiagnostic(const std::string& line) {
  return has(line, ": error: ") || has(line, ": fatal error: ") || has(line, ": warning: ") ||
         has(line, ": In ") || has(line, ": At global scope:");
}

bool isCandidateOfLibrary(const std::string& line) {
  return line.starts_with("/usr/") && has(line, ": note: candidate: ");
}

bool tellsWhereIncluded(const std::string& line) {
  return line.starts_with("In file included from ") || line.starts_with("                 from ");
}

bool mixesDoubleWithVector(const std::string& line) {
  return has(line, ": error: no match for ") && has(line, "glm::vec<") && has(line, "double");
}

// Not one of a library, which has a folder.
bool lacksOwnHeader(const std::string& line) {
  constexpr std::string_view kError = ": fatal error: ", kEnd = ": No such file or directory";
  const std::size_t at = line.find(kError);
  return at != std::string::npos && line.ends_with(kEnd) &&
         line.find('/', at + kError.size()) == std::string::npos;
}

// What would help with the diagnostic that begins in this line.
std::string_view hintFor(const std::string& line) {
  if (mixesDoubleWithVector(line)) return kFloatHint;
  return lacksOwnHeader(line) ? kHeaderHint : std::string_view{};
}

class Shortening {
 public:
  void add(const std::string& line) {
    if (isCandidateOfLibrary(line)) {
      hiding_ = true;
      ++hidden_;
    } else if (beginsDiagnostic(line)) {
      endOfDiagnostic();
      hint_ = hintFor(line);
    }
    // Belongs to what comes next.
    if (tellsWhereIncluded(line)) {
      included_ += line + '\n';
      return;
    }
    if (!hiding_) text_ += included_ + line + '\n';
    included_.clear();
  }

  std::string text() {
    endOfDiagnostic();
    return text_ + included_;
  }

 private:
  void endOfDiagnostic() {
    if (hidden_ > 0)
      text_ += fmt::format("  ({} function{} of libraries that {} not fit either)\n", hidden_,
                           hidden_ == 1 ? "" : "s", hidden_ == 1 ? "does" : "do");
    text_ += hint_;
    hiding_ = false;
    hidden_ = 0;
    hint_ = {};
  }

  std::string text_, included_;
  std::string_view hint_;
  bool hiding_ = false;
  int hidden_ = 0;
};

}  // namespace

std::string shortCompilerWords(const std::string& output) {
  Shortening shortening;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) shortening.add(line);
  return shortening.text();
}

}  // namespace pathmark
