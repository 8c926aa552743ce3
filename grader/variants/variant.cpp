#include "variants/variant.h"

#include "host/build_config.h"
#include "host/display_path.h"
#include "host/subprocess.h"
#include "worker/contract.h"

#include <fmt/format.h>

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

std::vector<Variant> variantsIn(const fs::path& folder) {
  std::vector<Variant> variants;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".patch") variants.push_back(readVariant(entry.path()));
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

  if (!head.empty())
    refuse(patch, fmt::format("\"{}\" is no line of a head; allowed are Mistake, Different, Part "
                              "and Function.",
                              head.begin()->first));
  return variant;
}

std::vector<Variant> allVariants() {
  std::vector<Variant> all = variantsIn(kProjectFolder / "grader/variants/wrong");
  for (Variant& variant : variantsIn(kProjectFolder / "grader/variants/correct"))
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
