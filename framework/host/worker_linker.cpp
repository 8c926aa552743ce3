#include "host/worker_linker.h"

#include "host/build_cache.h"
#include "host/build_files.h"
#include "host/content_hash.h"
#include "host/object_file.h"
#include "host/workshop.h"

namespace pathmark {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestProgram = std::size_t{64} << 20;

std::vector<std::string> linkerOptions(Linking linking) {
  // Works only in a program that is not moved, and with the system's own linker.
  if (linking == Linking::kLenient) return {"-no-pie", "-Wl,--unresolved-symbols=ignore-all"};
  std::vector<std::string> options;
  if (!build::kLinkerFlag.empty()) options.emplace_back(build::kLinkerFlag);
  if (linking == Linking::kRecording)
    for (const std::string& symbol : readLines(kRecordedSymbols))
      options.push_back("-Wl,--wrap=" + symbol);
  return options;
}

ProcessResult runLinker(Workshop& workshop, const ScratchFolder& scratch, const LinkInputs& inputs,
                        const fs::path& program) {
  std::vector<std::string> command{std::string(build::kCompiler)};
  for (const std::string_view flag : build::kCourseworkFlags) command.emplace_back(flag);
  for (std::string& option : linkerOptions(inputs.linking)) command.push_back(std::move(option));
  command.emplace_back("-pthread");
  command.emplace_back("-o");
  command.push_back(program.string());
  for (const std::string& object : inputs.framework) command.push_back(workshop.visible(object));
  for (const fs::path& object : inputs.coursework)
    if (!object.empty()) command.push_back(workshop.visible(object));
  command.emplace_back(build::kEmbree);
  return workshop.run(std::move(command), scratch);
}

// A run that goes on for hours compiles the solutions once, and links them with each submission.
void markObjectsUsed(const LinkInputs& inputs) {
  for (const fs::path& object : inputs.coursework) {
    if (object.empty()) continue;
    markUsed(object);
    // The later of the two, so that the object is the first to go.
    markUsed(fs::path(object).replace_extension(".warnings"));
  }
}

}  // namespace

void addObject(LinkInputs& inputs, const PartBuild& part) {
  if (part.absent)
    inputs.framework.push_back(part.object.string());
  else
    inputs.coursework.push_back(part.object);
}

LinkInputs linkInputs(const std::shared_ptr<Confinement>& confinement, Linking linking) {
  return {readLines(kBuildFolder / "worker_objects.txt"), {}, linking, confinement};
}

fs::path linkedFolder(const LinkInputs& from, std::string_view kind) {
  std::string inputs;
  for (const std::string& object : from.framework) inputs += fileStamp(object);
  for (const fs::path& object : from.coursework) inputs += object.filename().string() + "\n";
  inputs += Workshop(from.confinement).name();
  return kBuildFolder / "workers/linked" / contentHash(inputs.append(kind));
}

std::string linkInto(const fs::path& folder, const LinkInputs& inputs) {
  markObjectsUsed(inputs);
  if (fs::exists(folder / "worker")) {
    markUsed(folder);
    return {};
  }
  const ScratchFolder scratch(inputs.confinement.get());
  Workshop workshop(inputs.confinement);
  const fs::path made = scratch / "worker";
  const ProcessResult linked = runLinker(workshop, scratch, inputs, made);
  if (linked.exitCode != 0) return linked.output.empty() ? "The linker failed.\n" : linked.output;
  makeBuildFolder(folder);
  if (!inputs.confinement)
    fs::rename(made, folder / "worker");
  else if (!takeFile(made, folder / "worker", kLargestProgram))
    return "The linker made no program, or a very large one.\n";
  pruneCache(kBuildFolder / "workers/linked");
  pruneCache(kBuildFolder / "workers/objects");
  return {};
}

}  // namespace pathmark
