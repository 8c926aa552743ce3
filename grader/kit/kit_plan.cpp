#include "kit/kit_plan.h"

#include "kit/project_files.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace pathmark::kit {

namespace fs = std::filesystem;

namespace {

constexpr const char* kManifest = "grader/kit/contents.txt";

// The files of one part, as they are called in student/ and in solutions/.
std::vector<std::string> filesOfPart(int part, const std::vector<std::string>& all) {
  std::vector<std::string> names;
  for (const PartContract& p : parts())
    if (p.part == part) names.emplace_back(p.file);
  if (part == kScenesPart)
    for (const std::string& file : all)
      if (matches("solutions/scenes/*.json", file)) names.push_back(file.substr(10));
  return names;
}

void refuseWhatCannotBeTaken(const fs::path& project, const std::string& file) {
  const fs::file_status status = fs::symlink_status(project / file);
  if (!fs::exists(status))
    throw std::runtime_error(
        fmt::format("{} is missing: git knows it, and a kit would take it.", file));
  if (!fs::is_regular_file(status))
    throw std::runtime_error(
        fmt::format("{} is not a regular file; a kit holds nothing else.", file));
}

void takeFiles(KitPlan& plan, const Manifest& manifest, const std::vector<std::string>& all,
               std::map<std::string, KitFile>& taken) {
  std::set<int> used;
  for (const std::string& file : all) {
    const ManifestLine* line = lineFor(manifest.taken, file);
    if (line == nullptr) continue;
    used.insert(line->number);
    refuseWhatCannotBeTaken(plan.project, file);
    const std::string name = line->name.empty() ? file : line->name;
    taken[name] = {.from = file, .name = name, .kind = line->kind};
  }
  for (const ManifestLine& line : manifest.taken)
    if (!used.contains(line.number))
      throw std::runtime_error(fmt::format("{}:{}: no file of the project matches {}.", kManifest,
                                           line.number, line.pattern));
}

void releaseParts(KitPlan& plan, const std::vector<std::string>& all,
                  std::map<std::string, KitFile>& taken) {
  for (int part = 0; part <= plan.releasedThrough; ++part)
    for (const std::string& file : filesOfPart(part, all)) {
      const std::string from = "solutions/" + file, name = "student/" + file;
      refuseWhatCannotBeTaken(plan.project, from);
      taken[name] = {.from = from, .name = name, .kind = FileKind::kText};
    }
}

}  // namespace

KitPlan planKit(const fs::path& project, int releasedThrough) {
  KitPlan plan{.project = project,
               .releasedThrough = releasedThrough,
               .files = {},
               .answers = {},
               .hidden = {}};
  const Manifest manifest = readManifest(readFile(project / kManifest));
  const std::vector<std::string> all = projectFiles(project);
  std::map<std::string, KitFile> taken;
  takeFiles(plan, manifest, all, taken);
  releaseParts(plan, all, taken);

  std::set<std::string> open;  // what is in the kit, or stands there under the same name
  for (const auto& [name, file] : taken) {
    plan.files.push_back(file);
    open.insert({name, file.from});
  }
  for (const std::string& file : all) {
    if (open.contains(file)) continue;
    const bool isAnswer = lineFor(manifest.answers, file) != nullptr;
    (isAnswer ? plan.answers : plan.hidden).push_back(file);
  }
  // What is in several of them is said to be of the first.
  const auto line = [&](const std::string& file) {
    return lineFor(manifest.answers, file)->number;
  };
  std::stable_sort(plan.answers.begin(), plan.answers.end(),
                   [&](const std::string& a, const std::string& b) { return line(a) < line(b); });
  return plan;
}

}  // namespace pathmark::kit
