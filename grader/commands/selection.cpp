#include "commands/selection.h"

#include "checks/all_checks.h"
#include "host/session.h"
#include "scene/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

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

// Of "Sphere::sample" "Sphere"; nothing of a function by itself.
std::string_view classOf(std::string_view function) {
  const std::size_t end = function.find("::");
  return end == std::string_view::npos ? std::string_view() : function.substr(0, end);
}

std::string_view lastOf(std::string_view function) {
  const std::string_view owner = classOf(function);
  return owner.empty() ? function : function.substr(owner.size() + 2);
}

bool isNear(std::string_view word, std::string_view name) {
  return !nearestName(word, std::array{name}).empty();
}

// "phong" for phongBRDF, "lambertianBDRF" for lambertianBRDF.
bool meansClass(std::string_view word, std::string_view owner) {
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  constexpr std::size_t kLeastLetters = 3;
  const bool begins = word.size() >= kLeastLetters && word.size() <= owner.size() &&
                      std::equal(word.begin(), word.end(), owner.begin(), same);
  return begins || isNear(word, owner);
}

// Functions that a word may mean: those of a name like it, with its class if it has one; or else
// all of that class; or else those of that name in any class.
std::vector<std::string_view> functionsLike(std::string_view word) {
  const std::string_view owner = classOf(word);
  std::vector<std::string_view> near, ofClass, ofName;
  for (const FunctionContract& f : contract()) {
    const bool sameClass =
        !classOf(f.name).empty() && meansClass(owner.empty() ? word : owner, classOf(f.name));
    const bool sameName = isNear(lastOf(word), lastOf(f.name));
    if (sameClass) ofClass.push_back(f.name);
    if (sameName) ofName.push_back(f.name);
    if (sameName && (sameClass || owner.empty())) near.push_back(f.name);
  }
  if (!near.empty()) return near;
  return ofClass.empty() ? ofName : ofClass;
}

std::string didYouMeanOneOf(const std::vector<std::string_view>& functions) {
  if (functions.size() == 1) return fmt::format(" Did you mean \"{}\"?", functions.front());
  return fmt::format(" Did you mean one of {}?", fmt::join(functions, ", "));
}

[[noreturn]] void askWhich(const std::string& what, const std::vector<std::string_view>& names) {
  throw UsageError(fmt::format("{} can mean any of {}: say which.", what, fmt::join(names, ", ")));
}

// Where there are several that it may mean, all of them are named: one alone would be a guess.
[[noreturn]] void refuse(const std::string& what) {
  std::vector<std::string> names{kImages};
  for (const PartContract& part : parts()) names.push_back(fmt::format("part{}", part.part));
  for (const FunctionContract& f : contract()) names.emplace_back(f.name);
  for (const std::string& id : allIds()) names.push_back(id);
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::vector<std::string_view> functions = functionsLike(what);
  throw UsageError(fmt::format(
      "There is nothing to check that is called {}: it is a part (0 to 9), a function (such as 3.3 "
      "or lambertianBRDF::reflection), a check (such as 3.3/samples), or images.{}",
      what, functions.empty() ? didYouMean(what, views) : didYouMeanOneOf(functions)));
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
  std::vector<std::string_view> endingNames, ofClass;
  for (const FunctionContract& f : contract()) {
    if (what == f.section || what == f.name) return ofFunction(f);
    if (what == classOf(f.name)) ofClass.push_back(f.name);
    if (!f.name.ends_with("::" + what)) continue;
    ending.push_back(f);
    endingNames.push_back(f.name);
  }
  if (ending.size() == 1) return ofFunction(ending.front());
  if (ending.size() > 1) askWhich(what, endingNames);
  if (!ofClass.empty()) askWhich(what, ofClass);
  for (const PartContract& part : parts())
    for (const checks::Check& check : checks::checksOfPart(part.part))
      if (idOf(check) == what) return {{part.part}, false, false, what};
  for (const checks::Check& check : checks::imageChecks())
    if (idOf(check) == what) return {{1, 2, 3, 4, 5, 6}, true, false, what};
  refuse(what);
}

}  // namespace pathmark
