#include "host/part_compiler.h"

#include "host/build_cache.h"
#include "host/build_files.h"
#include "host/build_problems.h"
#include "host/compiler_words.h"
#include "host/content_hash.h"
#include "host/display_path.h"
#include "host/framework_names.h"
#include "host/object_file.h"
#include "host/workshop.h"

#include <fmt/format.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

const fs::path kContractSymbols = kProjectFolder / "framework/worker/contract.symbols";
const fs::path kPublicSymbols = kProjectFolder / "framework/worker/public.symbols";

constexpr std::uintmax_t kLargestSource = std::uintmax_t{1} << 20;
// That is taken out of a confinement; objectComplaint allows less, and says how much.
constexpr std::size_t kLargestFile = std::size_t{64} << 20;

std::optional<std::string> readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// The compiler, the flags and the headers that every coursework object depends on.
const std::string& toolchainStamp() {
  static const std::string all = [] {
    std::string text = fileStamp(build::kCompiler);
    for (const std::string_view flag : build::kCourseworkFlags) text.append(" ").append(flag);
    for (const auto& header : fs::directory_iterator(kProjectFolder / "framework/include/pathmark"))
      text += fileStamp(header.path());
    for (const fs::path& symbols : {kContractSymbols, kPublicSymbols}) text += fileStamp(symbols);
    return text;
  }();
  return all;
}

// Some editors save so; the compiler reads bytes, and calls every second one stray. Empty for what
// it can read.
std::string_view wideEncoding(std::string_view code) {
  using namespace std::string_view_literals;
  if (code.starts_with("\xff\xfe\0\0"sv) || code.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
  if (code.starts_with("\xff\xfe"sv) || code.starts_with("\xfe\xff"sv)) return "UTF-16";
  return {};
}

std::string folderPrefix(const fs::path& folder) {
  return fs::absolute(folder).lexically_normal().string() + "/";
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

// A compiler is several programs, and the first one says what became of the others.
bool saysThatItWasKilled(const std::string& output) {
  const std::string words = fs::path(build::kCompiler).filename().string() +
                            ": fatal error: Killed signal terminated program";
  return output.starts_with(words) || output.find("\n" + words) != std::string::npos;
}

// The machine kills what takes memory that others need. What takes too long by the clock is stopped
// here, and is the coursework's own doing.
void throwIfKilled(const ProcessResult& step, const fs::path& source) {
  constexpr int kKilled = 128 + SIGKILL;
  if (step.timedOut || (step.exitCode != kKilled && !saysThatItWasKilled(step.output))) return;
  throw std::system_error(std::make_error_code(std::errc::not_enough_memory),
                          fmt::format("the compiler of {} was killed", source.filename().string()));
}

// What is wrong with it, as objectComplaint says it, or with the names that it uses.
std::optional<std::string> complaintAbout(const fs::path& object) {
  if (std::optional<std::string> complaint = objectComplaint(object)) return complaint;
  const std::string bytes = readFile(object).value_or("");
  if (const auto name = hiddenNameUsedBy(std::as_bytes(std::span(bytes))))
    return fmt::format(
        "the coursework uses {}, which is the framework's own; it may use what the headers in "
        "framework/include/pathmark/ declare",
        *name);
  return std::nullopt;
}

// The object to its place in the build folder. Nothing is believed of what was made in a
// confinement; outside of one the same is refused, so that nobody learns of it from the marks.
bool keepObject(const fs::path& made, const fs::path& object, std::string& messages) {
  const ScratchFolder own(nullptr);
  const fs::path taken = own / "taken.o";
  const std::optional<std::string> complaint =
      takeFile(made, taken, kLargestFile) ? complaintAbout(taken)
                                          : "the compiler made no object file, or a very large one";
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
  throwIfKilled(compiled, source);
  if (!compiled.output.empty())
    messages = "\n" + shortCompilerWords(replaceAll(compiled.output, scratch.path().string() + "/",
                                                    folderPrefix(folder)));
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
    throwIfKilled(step, source);
    messages += step.output;
    return false;
  }
  keepWarnings(object, messages);
  return keepObject(merged, object, messages);
}

}  // namespace

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
  if (const std::string_view encoding = wideEncoding(*code); !encoding.empty()) {
    part.messages = fmt::format(" it is saved as {}; save it as UTF-8.", encoding);
    return;
  }
  const std::string key = contentHash(toolchainStamp() + Workshop(confinement).name() +
                                      folderPrefix(part.source.parent_path()) +
                                      part.source.filename().string() + "\n" + *code);
  const fs::path folder = kBuildFolder / "workers/objects";
  makeBuildFolder(folder);
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

}  // namespace pathmark
