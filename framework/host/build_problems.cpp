#include "host/build_problems.h"

#include "host/build_files.h"
#include "host/coursework_builder.h"
#include "host/display_path.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// The functions of the contract that the linker has not found anywhere. A class's table comes with
// its first function.
std::vector<std::string_view> undefinedFunctions(const std::string& linkMessages) {
  const auto says = [&](const std::string& words) {
    return linkMessages.find("undefined symbol: " + words) != std::string::npos ||
           linkMessages.find("undefined reference to `" + words) != std::string::npos;
  };
  std::vector<std::string_view> names;
  for (const FunctionContract& f : contract()) {
    const std::string name(f.name), owner = name.substr(0, name.find("::"));
    const bool first = f.name.ends_with("BRDF::brdf");
    if (says("pathmark::" + name + "(") || (first && says("vtable for pathmark::" + owner)))
      names.push_back(f.name);
  }
  return names;
}

}  // namespace

std::string_view whatAFolderHolds(const fs::path& folder) {
  std::error_code ignored;
  return fs::equivalent(folder, kProjectFolder / "student", ignored)
             ? ""
             : "; a coursework folder holds the same files as student/";
}

std::string linkFailure(const fs::path& folder, const std::string& messages) {
  const std::vector<std::string_view> undefined = undefinedFunctions(messages);
  if (undefined.empty()) return fmt::format("{} does not link:\n{}", displayPath(folder), messages);
  return fmt::format(
      "{} defines no {} with the parameters that the header declares; is a name or a type "
      "different, or \"const\" missing?\n",
      displayPath(folder), fmt::join(undefined, ", "));
}

std::string_view PartBuild::problem() const { return missing ? "is missing" : "does not compile"; }

std::string PartBuild::failure() const {
  if (missing)
    return fmt::format("{} is missing{}.", displayPath(source),
                       whatAFolderHolds(source.parent_path()));
  return fmt::format("{} does not compile:{}", displayPath(source), messages);
}

std::string_view PartBuild::warnings() const {
  return compiled ? std::string_view(messages) : std::string_view();
}

std::string CourseworkBuild::failure() const {
  std::string text;
  for (const PartBuild& p : parts)
    if (!p.compiled) text += p.failure() + "\n";
  if (!linkMessages.empty()) text += linkFailure(folder, linkMessages);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace pathmark
