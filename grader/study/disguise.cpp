#include "study/disguise.h"

#include <algorithm>
#include <stdexcept>

namespace pathmark::study {

namespace fs = std::filesystem;

namespace {

std::vector<MistakenCase> evenly(const std::vector<MistakenCase>& all, std::size_t most) {
  std::vector<MistakenCase> some;
  const std::size_t count = std::min(most, all.size());
  for (std::size_t k = 0; k < count; ++k) some.push_back(all[k * all.size() / count]);
  return some;
}

}  // namespace

std::string MistakenCase::name() const {
  std::string name;
  for (const Variant& patch : patches) name += (name.empty() ? "" : " + ") + patch.name;
  return name;
}

bool MistakenCase::makes(const std::string& mistake) const {
  for (const Variant& patch : patches)
    if (patch.wrong && patch.name == mistake) return true;
  return false;
}

std::vector<MistakenCase> singleCases(const std::vector<Variant>& variants) {
  std::vector<MistakenCase> cases;
  for (const Variant& variant : variants)
    if (variant.wrong) cases.push_back({{variant}});
  return cases;
}

std::vector<MistakenCase> disguisedCases(const std::vector<Variant>& variants, std::size_t most) {
  std::vector<MistakenCase> cases;
  for (const Variant& wrong : variants)
    for (const Variant& different : variants)
      if (wrong.wrong && !different.wrong && wrong.part == different.part)
        cases.push_back({{different, wrong}});
  return evenly(cases, most);
}

std::vector<MistakenCase> pairedCases(const std::vector<Variant>& variants, std::size_t most) {
  std::vector<MistakenCase> all;
  for (std::size_t a = 0; a < variants.size(); ++a)
    for (std::size_t b = a + 1; b < variants.size(); ++b)
      if (variants[a].wrong && variants[b].wrong && variants[a].part == variants[b].part)
        all.push_back({{variants[a], variants[b]}});
  return evenly(all, most);
}

std::optional<CaseBuild> buildCase(const MistakenCase& c, const CourseworkBuild& others,
                                   const fs::path& scratch) {
  const fs::path folder = scratch / c.name();
  for (const Variant& patch : c.patches) {
    const bool first = &patch == &c.patches.front();
    try {
      if (first)
        applyVariant(patch, folder);
      else
        addVariant(patch, folder);
    } catch (const std::runtime_error&) {
      return std::nullopt;
    }
  }
  CaseBuild made{others, functionsThatMayDifferIn(c.part(), others.folder, folder)};
  const std::size_t part = placeOfPart(c.part());
  made.build.parts[part] = compilePart(folder, c.part());
  fs::remove_all(folder);
  if (!made.build.parts[part].compiled) return std::nullopt;
  return made;
}

}  // namespace pathmark::study
