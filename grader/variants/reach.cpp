#include "variants/reach.h"

#include "variants/definitions.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace pathmark {

namespace {

std::vector<CourseworkFunction> allOf(int part) {
  std::vector<CourseworkFunction> functions;
  for (const FunctionContract& f : contract())
    if (f.part == part) functions.push_back(f.function);
  return functions;
}

std::set<std::string> textsOf(const std::vector<Definition>& definitions) {
  std::set<std::string> texts;
  for (const Definition& d : definitions) texts.insert(d.text);
  return texts;
}

std::string lastWord(const std::string& name) {
  const std::size_t colons = name.rfind("::");
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

// The names of definitions that the other file does not have. Returns false if one has none.
bool addDifferent(const std::vector<Definition>& here, const std::vector<Definition>& there,
                  std::set<std::string>& names) {
  const std::set<std::string> known = textsOf(there);
  for (const Definition& d : here) {
    if (known.contains(d.text)) continue;
    if (d.name.empty()) return false;
    names.insert(d.name);
  }
  return true;
}

void addThoseThatMention(const std::vector<Definition>& definitions, std::set<std::string>& names) {
  for (bool more = true; more;) {
    more = false;
    for (const Definition& d : definitions) {
      if (d.name.empty() || names.contains(d.name)) continue;
      if (std::none_of(names.begin(), names.end(),
                       [&](const std::string& name) { return mentions(d, lastWord(name)); }))
        continue;
      names.insert(d.name);
      more = true;
    }
  }
}

std::string partIn(const std::filesystem::path& folder, int part) {
  std::ifstream in(folder / partNumbered(part).file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::vector<CourseworkFunction> functionsThatMayDiffer(int part, std::string_view before,
                                                       std::string_view after) {
  const auto old = definitionsOf(before), now = definitionsOf(after);
  std::set<std::string> names;
  if (!old || !now || !addDifferent(*old, *now, names) || !addDifferent(*now, *old, names))
    return allOf(part);
  addThoseThatMention(*now, names);
  std::vector<CourseworkFunction> functions;
  if (names.empty()) return functions;
  for (const CourseworkFunction f : allOf(part))
    if (contractOf(f).needsScene || names.contains(std::string(contractOf(f).name)))
      functions.push_back(f);
  return functions;
}

std::vector<CourseworkFunction> functionsThatMayDifferIn(int part,
                                                         const std::filesystem::path& before,
                                                         const std::filesystem::path& after) {
  return functionsThatMayDiffer(part, partIn(before, part), partIn(after, part));
}

}  // namespace pathmark
