#include "kit/inspect_kit.h"

#include "host/build_config.h"
#include "host/content_hash.h"
#include "kit/file_kind.h"
#include "kit/passages.h"
#include "kit/project_files.h"
#include "kit/quoted_lines.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>

namespace pathmark::kit {

namespace fs = std::filesystem;

namespace {

// Shorter files may be equal by chance: an empty one, or a list with one word.
constexpr std::size_t kLeastBytesOfACopy = 64;

class HiddenFiles {
 public:
  explicit HiddenFiles(const KitPlan& plan) {
    for (const KitFile& file : plan.files)
      if (file.from.starts_with("solutions/")) allow(readFile(plan.project / file.from));
    for (const std::string& file : plan.answers) hide(plan.project, file, true);
    for (const std::string& file : plan.hidden) hide(plan.project, file, false);
  }

  void search(const std::string& name, std::string_view content,
              std::vector<std::string>& findings) const {
    if (const auto copy = copies_.find(contentHash(content)); copy != copies_.end())
      findings.push_back(fmt::format("{} is a copy of {}, which is hidden.", name, copy->second));
    std::vector<Quotation> quotations = answers_.find(content);
    if (quotations.empty()) quotations = answerLines_.find(content);
    if (quotations.empty()) quotations = others_.find(content);
    for (const Quotation& q : quotations)
      findings.push_back(fmt::format("{}:{} quotes {}:{}, which is hidden.", name, q.line,
                                     q.hiddenFile, q.hiddenLine));
  }

 private:
  void allow(std::string_view text) {
    answers_.allow(text);
    answerLines_.allow(text);
    others_.allow(text);
  }

  void hide(const fs::path& project, const std::string& file, bool isAnswer) {
    if (!fs::is_regular_file(project / file)) return;
    const std::string content = readFile(project / file);
    if (content.size() >= kLeastBytesOfACopy) copies_.try_emplace(contentHash(content), file);
    if (!file.ends_with(".patch")) return hideText(file, content, isAnswer);
    hideText(file, afterPatch(content), isAnswer);
    hideText(file, beforePatch(content), isAnswer);
  }

  void hideText(const std::string& file, std::string_view text, bool isAnswer) {
    (isAnswer ? answers_ : others_).hide(file, text);
    if (isAnswer) answerLines_.hide(file, text);
  }

  Passages answers_{kAnswerLetters}, others_{kOtherLetters};
  QuotedLines answerLines_;
  std::map<std::string, std::string> copies_;  // content hash -> hidden file
};

// Folders whose names say something of this machine. Short ones, such as /root, are words too.
std::vector<std::string> machinePaths(const fs::path& project) {
  constexpr std::size_t kShortest = 6;
  std::vector<std::string> paths{project.string(), std::string(build::kProjectFolder),
                                 std::string(build::kBuildFolder)};
  if (const char* home = std::getenv("HOME")) paths.push_back(std::string(home) + "/");
  std::erase_if(paths, [](const std::string& p) { return p.size() < kShortest; });
  return paths;
}

std::ptrdiff_t lineAt(std::string_view content, std::size_t position) {
  return 1 +
         std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(position), '\n');
}

std::string withoutSpaces(std::string_view text) {
  std::string letters;
  std::copy_if(text.begin(), text.end(), std::back_inserter(letters),
               [](char c) { return c > ' '; });
  return letters;
}

// A part that is not released has all of its stubs, and one that is released has none. Somebody may
// have tried the coursework in student/.
void inspectStubs(const KitPlan& plan, const fs::path& folder, std::vector<std::string>& findings) {
  for (const FunctionContract& function : contract()) {
    const std::string file(partNumbered(function.part).file);
    const std::string stub =
        fmt::format("PATHMARK_UNIMPLEMENTED(\"{}\",\"{}\")", file, function.name);
    const std::string name = "student/" + file;
    if (!fs::is_regular_file(folder / name)) continue;
    const bool isStub = withoutSpaces(readFile(folder / name)).find(stub) != std::string::npos;
    const bool mustBe = function.part > plan.releasedThrough;
    if (isStub == mustBe) continue;
    findings.push_back(
        mustBe
            ? fmt::format("{} does not have the stub of {}; `git checkout student` brings it "
                          "back.",
                          name, function.name)
            : fmt::format("{} has the stub of {}, and its part is released.", name, function.name));
  }
}

}  // namespace

Inspection inspectKit(const KitPlan& plan, const fs::path& folder) {
  Inspection inspection;
  inspection.hiddenFiles = plan.answers.size() + plan.hidden.size();
  std::map<std::string, const KitFile*> expected;
  for (const KitFile& file : plan.files) expected[file.name] = &file;
  const HiddenFiles hidden(plan);
  const std::vector<std::string> machine = machinePaths(plan.project);

  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    if (entry.is_directory() && !entry.is_symlink()) continue;
    const auto file = expected.find(name);
    if (file == expected.end() || entry.is_symlink() || !entry.is_regular_file()) {
      inspection.findings.push_back(fmt::format("{} does not belong into a kit.", name));
      continue;
    }
    const std::string content = readFile(entry.path());
    ++inspection.files;
    inspection.bytes += content.size();
    if (const std::string why = whyNot(file->second->kind, content); !why.empty())
      inspection.findings.push_back(fmt::format("{} is {}.", name, why));
    hidden.search(name, content, inspection.findings);
    for (const std::string& path : machine)
      if (const std::size_t at = content.find(path); at != std::string::npos)
        inspection.findings.push_back(fmt::format("{}:{} names {}, a folder of this machine.", name,
                                                  lineAt(content, at), path));
    expected.erase(file);
  }
  for (const auto& [name, file] : expected)
    inspection.findings.push_back(fmt::format("{} is missing.", name));
  inspectStubs(plan, folder, inspection.findings);
  std::sort(inspection.findings.begin(), inspection.findings.end());
  return inspection;
}

}  // namespace pathmark::kit
