#include "commands/selection.h"

#include "checks/all_checks.h"
#include "host/session.h"
#include "scene/spelling.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark {

namespace {

constexpr const char* kImages = "images";

std::vector<std::string> allIds() {
  std::vector<std::string> ids;
  for (const PartContract& part : parts())
    for (const checks::Check& check : checks::checksOfPart(part.part)) ids.push_back(idOf(check));
  for (const checks::Check& check : checks::imageChecks()) ids.push_back(idOf(check));
  return ids;
}

checks::Selection ofFunction(const FunctionContract& f) {
  return {{f.part}, false, false, std::string(f.section)};
}

[[noreturn]] void refuse(const std::string& what) {
  std::vector<std::string> names{kImages};
  for (const PartContract& part : parts()) names.push_back(fmt::format("part{}", part.part));
  for (const FunctionContract& f : contract()) names.emplace_back(f.name);
  for (const std::string& id : allIds()) names.push_back(id);
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw UsageError(fmt::format(
      "There is nothing to check that is called {}: it is a part (0 to 9), a function (such as 3.3 "
      "or lambertianBRDF::reflection), a check (such as 3.3/samples), or images.{}",
      what, didYouMean(what, views)));
}

}  // namespace

checks::Selection selectChecks(const std::string& what) {
  if (what.empty()) return {};
  if (what == kImages) return {{0, 1, 2, 3, 4, 5, 6}, true, false, {}};
  if (what == "7" || what == "part7") return {{}, false, true, {}};
  for (const PartContract& part : parts())
    if (what == std::to_string(part.part) || what == fmt::format("part{}", part.part) ||
        what == part.file)
      return {{part.part}, false, false, {}};
  std::vector<FunctionContract> ending;
  for (const FunctionContract& f : contract()) {
    if (what == f.section || what == f.name) return ofFunction(f);
    if (f.name.ends_with("::" + what)) ending.push_back(f);
  }
  if (ending.size() == 1) return ofFunction(ending.front());
  if (ending.size() > 1) {
    std::vector<std::string_view> names;
    for (const FunctionContract& f : ending) names.push_back(f.name);
    throw UsageError(fmt::format("{} may be each of {}: say which.", what, fmt::join(names, ", ")));
  }
  for (const PartContract& part : parts())
    for (const checks::Check& check : checks::checksOfPart(part.part))
      if (idOf(check) == what) return {{part.part}, false, false, what};
  for (const checks::Check& check : checks::imageChecks())
    if (idOf(check) == what) return {{1, 2, 3, 4, 5, 6}, true, false, what};
  refuse(what);
}

}  // namespace pathmark
