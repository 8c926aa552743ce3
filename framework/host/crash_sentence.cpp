#include "host/crash_sentence.h"

#include "host/build_config.h"
#include "host/display_path.h"
#include "host/subprocess.h"
#include "host/system_call_name.h"

#include <fmt/format.h>

#include <csignal>
#include <sstream>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct Frame {
  std::string function, file, line;
};

// addr2line prints two lines for each frame, function and file:line; inlined calls come as frames
// of their own, innermost first.
std::vector<Frame> frames(const CrashRecord& record, const fs::path& program,
                          Confinement* confinement) {
  ProcessRequest request;
  const fs::path seen = confinement ? confinement->visible(program) : program;
  request.arguments = {std::string(build::kAddr2line), "-i", "-f", "-C", "-e", seen.string()};
  for (std::uint32_t k = 0; k < record.frameCount; ++k)
    request.arguments.push_back(fmt::format("{:#x}", record.frames[k] - 1));
  request.timeLimitSeconds = 20.0;
  std::istringstream lines(
      (confinement ? confinement->run({request, {}, {seen}}) : runProcess(request)).output);
  std::vector<Frame> found;
  for (std::string function, place; std::getline(lines, function) && std::getline(lines, place);) {
    const std::size_t colon = place.rfind(':');
    if (colon == std::string::npos) continue;
    std::string line = place.substr(colon + 1);
    line = line.substr(0, line.find(' '));
    found.push_back({function, place.substr(0, colon), line});
  }
  return found;
}

// "pathmark::LitScene::tracePath(pathmark::Ray const&, ...) const" -> "LitScene::tracePath".
std::string briefName(std::string function) {
  if (function.starts_with("_GLOBAL__sub_I") || function.starts_with("__static_initialization"))
    return "the initial value of a global variable";
  for (const std::string_view space : {"pathmark::", "(anonymous namespace)::"})
    while (function.rfind(space, 0) == 0) function.erase(0, space.size());
  const std::string name = function.substr(0, function.find('('));
  return name.ends_with("operator") ? name + "()" : name;
}

// What an exception says comes from coursework: control characters would reach the terminal.
std::string printable(std::string_view text) {
  std::string clean(text.substr(0, 200));
  for (char& c : clean)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return clean;
}

std::string forbiddenCall(int systemCall, const std::string& path) {
  return fmt::format(
      "a forbidden system call, {}{}; coursework computes: it opens no files, makes no connections "
      "and no processes, and leaves the program's signals and limits alone.",
      systemCallName(systemCall), path.empty() ? "" : fmt::format(" of \"{}\"", path));
}

std::string memoryRanOut(std::size_t bytes) {
  // Sanitizers have no limit: see worker_launch.cpp.
  const std::string allowed =
      build::kSanitized ? std::string() : fmt::format(", allowed are {} MiB", bytes >> 20);
  return fmt::format("memory ran out (std::bad_alloc){}; does an array grow without end?", allowed);
}

std::string whatHappened(const CrashRecord& record, std::size_t memoryBytes) {
  switch (record.kind) {
    case CrashKind::kStackOverflow:
      return "stack overflow; is there a recursion that never ends?";
    case CrashKind::kException:
      if (std::string_view(record.text).starts_with("std::bad_alloc"))
        return memoryRanOut(memoryBytes);
      return fmt::format("an exception that nobody caught, {}.", printable(record.text));
    case CrashKind::kForbiddenCall:
      return forbiddenCall(record.systemCall, printable(record.text));
    case CrashKind::kExit:
      return "exit() was called; coursework functions return, and never end the program.";
    default:
      return signalName(record.signal) + ".";
  }
}

}  // namespace

std::string signalName(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "a segmentation fault (SIGSEGV): memory that does not belong to the program was used";
    case SIGBUS:
      return "a bus error (SIGBUS): memory that does not exist was used";
    case SIGFPE:
      return "an arithmetic error (SIGFPE), such as an integer divided by zero";
    case SIGILL:
      return "an illegal instruction (SIGILL); does a function end without a return statement?";
    case SIGABRT:
      return "abort (SIGABRT), as by a failed assertion";
    case SIGTRAP:
      return "a trap (SIGTRAP)";
    case SIGSYS:
      return "the sandbox (SIGSYS): a forbidden system call was made";
    case SIGXCPU:
      return "the sandbox (SIGXCPU): all its computing time was used up";
    case SIGKILL:
      return "the operating system (SIGKILL), which may have been short of memory";
    default:
      return fmt::format("signal {}", signal);
  }
}

std::string crashPlace(const CrashRecord& record, const fs::path& program,
                       const fs::path& courseworkFolder, Confinement* confinement) {
  constexpr int kMostCallers = 3;
  const fs::path folder = fs::absolute(courseworkFolder).lexically_normal();
  std::string place, last;
  fs::path lastFile;
  int shown = 0;
  for (const Frame& frame : frames(record, program, confinement)) {
    const fs::path file = fs::path(frame.file).lexically_normal();
    const fs::path inside = file.lexically_relative(folder);
    if (inside.empty() || *inside.begin() == "..") continue;
    const std::string name = briefName(frame.function);
    if (place.empty()) {
      place = fmt::format("{}:{}, in {}", displayPath(file), frame.line, name);
    } else if (name != last && shown++ < kMostCallers) {
      const std::string where = file == lastFile ? "" : displayPath(file) + ", ";
      place += fmt::format(", called from {} ({}line {})", name, where, frame.line);
    }
    last = name;
    lastFile = file;
  }
  return place;
}

std::string crashSentence(const CrashRecord& record, const fs::path& program,
                          const fs::path& courseworkFolder, std::size_t memoryBytes,
                          Confinement* confinement) {
  const std::string place = crashPlace(record, program, courseworkFolder, confinement);
  return fmt::format("{}: {}", place.empty() ? "The coursework crashed" : place,
                     whatHappened(record, memoryBytes));
}

}  // namespace pathmark
