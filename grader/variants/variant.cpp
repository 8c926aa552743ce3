#include "variants/variant.h"

#include "checks/all_checks.h"
#include "host/build_config.h"
#include "host/display_path.h"
#include "host/subprocess.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

const fs::path kProjectFolder{build::kProjectFolder};

// The lines "Key: value" before the first empty line.
using Head = std::map<std::string, std::string>;

[[noreturn]] void refuse(const fs::path& patch, const std::string& sentence) {
  throw std::runtime_error(displayPath(patch) + ": " + sentence);
}

Head readHead(const fs::path& patch) {
  std::ifstream in(patch);
  if (!in) refuse(patch, "the file cannot be read.");
  Head head;
  std::string line;
  while (std::getline(in, line) && !line.empty()) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos)
      refuse(patch, fmt::format("\"{}\" is no line of a head; \"Part: 3\" would be.", line));
    if (!head.emplace(line.substr(0, colon), line.substr(colon + 2)).second)
      refuse(patch, fmt::format("the head says \"{}\" twice.", line.substr(0, colon)));
  }
  if (!in) refuse(patch, "an empty line and a diff must follow the head.");
  return head;
}

// Takes the line out of the head; empty if it is not there.
std::string take(Head& head, const std::string& key) {
  const auto node = head.extract(key);
  return node.empty() ? std::string() : node.mapped();
}

const FunctionContract* findFunction(const std::string& name) {
  const auto all = contract();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const FunctionContract& f) { return f.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> checksOf(const FunctionContract& function) {
  std::vector<std::string> ids;
  for (const checks::Check& check : checks::checksOfPart(function.part))
    if (check.function == function.function) ids.push_back(idOf(check));
  return ids;
}

std::string checkNamed(const std::string& id, const FunctionContract& function,
                       const fs::path& patch) {
  const std::vector<std::string> ids = checksOf(function);
  if (!id.empty() && std::find(ids.begin(), ids.end(), id) == ids.end())
    refuse(patch, fmt::format("{} is no check of {}; those are {}.", id, function.name,
                              fmt::join(ids, ", ")));
  return id;
}

std::string whyLessEfficient(const std::string& line, const fs::path& patch) {
  const std::string begin = "less, because ";
  if (!line.empty() && (!line.starts_with(begin) || line.size() == begin.size()))
    refuse(patch,
           fmt::format("\"Efficiency: {}\" must begin with \"{}\", and say why.", line, begin));
  return line.empty() ? line : line.substr(begin.size());
}

std::vector<Variant> variantsIn(const fs::path& folder, Variant (*read)(const fs::path&)) {
  std::vector<Variant> variants;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".patch") variants.push_back(read(entry.path()));
  std::sort(variants.begin(), variants.end(),
            [](const Variant& a, const Variant& b) { return a.name < b.name; });
  return variants;
}

// Without fuzz: a change that is put where the lines around it have changed may no longer be the
// mistake that the head tells of.
void applyPatch(const fs::path& patch, const fs::path& folder) {
  const ProcessResult applied =
      runProcess({{"patch", "--strip=1", "--fuzz=0", "--batch", "--forward", "--reject-file=-",
                   "--no-backup-if-mismatch", "--directory=" + folder.string(),
                   "--input=" + fs::absolute(patch).string()},
                  {},
                  {}});
  if (applied.exitCode != 0)
    refuse(patch, "the patch does not apply to solutions/:\n" + applied.output);
}

}  // namespace

Variant readVariant(const fs::path& patch) {
  Head head = readHead(patch);
  Variant variant;
  variant.name = patch.stem().string();
  variant.patch = patch;
  const std::string mistake = take(head, "Mistake"), different = take(head, "Different");
  if (mistake.empty() == different.empty())
    refuse(patch,
           "the head must say either what the mistake is (\"Mistake: ...\") or what is "
           "different (\"Different: ...\").");
  variant.wrong = different.empty();
  variant.what = variant.wrong ? mistake : different;

  const std::string part = take(head, "Part");
  const auto named = std::find_if(parts().begin(), parts().end(), [&](const PartContract& p) {
    return part == std::to_string(p.part);
  });
  if (named == parts().end())
    refuse(patch,
           fmt::format("the head must say \"Part: \" and a number from 0 to 6, 8 or 9, not \"{}\".",
                       part));
  variant.part = named->part;

  variant.function = take(head, "Function");
  if (variant.wrong == variant.function.empty())
    refuse(patch,
           "a mistake names the function whose check must find it, and only a mistake does.");
  const FunctionContract* function = findFunction(variant.function);
  if (variant.wrong && (function == nullptr || function->part != variant.part))
    refuse(patch, fmt::format("{} is no function of part {}.", variant.function, variant.part));

  const std::string check = take(head, "Check");
  if (!variant.wrong && !check.empty())
    refuse(patch, "what is different and correct has no check that must find it.");
  if (variant.wrong) variant.check = checkNamed(check, *function, patch);

  variant.lessEfficient = whyLessEfficient(take(head, "Efficiency"), patch);
  if (variant.wrong && !variant.lessEfficient.empty())
    refuse(patch, "a mistake has no efficiency to speak of.");

  if (!head.empty())
    refuse(patch, fmt::format("\"{}\" is no line of a head; allowed are Mistake, Different, Part, "
                              "Function, Check and Efficiency.",
                              head.begin()->first));
  return variant;
}

Variant readMistake(const fs::path& patch) {
  const Variant variant = readVariant(patch);
  if (variant.check.empty())
    refuse(patch,
           "the head must name the check that must find the mistake (\"Check: 3.1/value\").");
  return variant;
}

std::vector<Variant> allVariants() {
  const fs::path folder = kProjectFolder / "grader/variants";
  std::vector<Variant> all = variantsIn(folder / "wrong", readMistake);
  for (Variant& variant : variantsIn(folder / "correct", readVariant))
    all.push_back(std::move(variant));
  return all;
}

void applyVariant(const Variant& variant, const fs::path& folder) {
  applyVariants({&variant, 1}, folder);
}

void applyVariants(std::span<const Variant> variants, const fs::path& folder) {
  fs::create_directories(folder);
  for (const PartContract& part : parts())
    fs::copy_file(kProjectFolder / "solutions" / part.file, folder / part.file,
                  fs::copy_options::overwrite_existing);
  for (const Variant& variant : variants) addVariant(variant, folder);
}

void addVariant(const Variant& variant, const fs::path& folder) {
  applyPatch(variant.patch, folder);
}

}  // namespace pathmark
