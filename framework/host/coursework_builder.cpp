#include "host/coursework_builder.h"

#include "host/build_cache.h"
#include "host/build_config.h"
#include "host/content_hash.h"
#include "host/display_path.h"
#include "host/lab.h"
#include "host/object_file.h"
#include "host/workshop.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <future>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

const fs::path kBuildFolder{build::kBuildFolder};
const fs::path kProjectFolder{build::kProjectFolder};

const fs::path kContractSymbols = kProjectFolder / "framework/worker/contract.symbols",
               kRecordedSymbols = kProjectFolder / "framework/worker/recorded.symbols";

constexpr std::uintmax_t kLargestSource = std::uintmax_t{1} << 20;
constexpr std::size_t kLargestObject = std::size_t{64} << 20,
                      kLargestProgram = std::size_t{256} << 20;

std::optional<std::string> readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::vector<std::string> readLines(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

// Changes when a file is written anew, without reading it.
std::string stamp(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  return fmt::format("{} {} {}\n", file.string(), time, fs::file_size(file, error));
}

// The compiler, the flags and the headers that every coursework object depends on.
const std::string& toolchainStamp() {
  static const std::string all = [] {
    std::string text = stamp(build::kCompiler);
    for (const std::string_view flag : build::kCourseworkFlags) text.append(" ").append(flag);
    for (const auto& header : fs::directory_iterator(kProjectFolder / "framework/include/pathmark"))
      text += stamp(header.path());
    text += stamp(kContractSymbols);
    return text;
  }();
  return all;
}

// What helps where a file of a folder cannot be had. Of student/ itself it would say nothing.
std::string_view whatAFolderHolds(const fs::path& folder) {
  std::error_code ignored;
  return fs::equivalent(folder, kProjectFolder / "student", ignored)
             ? ""
             : "; a coursework folder holds the same files as student/";
}

std::string folderPrefix(const fs::path& folder) {
  return fs::absolute(folder).lexically_normal().string() + "/";
}

// A file that a lab does not have is that of the coursework that the lab belongs to.
fs::path sourceOf(const fs::path& folder, std::string_view file) {
  fs::path own = folder / file;
  if (fs::exists(own) || !isLab(folder)) return own;
  return labOwner(folder) / file;
}

std::string replaceAll(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

fs::path warningsOf(fs::path object) { return object.replace_extension(".warnings"); }

void keepWarnings(const fs::path& object, const std::string& warnings) {
  if (warnings.empty()) return;
  const ScratchFolder own(nullptr);
  const fs::path written = own / "warnings";
  std::ofstream(written, std::ios::binary) << warnings;
  fs::rename(written, warningsOf(object));
}

std::vector<std::string> compileCommand(Workshop& workshop, const fs::path& source,
                                        const fs::path& object, const std::string& prefixMap) {
  std::vector<std::string> command{std::string(build::kCompiler)};
  for (const std::string_view flag : build::kCourseworkFlags)
    command.push_back(workshop.visibleFlag(flag));
  for (const fs::path& include :
       {kBuildFolder / "precompiled", kProjectFolder / "framework/include"})
    command.push_back("-I" + workshop.visible(include));
  for (std::string& map : workshop.prefixMaps()) command.push_back(std::move(map));
  for (const std::string& argument : {"-ffile-prefix-map=" + prefixMap, std::string("-c"),
                                      source.string(), std::string("-o"), object.string()})
    command.push_back(argument);
  return command;
}

// The object to its place in the build folder. Nothing is believed of what was made in a
// confinement.
bool keepObject(const Workshop& workshop, const fs::path& made, const fs::path& object,
                std::string& messages) {
  if (!workshop.confinement()) {
    fs::rename(made, object);
    return true;
  }
  const ScratchFolder own(nullptr);
  const fs::path taken = own / "taken.o";
  const std::optional<std::string> complaint = takeFile(made, taken, kLargestObject)
                                                   ? objectComplaint(taken)
                                                   : "the compiler made no object file, or a very "
                                                     "large one";
  if (complaint) {
    messages += fmt::format(" {}.\n", *complaint);
    return false;
  }
  fs::rename(taken, object);
  return true;
}

// Compiles a copy that is alone in its folder, so that no other file can be included, to an object
// in which only the names of the contract are visible: a helper function with the name of another
// part's helper, or of a library function, replaces nothing. What the compiler says of the copy is
// said of the file that people know, by its whole path.
bool compileObject(const std::shared_ptr<Confinement>& confinement, const std::string& code,
                   const fs::path& source, const fs::path& object, std::string& messages) {
  const ScratchFolder scratch(confinement.get());
  Workshop workshop(confinement);
  const fs::path copy = scratch / source.filename(), raw = scratch / "raw.o",
                 merged = scratch / "merged.o";
  std::ofstream(copy, std::ios::binary) << code;
  const fs::path folder = source.parent_path();
  const ProcessResult compiled = workshop.run(
      compileCommand(workshop, copy, raw, scratch.path().string() + "/=" + folderPrefix(folder)),
      scratch);
  if (!compiled.output.empty())
    messages =
        "\n" + replaceAll(compiled.output, scratch.path().string() + "/", folderPrefix(folder));
  if (compiled.timedOut)
    messages += fmt::format("The compiler was stopped after {:g} s.\n", compiled.timeLimitSeconds);
  if (compiled.exitCode != 0) return false;

  // Groups of inline functions are dissolved first: a hidden function must not be one half of a
  // group that the linker drops in favour of another object's.
  Workshop tools(confinement);
  ProcessResult step = tools.run({std::string(build::kLd), "-r", "--force-group-allocation", "-o",
                                  merged.string(), raw.string()},
                                 scratch);
  if (step.exitCode == 0)
    step = tools.run({std::string(build::kObjcopy),
                      "--keep-global-symbols=" + tools.visible(kContractSymbols), merged.string()},
                     scratch);
  if (step.exitCode != 0) {
    messages += step.output;
    return false;
  }
  keepWarnings(object, messages);
  return keepObject(tools, merged, object, messages);
}

std::vector<std::string> standInObjects() {
  return readLines(kBuildFolder / "standin_objects.txt");
}

void buildPart(PartBuild& part, const std::shared_ptr<Confinement>& confinement) {
  std::error_code error;
  if (part.part.bonus && !fs::exists(part.source, error)) {
    part.object = standInObjects().at(placeOfPart(part.part.part));
    part.absent = part.compiled = true;
    return;
  }
  if (fs::file_size(part.source, error) > kLargestSource && !error) {
    part.messages = " it is larger than 1 MiB, and coursework files have a few kilobytes.";
    return;
  }
  const std::optional<std::string> code = readFile(part.source);
  if (!code) {
    part.missing = !fs::exists(part.source, error);
    part.messages = fmt::format(" it {}{}.", part.missing ? "is missing" : "cannot be read",
                                whatAFolderHolds(part.source.parent_path()));
    return;
  }
  const std::string key = contentHash(toolchainStamp() + Workshop(confinement).name() +
                                      folderPrefix(part.source.parent_path()) +
                                      part.source.filename().string() + "\n" + *code);
  const fs::path folder = kBuildFolder / "workers/objects";
  fs::create_directories(folder);
  const fs::path made = folder / (key + ".o");
  if (fs::exists(made)) {
    markUsed(made);
    part.messages = readFile(warningsOf(made)).value_or("");
    part.compiled = true;
  } else {
    part.compiled = compileObject(confinement, *code, part.source, made, part.messages);
  }
  markUsed(warningsOf(made));  // the later of the two, so that the object is the first to go
  const fs::path sources = part.source.parent_path();
  part.messages = replaceAll(part.messages, folderPrefix(sources), displayPath(sources) + "/");
  if (part.compiled) part.object = made;
}

void buildParts(std::vector<PartBuild>& parts, const std::shared_ptr<Confinement>& confinement) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = 0; (i = next++) < parts.size();) buildPart(parts[i], confinement);
  };
  // Futures, because they carry an exception over: the build folder may be full or not writable.
  std::vector<std::future<void>> others;
  const unsigned extra = std::max(1u, std::thread::hardware_concurrency()) - 1;
  for (unsigned k = 0; k < extra; ++k) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
}

enum class Linking {
  kStrict,
  kLenient,    // functions that are nowhere defined get the address zero
  kRecording,  // calls of some functions are led to those that record them
};

// What a worker is made of.
struct LinkInputs {
  std::vector<std::string> framework;  // objects
  std::vector<fs::path> coursework;    // objects; those of parts that do not compile are empty
  Linking linking = Linking::kStrict;
  std::shared_ptr<Confinement> confinement;
};

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

void addObject(LinkInputs& inputs, const PartBuild& part) {
  if (part.absent)
    inputs.framework.push_back(part.object.string());
  else
    inputs.coursework.push_back(part.object);
}

// The place of a worker that is made of these.
fs::path linkedFolder(const LinkInputs& from, std::string_view kind = {}) {
  std::string inputs;
  for (const std::string& object : from.framework) inputs += stamp(object);
  for (const fs::path& object : from.coursework) inputs += object.filename().string() + "\n";
  inputs += Workshop(from.confinement).name();
  return kBuildFolder / "workers/linked" / contentHash(inputs.append(kind));
}

// Returns the linker's words, if it fails.
std::string linkInto(const fs::path& folder, const LinkInputs& inputs) {
  if (fs::exists(folder / "worker")) {
    markUsed(folder);
    return {};
  }
  const ScratchFolder scratch(inputs.confinement.get());
  Workshop workshop(inputs.confinement);
  const fs::path made = scratch / "worker";
  const ProcessResult linked = runLinker(workshop, scratch, inputs, made);
  if (linked.exitCode != 0) return linked.output.empty() ? "The linker failed.\n" : linked.output;
  fs::create_directories(folder);
  if (!inputs.confinement)
    fs::rename(made, folder / "worker");
  else if (!takeFile(made, folder / "worker", kLargestProgram))
    return "The linker made no program, or a very large one.\n";
  pruneCache(kBuildFolder / "workers/linked");
  pruneCache(kBuildFolder / "workers/objects");
  return {};
}

std::vector<std::string> frameworkObjects() {
  return readLines(kBuildFolder / "worker_objects.txt");
}

void link(CourseworkBuild& result, Incomplete policy) {
  LinkInputs inputs{frameworkObjects(), {}, Linking::kStrict, result.confinement};
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

// The functions of the contract that the linker has not found anywhere. A class's table comes with
// its first function.
std::vector<std::string_view> undefinedFunctions(const std::string& linkMessages) {
  const auto says = [&](const std::string& words) {
    return linkMessages.find("undefined symbol: " + words) != std::string::npos ||
           linkMessages.find("undefined reference to `" + words) != std::string::npos;
  };
  std::vector<std::string_view> names;
  for (const FunctionContract& f : contract()) {
    const std::string name(f.name), owner = name.substr(0, name.find("::"));
    const bool first = f.name.ends_with("BRDF::brdf");
    if (says("pathmark::" + name + "(") || (first && says("vtable for pathmark::" + owner)))
      names.push_back(f.name);
  }
  return names;
}

std::string linkFailure(const fs::path& folder, const std::string& messages) {
  const std::vector<std::string_view> undefined = undefinedFunctions(messages);
  if (undefined.empty()) return fmt::format("{} does not link:\n{}", displayPath(folder), messages);
  return fmt::format(
      "{} defines no {} with the parameters that the header declares; is a name or a type "
      "different, or \"const\" missing?\n",
      displayPath(folder), fmt::join(undefined, ", "));
}

}  // namespace

std::string_view PartBuild::problem() const { return missing ? "is missing" : "does not compile"; }

std::string PartBuild::failure() const {
  if (missing)
    return fmt::format("{} is missing{}.", displayPath(source),
                       whatAFolderHolds(source.parent_path()));
  return fmt::format("{} does not compile:{}", displayPath(source), messages);
}

std::string_view PartBuild::warnings() const {
  return compiled ? std::string_view(messages) : std::string_view();
}

bool CourseworkBuild::complete() const {
  return std::all_of(parts.begin(), parts.end(), [](const PartBuild& p) { return p.compiled; });
}

std::string CourseworkBuild::failure() const {
  std::string text;
  for (const PartBuild& p : parts)
    if (!p.compiled) text += p.failure() + "\n";
  if (!linkMessages.empty()) text += linkFailure(folder, linkMessages);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

CourseworkBuild buildCoursework(const fs::path& folder, Incomplete policy,
                                std::shared_ptr<Confinement> confinement) {
  CourseworkBuild result;
  result.folder = folder;
  result.confinement = std::move(confinement);
  for (const PartContract& part : parts())
    result.parts.push_back({part, sourceOf(folder, part.file), {}, {}, {}});
  buildParts(result.parts, result.confinement);
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
  LinkInputs inputs{frameworkObjects(), {}, Linking::kStrict, build.confinement};
  const std::vector<std::string> standIns = standInObjects();
  for (const PartBuild& part : build.parts) {
    if (std::find(parts.begin(), parts.end(), part.part.part) != parts.end())
      addObject(inputs, part);
    else
      inputs.framework.push_back(standIns.at(placeOfPart(part.part.part)));
  }
  const fs::path folder = linkedFolder(inputs);
  const std::string messages = linkInto(folder, inputs);
  if (messages.empty()) return {folder / "worker", {}};
  return {{}, linkFailure(build.folder, messages)};
}

LinkedWorker linkWithOthers(const CourseworkBuild& build, std::span<const int> parts,
                            const CourseworkBuild& others) {
  LinkInputs inputs{frameworkObjects(), {}, Linking::kStrict, build.confinement};
  for (const PartBuild& part : build.parts) {
    const bool own = std::find(parts.begin(), parts.end(), part.part.part) != parts.end();
    const CourseworkBuild& from = own ? build : others;
    const PartBuild& chosen = from.parts.at(placeOfPart(part.part.part));
    if (!chosen.compiled)
      return {{}, fmt::format("{} {}.", displayPath(chosen.source), chosen.problem())};
    addObject(inputs, chosen);
  }
  const fs::path folder = linkedFolder(inputs);
  const std::string messages = linkInto(folder, inputs);
  if (messages.empty()) return {folder / "worker", {}};
  return {{}, linkFailure(build.folder, messages)};
}

LinkedWorker linkForRecording(const CourseworkBuild& build) {
  if (!build.complete()) return {{}, build.failure()};
  LinkInputs inputs{frameworkObjects(), {}, Linking::kRecording, build.confinement};
  for (std::string& object : readLines(kBuildFolder / "recorder_objects.txt"))
    inputs.framework.push_back(std::move(object));
  for (const PartBuild& part : build.parts) addObject(inputs, part);
  const fs::path folder = linkedFolder(inputs, stamp(kRecordedSymbols));
  const std::string messages = linkInto(folder, inputs);
  if (messages.empty()) return {folder / "worker", {}};
  return {{}, linkFailure(build.folder, messages)};
}

fs::path courseworkFolder(const std::string& with) {
  if (with == "student" || with == "solutions") return kProjectFolder / with;
  return with;
}

}  // namespace pathmark
