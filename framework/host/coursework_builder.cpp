#include "host/coursework_builder.h"

#include "host/build_files.h"
#include "host/build_problems.h"
#include "host/display_path.h"
#include "host/lab.h"
#include "host/part_compiler.h"
#include "host/worker_linker.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <utility>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// A file that a lab does not have is that of the coursework that the lab belongs to.
fs::path sourceOf(const fs::path& folder, std::string_view file) {
  fs::path own = folder / file;
  if (fs::exists(own) || !isLab(folder)) return own;
  return labOwner(folder) / file;
}

void buildParts(std::vector<PartBuild>& parts, const std::shared_ptr<Confinement>& confinement,
                unsigned compilersAtMost) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = 0; (i = next++) < parts.size();) buildPart(parts[i], confinement);
  };
  // Futures, because they carry an exception over: the build folder may be full or not writable.
  std::vector<std::future<void>> others;
  const unsigned compilers =
      compilersAtMost == kOnePerProcessor ? std::thread::hardware_concurrency() : compilersAtMost;
  const unsigned extra = std::max(1u, compilers) - 1;
  for (unsigned k = 0; k < extra; ++k) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
}

void link(CourseworkBuild& result, Incomplete policy) {
  LinkInputs inputs = linkInputs(result.confinement);
  for (const PartBuild& part : result.parts) addObject(inputs, part);
  if (!result.complete()) inputs.linking = Linking::kLenient;
  fs::path folder = linkedFolder(inputs);
  result.linkMessages = linkInto(folder, inputs);
  if (!result.linkMessages.empty()) {
    if (policy == Incomplete::kNoWorker) return;
    // In a place of its own: the next request for a whole worker must fail again.
    folder = linkedFolder(inputs, "partial");
    inputs.linking = Linking::kLenient;
    if (!linkInto(folder, inputs).empty()) return;
  }
  result.worker = folder / "worker";
}

LinkedWorker linked(const LinkInputs& inputs, const fs::path& coursework,
                    std::string_view kind = {}) {
  const fs::path folder = linkedFolder(inputs, kind);
  const std::string messages = linkInto(folder, inputs);
  if (messages.empty()) return {folder / "worker", {}};
  return {{}, linkFailure(coursework, messages)};
}

}  // namespace

bool CourseworkBuild::complete() const {
  return std::all_of(parts.begin(), parts.end(), [](const PartBuild& p) { return p.compiled; });
}

CourseworkBuild buildCoursework(const fs::path& folder, Incomplete policy,
                                std::shared_ptr<Confinement> confinement,
                                unsigned compilersAtMost) {
  CourseworkBuild result;
  result.folder = folder;
  result.confinement = std::move(confinement);
  for (const PartContract& part : parts())
    result.parts.push_back({part, sourceOf(folder, part.file), {}, {}, {}});
  buildParts(result.parts, result.confinement, compilersAtMost);
  if (policy == Incomplete::kLeaveThemOut || (policy == Incomplete::kNoWorker && result.complete()))
    link(result, policy);
  return result;
}

PartBuild compilePart(const fs::path& folder, int part) {
  const PartContract& contract = partNumbered(part);
  PartBuild build{contract, sourceOf(folder, contract.file), {}, {}, {}};
  buildPart(build, nullptr);
  return build;
}

LinkedWorker linkWithStandIns(const CourseworkBuild& build, std::span<const int> parts) {
  LinkInputs inputs = linkInputs(build.confinement);
  const std::vector<std::string> standIns = standInObjects();
  for (const PartBuild& part : build.parts) {
    if (std::find(parts.begin(), parts.end(), part.part.part) != parts.end())
      addObject(inputs, part);
    else
      inputs.framework.push_back(standIns.at(placeOfPart(part.part.part)));
  }
  return linked(inputs, build.folder);
}

LinkedWorker linkWithOthers(const CourseworkBuild& build, std::span<const int> parts,
                            const CourseworkBuild& others) {
  LinkInputs inputs = linkInputs(build.confinement);
  for (const PartBuild& part : build.parts) {
    const bool own = std::find(parts.begin(), parts.end(), part.part.part) != parts.end();
    const CourseworkBuild& from = own ? build : others;
    const PartBuild& chosen = from.parts.at(placeOfPart(part.part.part));
    if (!chosen.compiled)
      return {{}, fmt::format("{} {}.", displayPath(chosen.source), chosen.problem())};
    addObject(inputs, chosen);
  }
  return linked(inputs, build.folder);
}

LinkedWorker linkForRecording(const CourseworkBuild& build) {
  if (!build.complete()) return {{}, build.failure()};
  LinkInputs inputs = linkInputs(build.confinement, Linking::kRecording);
  for (std::string& object : readLines(kBuildFolder / "recorder_objects.txt"))
    inputs.framework.push_back(std::move(object));
  for (const PartBuild& part : build.parts) addObject(inputs, part);
  return linked(inputs, build.folder, fileStamp(kRecordedSymbols));
}

fs::path courseworkFolder(const std::string& with) {
  if (with == "student" || with == "solutions") return kProjectFolder / with;
  return with;
}

}  // namespace pathmark
